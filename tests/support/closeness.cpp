#include "support/closeness.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <vector>

#include "oracle/meshes.hpp"
#include "support/mesh_pairs.hpp"
#include "toccata/query/contacts.hpp"

namespace toccata::test {
namespace {

std::vector<double> tolerances_about(const Distance& d) {
  const double above = std::nextafter(d.upper, std::numeric_limits<double>::infinity());
  const double middle = d.lower + 0.5 * (d.upper - d.lower);
  return {0, 0.5 * d.lower, std::nextafter(d.lower, 0.0), d.lower, middle, d.upper, above, 2 * d.upper};
}

std::string fault_at(const Model& a, const Model& b, const PairQuery& query, const Distance& d, double tolerance,
                     bool truth, Workspace& workspace) {
  if (within_distance(a, b, tolerance, query) != truth) return "answer";
  if (within_distance(a, b, tolerance, query, workspace) != truth) return "warm";
  if (within_distance(b, a, tolerance, exchanged(query), workspace) != truth) return "exchanged";
  const std::optional<Distance> found = distance_within(a, b, tolerance, query, workspace);
  if (found.has_value() != truth) return "distance";
  return !found || *found == d ? "" : "bits of the distance";
}

}  // namespace

std::string fault_of_closeness(const Model& a, const Model& b, const PairQuery& given) {
  PairQuery query = given;
  query.solid_a = query.solid_b = Solid::none;
  const Distance d = distance(a, b, query);
  const oracle::Rational squared = oracle::squared_distance(oracle::surface_set(a.mesh(), query.pose_a),
                                                            oracle::surface_set(b.mesh(), query.pose_b));
  Workspace workspace;
  for (const double tolerance : tolerances_about(d)) {
    const oracle::Rational length(tolerance);
    const std::string fault = fault_at(a, b, query, d, tolerance, !(length * length < squared), workspace);
    if (!fault.empty()) return fmt::format("tolerance {}: {}", tolerance, fault);
  }
  return {};
}

}  // namespace toccata::test
