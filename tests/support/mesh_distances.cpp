#include "support/mesh_distances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/mesh_pairs.hpp"
#include "toccata/query/contacts.hpp"

namespace toccata::test {
namespace {

Distance of_triangles(const Model& a, const Model& b, const PairQuery& q, Index i, Index j) {
  return distance(PosedPolytope(world_triangle(a, q.pose_a, i)), PosedPolytope(world_triangle(b, q.pose_b, j)));
}

struct Range {
  double lower;
  double upper;
};

/// The least distance lies in it.
Range by_brute_force(const Model& a, const Model& b, const PairQuery& query) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Range least{infinity, infinity};
  for (Index i = 0; i < a.element_count(); ++i)
    for (Index j = 0; j < b.element_count(); ++j) {
      const Distance d = of_triangles(a, b, query, i, j);
      least = {std::min(least.lower, d.lower), std::min(least.upper, d.upper)};
    }
  return least;
}

bool near(const Vec3& p, const Vec3& q, double off) {
  const Vec3 d = p - q;
  return std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}) <= off;
}

std::string fault_of_interval(const Distance& d, const Range& truth) {
  if (!(d.lower <= truth.upper && truth.lower <= d.upper)) return "interval";
  // Both are as narrow as promised, so neither end can be far from the truth.
  if (d.upper > truth.upper && d.lower > truth.lower) return "upper";
  const bool is_narrow = d.upper - d.lower <= 1e-12 * d.upper || std::nextafter(d.lower, d.upper) == d.upper;
  if (!is_narrow) return "width";
  return (d.upper == 0) == (truth.upper == 0) && (d.lower > 0 || truth.lower == 0) ? "" : "zero";
}

}  // namespace

double largest_coordinate(const Model& mesh, const Pose& pose) {
  double largest = 0;
  for (const Vec3& v : transform(pose, mesh.mesh().vertices()))
    largest = std::max({largest, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return largest;
}

std::string fault_of_surface_distance(const Model& a, const Model& b, const PairQuery& given) {
  PairQuery query = given;
  query.solid_a = query.solid_b = Solid::none;
  Workspace workspace;
  const Distance d = distance(a, b, query, workspace);
  std::string fault = fault_of_interval(d, by_brute_force(a, b, query));
  if (!fault.empty()) return fault;
  const Distance pair = of_triangles(a, b, query, d.element_a, d.element_b);
  const double off = 1e-12 * std::max(largest_coordinate(a, query.pose_a), largest_coordinate(b, query.pose_b));
  if (!near(pair.on_a, d.on_a, off) || !near(pair.on_b, d.on_b, off)) return "points";
  if (pair.lower > d.upper || pair.upper < d.lower) return "elements";
  if (d.face_a != a.mesh().face_of(d.element_a) || d.face_b != b.mesh().face_of(d.element_b)) return "faces";
  if (!(distance(a, b, query, workspace) == d)) return "warm";
  const Distance other = flipped(distance(b, a, exchanged(query)));
  const bool same_pair = other.element_a == d.element_a && other.element_b == d.element_b;
  if (same_pair && d.upper > 0 && !(other == d)) return "exchanged";
  return other.upper <= d.upper * (1 + 1e-12) && d.upper <= other.upper * (1 + 1e-12) ? "" : "exchanged, a tie";
}

}  // namespace toccata::test
