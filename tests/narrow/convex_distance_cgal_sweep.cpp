#include <CGAL/Gmpzf.h>
#include <CGAL/Polytope_distance_d.h>
#include <CGAL/Polytope_distance_d_traits_3.h>
#include <CGAL/Simple_cartesian.h>

#include <vector>

#include "narrow/convex_cells.hpp"
#include "narrow/convex_distance_checks.hpp"
#include "toccata/narrow/convex_convex.hpp"

// Distances of polytopes, compared with CGAL's quadratic programs in exact numbers (K. Fischer, B. Gärtner, S.
// Schönherr, F. Wessendorp, "Linear and quadratic programming solver").
namespace toccata::test {
namespace {

// Exact input, too: with doubles CGAL's prices are filtered, and seldom it stops at a pair that is not the nearest.
using Exact = CGAL::Gmpzf;
using Kernel = CGAL::Simple_cartesian<Exact>;
using Traits = CGAL::Polytope_distance_d_traits_3<Kernel, Exact, Exact>;

const std::vector<std::string> polytopes{"point", "segment", "triangle", "box", "hull", "flat-hull", "needle-hull"};

std::vector<Kernel::Point_3> points_of(const PosedPolytope& shape) {
  std::vector<Kernel::Point_3> points;
  for (Index i = 0; i < shape.vertex_count(); ++i) {
    const Vec3 v = shape.vertex(i);
    points.emplace_back(Exact(v.x), Exact(v.y), Exact(v.z));
  }
  return points;
}

/// The square of the distance is numerator / denominator.
std::string fault(const Distance& d, const Exact& numerator, const Exact& denominator) {
  const auto square = [&](double distance) { return Exact(distance) * Exact(distance) * denominator; };
  if (square(d.lower) > numerator) return "lower is too large";
  if (square(d.upper) < numerator) return "upper is too small";
  if ((d.upper == 0) != (numerator == Exact(0))) return "0 exactly when they meet";
  return width_fault(d);
}

std::string check(const ConvexCase& pair, Random&) {
  const PosedPolytope a = posed(pair.a), b = posed(pair.b);
  const auto points_a = points_of(a), points_b = points_of(b);
  CGAL::Polytope_distance_d<Traits> cgal(points_a.begin(), points_a.end(), points_b.begin(), points_b.end());
  const Exact numerator = cgal.squared_distance_numerator(), denominator = cgal.squared_distance_denominator();
  if (overlap(a, b) != (numerator == Exact(0))) return "overlap";
  const std::string wrong = fault(distance(a, b), numerator, denominator);
  return wrong.empty() ? fault(distance(b, a), numerator, denominator) : wrong;
}

SweepResult run(const std::string& cell, std::uint64_t seed, std::uint64_t cases) {
  return run_cell(cell, seed, cases, check);
}

const bool known =
    register_sweep({"convex-distance-cgal", cells_of(polytopes), cell_goal, cell_round, run, cell_shard});

}  // namespace
}  // namespace toccata::test
