#include "shapes/hull_cases.hpp"
#include "support/sweep.hpp"

// Hulls of points, proved by their own certificate with exact signs: topology, planar and strictly convex faces, and no
// point before any face.
namespace toccata::test {
namespace {

std::string check_convex_hull(const std::vector<Vec3>& points) {
  const ConvexHull hull(points);
  if (std::string wrong = hull_failure(hull, points); !wrong.empty()) return wrong;
  // The same faces from the points in the opposite order, whose vertices are numbered backwards.
  const ConvexHull backwards(std::vector<Vec3>(points.rbegin(), points.rend()));
  if (std::string wrong = topology_failure(backwards); !wrong.empty()) return "backwards: " + wrong;
  const bool same = backwards.vertex_count() == hull.vertex_count() && backwards.dimension() == hull.dimension() &&
                    backwards.topology().face_count() == hull.topology().face_count();
  return same ? "" : "another hull backwards";
}

SweepResult run_convex_hull(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  SweepResult result;
  Random random(Random(seed).bits() + 5);
  for (; result.cases < cases; ++result.cases) {
    const std::size_t count = 1 + random.below(result.cases % 16 == 0 ? 100 : 24);
    const std::vector<Vec3> points = hull_points(family, random, count);
    const std::string wrong = check_convex_hull(points);
    if (wrong.empty()) continue;
    if (result.wrong++ == 0)
      result.first_failure = wrong + ", case " + std::to_string(result.cases) + ": " + to_text(points);
  }
  return result;
}

const bool convex_hull_known = register_sweep({"convex-hulls", hull_families(), 100'000, 500, run_convex_hull});

}  // namespace
}  // namespace toccata::test
