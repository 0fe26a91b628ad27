#pragma once

#include <functional>
#include <span>
#include <vector>

#include "toccata/math/pose.hpp"
#include "toccata/math/vec3.hpp"

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

/// What a motion that is told by a function never exceeds, in the time from 0 to 1.
struct MotionSpeed {
  Vec3 centre{};     ///< a point of the shape's own frame
  double speed = 0;  ///< of that point, in world units
  double turns = 0;  ///< how fast the shape turns about it, in whole turns
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

  /// It rests. Implicit: whatever takes a motion takes a pose.
  RigidMotion(const Pose& pose);

  /// Throws Error when a number is not finite, or an axis of a turn has no direction.
  RigidMotion(const Pose& start, const RigidMove& move);

  /// Straight on, without a turn.
  [[nodiscard]] static RigidMotion straight(const Pose& start, const Vec3& translation);

  /// From one pose to another: the point `centre` of the shape's own frame goes straight on, and the shape turns about
  /// it the shorter way at an even speed (linear interpolation and slerp). It ends at `end` but for rounding: by some
  /// 2⁻⁴⁸ of the size where both poses are rotations. Throws Error when no turn leads from one to the other, as where
  /// one scales and the other does not.
  [[nodiscard]] static RigidMotion between(const Pose& start, const Pose& end, const Vec3& centre = {});

  /// From one pose to another about one axis and along it: every point on a helix (M. Chasles, 1830). Throws like
  /// `between`.
  [[nodiscard]] static RigidMotion screw(const Pose& start, const Pose& end);

  /// Through poses, as `between` each and the next. Throws Error when there are fewer than two, or the times are not
  /// ascending from 0 to 1, and like `between`.
  [[nodiscard]] static RigidMotion through(std::span<const MotionKey> keys, const Vec3& centre = {});

  /// Any motion: where the shape is, told by a function of the time, and a bound on how fast it moves. At the times at
  /// which the function is asked the shape is where its pose puts it, and in between its points move as the bound
  /// allows; what is answered is true of all such motions. Throws Error when a bound is negative or not finite. The
  /// function is asked when a question is, from its thread, and has to return the same for the same time.
  [[nodiscard]] static RigidMotion of(std::function<Pose(double)> pose_at, const MotionSpeed& bound);

  /// How something moves that is fixed to the shape: placed by a pose in its frame, which may scale it. Throws Error
  /// when the pose is not finite, and of a motion that is told by a function when it is singular.
  [[nodiscard]] RigidMotion carrying(const Pose& fixed) const;

  /// The pose at a time, rounded; at 0 it is the first pose. A vertex that it poses is off from where it is by no more
  /// than (1 + pieces before) · (128 + 64 |turns|) · 2⁻⁵³ · (size + |centre| + |translation|), which all answers
  /// allow for. Throws Error for a time outside of [0, 1], and when a pose that the function returned is not finite.
  [[nodiscard]] Pose at(double time) const;

  // For the library itself.

  /// In the order of time; none of a motion that is told by a function.
  [[nodiscard]] std::span<const Piece> pieces() const { return pieces_; }
  /// Of a motion that is told by a function.
  [[nodiscard]] const MotionSpeed& speed() const { return speed_; }

 private:
  RigidMotion() = default;

  std::vector<Piece> pieces_;
  std::function<Pose(double)> pose_at_;
  MotionSpeed speed_;
};

}  // namespace toccata
