#pragma once

#include <optional>

#include "toccata/query/distance.hpp"

namespace toccata {

/// Is the exact distance of the two posed models at most `tolerance` (in world units)? Decided exactly, as everything
/// about world doubles is; of cylinders, cones and ellipsoids a no is proved, and a tolerance within the interval of
/// the distance counts as yes. With a tolerance of 0 it is `overlap`. It ends at the first two elements that are so
/// near, and looks at nothing that is farther, so it costs less than the distance. Throws Error like `distance`, and
/// when the tolerance is negative or no number; it may be infinite.
[[nodiscard]] bool within_distance(const Model& a, const Model& b, double tolerance, const PairQuery& query = {});

/// The same, for a caller who asks often: what was found near the last time is looked at first.
[[nodiscard]] bool within_distance(const Model& a, const Model& b, double tolerance, const PairQuery& query,
                                   Workspace& workspace);

/// What `distance` answers, to the last bit, where `within_distance` says yes; nothing where it says no, which is found
/// out without the distance. Throws like it.
[[nodiscard]] std::optional<Distance> distance_within(const Model& a, const Model& b, double limit,
                                                      const PairQuery& query = {});

/// The same, for a caller who asks often.
[[nodiscard]] std::optional<Distance> distance_within(const Model& a, const Model& b, double limit,
                                                      const PairQuery& query, Workspace& workspace);

}  // namespace toccata
