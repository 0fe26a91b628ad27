#pragma once

#include <optional>

#include "motion/moving_polygon.hpp"
#include "toccata/core/status.hpp"

namespace toccata {

/// When two features first are at most a distance apart, as ImpactOptions tells.
struct Approach {
  TimeOfImpact time;
  Status status = Status::exact;
  friend constexpr bool operator==(const Approach&, const Approach&) = default;
};

/// For finite coordinates and a positive, finite separation. The same bits for every order of corners, ends and edges.
/// None where they stay farther apart; perhaps none where `lower` would be later than `latest`, which takes less time.
[[nodiscard]] std::optional<Approach> time_of_approach(const MovingPolygon<3>& polygon, double separation,
                                                       double latest = 1);
[[nodiscard]] std::optional<Approach> time_of_approach(const MovingPolygon<4>& polygon, double separation,
                                                       double latest = 1);

/// A fraction in [0, 1] such that the features stay more than the separation, which may be 0, apart when each of their
/// points goes any part of its way up to it, whatever the parts. 0 where that is not proved for more.
[[nodiscard]] double independent_fraction(const MovingPolygon<3>& polygon, double separation);
[[nodiscard]] double independent_fraction(const MovingPolygon<4>& polygon, double separation);

}  // namespace toccata
