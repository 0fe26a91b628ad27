#include "toccata/query/distance.hpp"

#include <fmt/format.h>

#include "query/distance/nearby.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

/// −0 is 0.
double checked(double length, const char* name) {
  if (!(length >= 0)) throw Error(fmt::format("{} is {}; it has to be a length of 0 or more", name, length));
  return length + 0.0;
}

}  // namespace

Distance distance(const Model& a, const Model& b, const PairQuery& query) {
  Workspace workspace;
  return distance(a, b, query, workspace);
}

Distance distance(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace) {
  return nearby(a, b, {}, query, workspace)->distance;
}

bool within_distance(const Model& a, const Model& b, double tolerance, const PairQuery& query) {
  Workspace workspace;
  return within_distance(a, b, tolerance, query, workspace);
}

bool within_distance(const Model& a, const Model& b, double tolerance, const PairQuery& query, Workspace& workspace) {
  return nearby(a, b, WantedDistance::within(checked(tolerance, "tolerance")), query, workspace).has_value();
}

std::optional<Distance> distance_within(const Model& a, const Model& b, double limit, const PairQuery& query) {
  Workspace workspace;
  return distance_within(a, b, limit, query, workspace);
}

std::optional<Distance> distance_within(const Model& a, const Model& b, double limit, const PairQuery& query,
                                        Workspace& workspace) {
  const auto found = nearby(a, b, {.limit = checked(limit, "limit")}, query, workspace);
  return found && found->is_within ? std::optional(found->distance) : std::nullopt;
}

}  // namespace toccata
