#pragma once

#include <functional>
#include <span>
#include <vector>

#include "toccata/math/pose.hpp"
#include "toccata/math/vec3.hpp"
#include "toccata/query/casts.hpp"
#include "toccata/query/model.hpp"
#include "toccata/query/pair_query.hpp"

namespace toccata {

/// A turn and a shift at even speeds. At the part s of it, from 0 to 1, a world point w is at
///
///     centre + R(axis, s · turns) · (w − centre) + s · translation
///
/// over the real numbers, where R turns counter-clockwise about the direction axis / |axis|, and 1 is a whole turn.
/// With a translation along the axis it is a screw; without a turn it is a straight way.
struct RigidMove {
  Vec3 centre{};
  Vec3 axis{0, 0, 1};  ///< of any length above 0; not looked at without a turn
  double turns = 0;
  Vec3 translation{};
  friend constexpr bool operator==(const RigidMove&, const RigidMove&) = default;
};

/// Where a shape is at a time from 0 to 1.
struct MotionKey {
  double time = 0;
  Pose pose{};
};

/// What a motion that is given by a function never exceeds, in the time from 0 to 1.
struct MotionSpeed {
  Vec3 centre{};     ///< a point of the shape's own frame
  double speed = 0;  ///< how fast that point moves, in world units
  double turns = 0;  ///< how fast the shape turns about it, in whole turns
  /// How far off, in world units, points of the shape may be from where so slow a motion brings them, because the
  /// function rounds more than the last bits of what it returns.
  double rounding = 0;
};

/// How a shape moves, without changing its form, in the time from 0 to 1. What is in the world at the time 0 is the
/// shape under its first pose, its vertices rounded as always; from there every point moves by a RigidMove over the
/// real numbers (docs/truth.md, "Bodies that move"). So the first pose may be any that the shape may have, also one
/// that scales. Where the shape ends follows: `at(1)`.
class RigidMotion {
 public:
  /// One move, and what it starts from.
  struct Piece {
    double begin = 0;  ///< times
    double end = 1;
    Pose start{};
    RigidMove move{};
  };

  /// A shape that rests. Implicit: whatever takes a motion takes a pose.
  RigidMotion(const Pose& pose);

  /// Throws Error when a number is not finite, or an axis of a turn has no direction.
  RigidMotion(const Pose& start, const RigidMove& move);

  /// A motion straight on, without a turn.
  [[nodiscard]] static RigidMotion straight(const Pose& start, const Vec3& translation);

  /// A motion from one pose to another: the point `centre` of the shape's own frame goes straight on, and the shape
  /// turns about it the shorter way at an even speed (linear interpolation and slerp). It ends at `end` but for
  /// rounding: by some 2⁻⁴⁸ of the size where both poses are rotations. Throws Error when no turn leads from one to the
  /// other, as where one scales and the other does not.
  [[nodiscard]] static RigidMotion between(const Pose& start, const Pose& end, const Vec3& centre = {});

  /// A motion from one pose to another about one axis and along it: every point on a helix (M. Chasles, 1830). Throws
  /// like `between`.
  [[nodiscard]] static RigidMotion screw(const Pose& start, const Pose& end);

  /// A motion through poses, as `between` leads from each to the next. Throws Error when there are fewer than two, or
  /// the times are not ascending from 0 to 1, and like `between`.
  [[nodiscard]] static RigidMotion through(std::span<const MotionKey> keys, const Vec3& centre = {});

  /// The motion that these pieces are, one after the other (`pieces`). Each has to go on from where the one before it
  /// ends, but for rounding, which is not looked at. Throws Error where their times do not lead from 0 to 1, one
  /// beginning when the one before ends, and like the constructors.
  [[nodiscard]] static RigidMotion of_pieces(std::vector<Piece> pieces);

