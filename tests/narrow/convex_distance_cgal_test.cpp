#include <CGAL/Gmpzf.h>
#include <CGAL/Polytope_distance_d.h>
#include <CGAL/Polytope_distance_d_traits_3.h>
#include <CGAL/Simple_cartesian.h>
#include <gtest/gtest.h>

#include <vector>

#include "narrow/convex_distance_checks.hpp"
#include "toccata/narrow/convex_convex.hpp"

// Distances of polytopes, compared with CGAL's quadratic programs in exact numbers (K. Fischer, B. Gärtner, S.
// Schönherr, F. Wessendorp, "Linear and quadratic programming solver").
namespace toccata {
namespace {

// Exact input, too: with doubles CGAL's prices are filtered, and seldom it stops at a pair that is not the nearest.
using Exact = CGAL::Gmpzf;
using Kernel = CGAL::Simple_cartesian<Exact>;
using Traits = CGAL::Polytope_distance_d_traits_3<Kernel, Exact, Exact>;

std::vector<Kernel::Point_3> points_of(const PosedConvex& shape) {
  std::vector<Kernel::Point_3> points;
  for (Index i = 0; i < shape.vertex_count(); ++i) {
    const Vec3 v = shape.vertex(i);
    points.emplace_back(Exact(v.x), Exact(v.y), Exact(v.z));
  }
  return points;
}

/// The square of the distance is numerator / denominator.
void expect_equal(const Distance& d, const Exact& numerator, const Exact& denominator, const std::string& pair) {
  const auto square = [&](double distance) { return Exact(distance) * Exact(distance) * denominator; };
  EXPECT_LE(square(d.lower), numerator) << pair;
  EXPECT_GE(square(d.upper), numerator) << pair;
  EXPECT_EQ(d.upper == 0, numerator == 0) << pair;
  EXPECT_EQ(test::width_fault(d), "") << pair;
}

TEST(ConvexDistance, OfPolytopesIsThatOfCgal) {
  std::uint64_t number = 0;
  for (const char* kind_a : {"point", "segment", "triangle", "box", "hull", "flat-hull", "needle-hull"})
    for (const char* kind_b : {"segment", "triangle", "box", "hull"})
      for (const std::string& regime : test::convex_regimes()) {
        Random random(++number);
        const test::ConvexCase pair = test::convex_case(kind_a, kind_b, regime, random);
        const PosedConvex a = test::posed(pair.a), b = test::posed(pair.b);
        const auto points_a = points_of(a), points_b = points_of(b);
        CGAL::Polytope_distance_d<Traits> cgal(points_a.begin(), points_a.end(), points_b.begin(), points_b.end());
        expect_equal(distance(a, b), cgal.squared_distance_numerator(), cgal.squared_distance_denominator(),
                     to_text(pair));
      }
}

}  // namespace
}  // namespace toccata
