#include "toccata/query/distance.hpp"

#include "core/require_length.hpp"
#include "query/distance/nearby.hpp"

namespace toccata {
namespace {

/// −0 is 0.
double checked(double max_distance) {
  require_length(max_distance, "the greatest distance");
  return max_distance + 0.0;
}

}  // namespace

Distance distance(const Model& a, const Model& b, const PairQuery& query) {
  Workspace workspace;
  return distance(a, b, query, workspace);
}

Distance distance(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace) {
  return nearby(a, b, {}, query, workspace)->distance;
}

bool within_distance(const Model& a, const Model& b, double max_distance, const PairQuery& query) {
  Workspace workspace;
  return within_distance(a, b, max_distance, query, workspace);
}

bool within_distance(const Model& a, const Model& b, double max_distance, const PairQuery& query,
                     Workspace& workspace) {
  return nearby(a, b, WantedDistance::within(checked(max_distance)), query, workspace).has_value();
}

std::optional<Distance> distance_within(const Model& a, const Model& b, double max_distance, const PairQuery& query) {
  Workspace workspace;
  return distance_within(a, b, max_distance, query, workspace);
}

std::optional<Distance> distance_within(const Model& a, const Model& b, double max_distance, const PairQuery& query,
                                        Workspace& workspace) {
  const auto found = nearby(a, b, {.limit = checked(max_distance)}, query, workspace);
  return found && found->is_within ? std::optional(found->distance) : std::nullopt;
}

}  // namespace toccata
