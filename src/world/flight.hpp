#pragma once

#include <optional>

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
      0;  ///< no sum of magnitudes that is added up for a world coordinate is greater, but for the offset
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

/// How a body is expected to move for some steps from one on. A step is the unit of time.
///
/// Two poses (R, t) and (S, s) place the points of a ball of radius r around c no farther apart than
/// |(R c + t) − (S c + s) − v| + ‖R − S‖ r, beyond a common way v; the Frobenius norm is no less than the greatest
/// singular value. World coordinates are rounded sums of at most four numbers, so each is off by less than 8 u of
/// their magnitudes; `is_kept` allows 2⁻⁴² of these, and demands that the points are within the motion's bound less
/// 2⁻³⁷ of them. So whatever is apart by the bounds is also apart by more than 10⁻¹² of the bodies' sizes, within which
/// quadrics would count as in contact.
class Flight {
 public:
  Flight() = default;

  /// Nobody has moved it.
  [[nodiscard]] bool is_at_rest() const { return is_at_rest_; }
  [[nodiscard]] const SpaceTimeMotion& motion() const { return motion_; }

  /// Whether its points are, so many steps after its begin, where the motion says.
  [[nodiscard]] bool is_kept(const TurningParts& parts, const Sight& now, double steps) const;

 private:
  friend std::optional<Flight> flight_from(const Body&, const TurningParts&, const LastSights&, double);

  Sight start_;
  SpaceTimeMotion motion_;
  double magnitude_ = 0;
  bool is_at_rest_ = false;
};

/// As it goes on from where it is now and was at the two steps before, for so many steps. What the body promises counts
/// (Body::max_acceleration, max_speed); of one that promises no acceleration twice what was last seen is expected. None
/// where too little is known of its points, or its pose enlarges it.
[[nodiscard]] std::optional<Flight> flight_from(const Body& body, const TurningParts& parts, const LastSights& sights,
                                                double steps);

}  // namespace toccata
