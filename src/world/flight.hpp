#pragma once

#include <optional>

#include "toccata/bounds/ball.hpp"
#include "toccata/broad/space_time.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/world/body.hpp"

// What a World believes of how its bodies will move, and the test whether they did.
namespace toccata {

/// What of a body turns with it, in its own frame: all of its points but for a radius that is the same along every
/// direction are in a ball.
struct TurningParts {
  Vec3 centre{};
  double radius = 0;  ///< infinite where nothing is known, as of a half-space
  double magnitude =
      0;                ///< no sum of magnitudes that is added up for a world coordinate is greater, but for the offset
  Vec3 half_extents{};  ///< of the box around the centre in which they are
  double inner = 0;     ///< all of a ball of this radius around the centre is within the body, which is convex; 0: none
};

[[nodiscard]] TurningParts turning_parts(const Body& body);

/// Where a body was at a step.
struct Sight {
  Vec3 centre{};  ///< of its turning parts
  Mat3 linear{};
  friend constexpr bool operator==(const Sight&, const Sight&) = default;
};

struct LastSights {
  Sight now, before, earlier;
};

[[nodiscard]] Sight sight_of(const TurningParts& parts, const Pose& pose);

/// A ball within the body at its pose, which is a rotation but for 2⁻²⁰, and at every other such pose around where the
/// centre is then. Its radius is 0 where no ball is known to be.
[[nodiscard]] Ball inner_ball(const TurningParts& parts, const Pose& pose);

/// How a body is expected to move for some steps from one on. A step is the unit of time.
///
/// A point goes on by v + W p in each step, where p is where it was to the centre in the body's own frame when the
/// flight began, v the last way of the centre and W the last change of the pose's matrix. In the k-th step of the
/// flight it is off from that by no more than velocity_error + max_acceleration (k − 1/2), whose sum is what a
/// SpaceTimeMotion allows; as each step is tested for itself, the same bounds hold from any step on.
///
/// Two poses (R, t) and (S, s) place the points of a ball of radius r around c no farther apart than
/// |(R c + t) − (S c + s) − v| + ‖R − S − W‖ r, beyond ways of v + W p; the Frobenius norm is no less than the greatest
/// singular value. World coordinates are rounded sums of at most four numbers, so each is off by less than 8 u of
/// their magnitudes; `goes_on` allows 2⁻⁴⁶ of these in a step, and 2⁻⁴³ more than the bound, so in 64 steps at most
/// half of the position error of 2⁻³⁶ of them. So whatever is apart by the bounds is also apart by more than 10⁻¹² of
/// the bodies' sizes, within which quadrics would count as in contact.
class Flight {
 public:
  Flight() = default;

  /// Nobody has moved it.
  [[nodiscard]] bool is_at_rest() const { return is_at_rest_; }
  /// All its poses are rotations but for 2⁻²⁰: its inner ball stays as it is.
  [[nodiscard]] bool is_rigid() const { return is_rigid_; }
  /// The motion of the centre, and of all points but for how the body turns.
  [[nodiscard]] const SpaceTimeMotion& motion() const { return motion_; }
  /// How much farther than that a point may go in a step, turning evenly.
  [[nodiscard]] double turning_speed() const { return turning_speed_; }
  /// How much farther along a direction of length 1.
  [[nodiscard]] double turning_speed(const TurningParts& parts, const Vec3& along) const;

  /// Whether its points have gone on in this step as the motion says, the `step`-th after its begin.
  [[nodiscard]] bool goes_on(const TurningParts& parts, const Sight& now, double step);

 private:
  friend std::optional<Flight> flight_from(const Body&, const TurningParts&, const LastSights&, double);

  Sight last_;
  SpaceTimeMotion motion_;
  Mat3 turning_{{Vec3{}, Vec3{}, Vec3{}}};  ///< W
  double turning_speed_ = 0;
  double magnitude_ = 0;
  bool is_at_rest_ = false;
  bool is_rigid_ = false;
};

/// As it goes on from where it is now and was at the two steps before, for so many steps. What the body promises counts
/// (Body::max_acceleration, max_speed); of one that promises no acceleration twice what was last seen is expected. None
/// where too little is known of its points, or its pose enlarges it.
[[nodiscard]] std::optional<Flight> flight_from(const Body& body, const TurningParts& parts, const LastSights& sights,
                                                double steps);

}  // namespace toccata