  /// Any motion: where the shape is, given by a function of the time, and a bound on how fast it moves. At the times at
  /// which the function is asked the shape is where its pose puts it, and in between its points move as the bound
  /// allows; what is answered is true of all such motions. Throws Error when a bound is negative or not finite. The
  /// function is asked when a question is, from any of its threads, and has to return the same for the same time.
  [[nodiscard]] static RigidMotion of(std::function<Pose(double)> pose_at, const MotionSpeed& bound);

  /// How something moves that is fixed to the shape: placed by a pose in its frame, which may scale it. Throws Error
  /// when the pose is not finite, and for a motion that is given by a function when it is singular.
  [[nodiscard]] RigidMotion carrying(const Pose& fixed) const;

  /// The pose at a time, rounded; at 0 it is the first pose. A vertex that it poses is off from where it is by no more
  /// than (1 + pieces before) · (128 + 64 |turns|) · 2⁻⁵³ · (size + |centre| + |translation|), which all answers
  /// allow for. Throws Error for a time outside of [0, 1], and when a pose that the function returned is not finite.
  [[nodiscard]] Pose at(double time) const;

  // For the library itself.

  /// The pieces in the order of time; a motion that is given by a function has none.
  [[nodiscard]] std::span<const Piece> pieces() const { return pieces_; }
  /// The bound on the speed of a motion that is given by a function.
  [[nodiscard]] const MotionSpeed& speed() const { return speed_; }

 private:
  RigidMotion() = default;

  std::vector<Piece> pieces_;
  std::function<Pose(double)> pose_at_;
  MotionSpeed speed_;
};

/// How a question about two models that move is asked.
struct SweepQuery {
  Solid solid_a = Solid::automatic;
  Solid solid_b = Solid::automatic;
  /// How near they may come, in world units: what is looked for is when they come as near as that. Negative: how deep
  /// two elements may be in each other, as what stands on a floor and walks. What is looked for is then when the
  /// shortest way to part two elements is longer; of meshes these are triangles, so that one within another counts when
  /// it comes to the surface. 0: the first common point.
  double stop_before = 0;
};

/// The first meeting of two models that move and turn; the times are those of the motions, from 0 to 1. None where at
/// no real time in [0, 1] have they a point in common, which is proved. A hit has one of three statuses:
///
///   exact      nothing is met before `lower`, and at `upper` or before they have a point in common; both are proved
///   undecided  nothing is met before `lower`, when they come as near as can be told of poses that turn, some 10⁻¹³ of
///              their sizes, at worst 10⁻⁸; whether they touch or pass is not told, and `upper` is `lower`
///   not_converged  nothing is met before `lower`, and of what comes then nothing is known: two convex shapes that turn
///              often, or very close, beside each other, so that 65,536 steps did not tell
///
/// What does not turn is answered by `cast_shape`. For meshes, height fields and compounds it is the earliest of their
/// elements, by (upper, element of A, element of B); models that meet at the start are met at 0, as `cast_shape` has
/// it, and those that are then as near as `stop_before` with the two elements that `distance` names. The normal is from
/// B to A. Two half-spaces are not asked about, as in `cast_shape`. Throws Error for what `overlap` throws for at the
/// poses of the start, when `stop_before` is not finite, for what the table of pairs.hpp does not define of casts, and
/// when a motion that is given by a function moved faster than its bound.
[[nodiscard]] std::optional<ShapeHit> sweep(const Model& a, const RigidMotion& motion_a, const Model& b,
                                            const RigidMotion& motion_b, const SweepQuery& query = {});

/// The same, for a caller who asks often.
[[nodiscard]] std::optional<ShapeHit> sweep(const Model& a, const RigidMotion& motion_a, const Model& b,
                                            const RigidMotion& motion_b, const SweepQuery& query, Workspace& workspace);

/// Make a Model of it, once: `Model(mesh)`.
template <class A, class B>
requires NeedAModel<A, B> std::optional<ShapeHit> sweep(const A&, const RigidMotion&, const B&, const RigidMotion&,
                                                        const SweepQuery& = {})
= delete;

}  // namespace toccata
