#include "toccata/bounds/kdop.hpp"
#include "toccata/methods/sphere_ways.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "oracle/rational.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"
#include "toccata/narrow/primitives.hpp"

namespace toccata::test {
namespace {

using oracle::Rational;
using oracle::RationalPoint;

/// The half-spaces of a k-DOP.
template <std::size_t k>
std::vector<oracle::HalfSpace> half_spaces(const Kdop<k>& kdop) {
  std::vector<oracle::HalfSpace> planes;
  for (std::size_t i = 0; i < k / 2; ++i) {
    const RationalPoint n = oracle::exact(kdop_normals<k>()[i]);
    planes.push_back({-n, -oracle::exact(kdop.lower[i])});
    planes.push_back({n, oracle::exact(kdop.upper[i])});
  }
  return planes;
}

/// The nearest point of the planes' intersection, when their normals are independent: p less a sum of normals.
std::optional<RationalPoint> foot(const RationalPoint& p, const std::vector<oracle::HalfSpace>& planes) {
  const std::size_t n = planes.size();
  std::vector<std::vector<Rational>> rows(n, std::vector<Rational>(n + 1));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) rows[i][j] = dot(planes[i].normal, planes[j].normal);
    rows[i][n] = height_above(planes[i], p);
  }
  for (std::size_t i = 0; i < n; ++i) {  // the pivots of a Gram matrix are positive, or the normals dependent
    if (rows[i][i].is_zero()) return std::nullopt;
    for (std::size_t r = 0; r < n; ++r) {
      if (r == i) continue;
      const Rational factor = rows[r][i] / rows[i][i];
      for (std::size_t c = i; c <= n; ++c) rows[r][c] = rows[r][c] - factor * rows[i][c];
    }
  }
  RationalPoint q = p;
  for (std::size_t i = 0; i < n; ++i) q = q - (rows[i][n] / rows[i][i]) * planes[i].normal;
  return q;
}

/// The squared distance of a point to the intersection: the least of the distances to feet on up to three planes that
/// are within all.
Rational squared_distance(const RationalPoint& p, const std::vector<oracle::HalfSpace>& planes) {
  std::optional<Rational> least;
  const auto take = [&](const std::vector<oracle::HalfSpace>& chosen) {
    const std::optional<RationalPoint> q = chosen.empty() ? p : foot(p, chosen);
    if (!q) return;
    for (const auto& plane : planes)
      if (height_above(plane, *q) > 0) return;
    const Rational square = dot(*q - p, *q - p);
    if (!least || square < *least) least = square;
  };
  take({});
  for (std::size_t a = 0; a < planes.size(); ++a) {
    take({planes[a]});
    for (std::size_t b = a + 1; b < planes.size(); ++b) {
      take({planes[a], planes[b]});
      for (std::size_t c = b + 1; c < planes.size(); ++c) take({planes[a], planes[b], planes[c]});
    }
  }
  return *least;
}

/// Small whole numbers, so that spheres touch exactly; or any, far from the origin too.
Vec3 random_place(Random& random, int kind) {
  if (kind == 0)
    return {static_cast<double>(random.below(9)) - 4, static_cast<double>(random.below(9)) - 4,
            static_cast<double>(random.below(9)) - 4};
  const double at = kind == 1 ? 0 : 1e6;
  return {at + random.between(-4, 4), random.between(-4, 4), random.between(-4, 4)};
}

template <std::size_t k>
void compare_with_oracle(std::uint64_t cases) {
  int met = 0, touched = 0, apart = 0;
  for (std::uint64_t seed = 0; seed < cases; ++seed) {
    Random random(seed);
    const int kind = static_cast<int>(seed % 3);
    std::vector<Vec3> points;
    for (std::uint64_t i = 0; i < 1 + seed % 6; ++i) points.push_back(random_place(random, kind));
    const Kdop<k> kdop = fit<Kdop<k>>(points);
    const Vec3 centre = random_place(random, kind);
    const Rational square = squared_distance(oracle::exact(centre), half_spaces(kdop));
    const double near = std::sqrt(square.to_double());
    for (const double radius : {near, std::nextafter(near, 0.0), std::nextafter(near, 9.0), 0.5 * near, 2.0, 1.0}) {
      if (!(radius > 0)) continue;
      const Rational r = oracle::exact(radius);
      const bool expected = square <= r * r;
      ASSERT_EQ(overlap_by_regions(PosedSphere(centre, radius), kdop), expected) << "k " << k << " seed " << seed;
      ++(square == r * r ? touched : expected ? met : apart);
    }
    ASSERT_EQ(kdop_region(centre, kdop) == 0, square.is_zero()) << seed;
  }
  EXPECT_GT(met, 10);
  EXPECT_GT(touched, 2);
  EXPECT_GT(apart, 10);
}

TEST(SphereKdop, OverlapIsThatOfTheOracle) {
  compare_with_oracle<6>(300);
  compare_with_oracle<14>(60);
  compare_with_oracle<18>(60);
  compare_with_oracle<26>(30);
}

template <std::size_t k>
void compare_distance_with_oracle(std::uint64_t cases) {
  for (std::uint64_t seed = 0; seed < cases; ++seed) {
    SCOPED_TRACE(testing::Message() << "k " << k << " seed " << seed);
    Random random(seed);
    const int kind = static_cast<int>(seed % 3);
    std::vector<Vec3> points;
    for (std::uint64_t i = 0; i < 1 + seed % 6; ++i) points.push_back(random_place(random, kind));
    const Kdop<k> kdop = fit<Kdop<k>>(points);
    const Vec3 centre = random_place(random, kind);
    const auto planes = half_spaces(kdop);
    const Rational square = squared_distance(oracle::exact(centre), planes);
    const Distance found = distance(PosedSphere(centre, 0), kdop);
    const Rational lower = oracle::exact(found.lower), upper = oracle::exact(found.upper);
    ASSERT_TRUE(lower * lower <= square && square <= upper * upper);
    ASSERT_LE(found.upper, std::nextafter(found.lower, HUGE_VAL));
    ASSERT_EQ(found.on_a, centre);
    // The point is as near as is told, and as near to every plane's inner side as rounding lets it be.
    const Vec3 way = found.on_b - centre;
    const double size = kind == 2 ? 1e6 : 10;
    ASSERT_NEAR(std::sqrt(dot(way, way)), found.upper, 1e-12 * size);
    for (const auto& plane : planes)
      ASSERT_LT(height_above(plane, oracle::exact(found.on_b)).to_double(), 1e-12 * size);
    const Distance grown = distance(PosedSphere(centre, 0.5), kdop);
    ASSERT_NEAR(grown.upper, std::max(0.0, found.upper - 0.5), 1e-12 * size);
    ASSERT_EQ(grown.upper == 0, overlap_by_regions(PosedSphere(centre, 0.5), kdop));
  }
}

TEST(SphereKdop, DistanceIsThatOfTheOracle) {
  compare_distance_with_oracle<6>(60);
  compare_distance_with_oracle<14>(24);
  compare_distance_with_oracle<18>(12);
  compare_distance_with_oracle<26>(6);
  EXPECT_THROW((void)distance(PosedSphere({0, 0, 0}, 1), Kdop<14>{}), Error);
}

TEST(SphereKdop, OfSixPlanesIsThatOfABox) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    Random random(seed);
    const int kind = static_cast<int>(seed % 3);
    const Kdop<6> kdop = fit<Kdop<6>>(std::vector<Vec3>{random_place(random, kind), random_place(random, kind)});
    const Vec3 lower{kdop.lower[0], kdop.lower[1], kdop.lower[2]}, upper{kdop.upper[0], kdop.upper[1], kdop.upper[2]};
    const PosedSphere sphere(random_place(random, kind), 1 + static_cast<double>(random.below(4)));
    ASSERT_EQ(kdop_region(sphere.centre, kdop), box_region(sphere.centre, lower, upper)) << seed;
    ASSERT_EQ(overlap_by_regions(sphere, kdop), overlap_by_regions(sphere, lower, upper)) << seed;
  }
}

// Two planes that meet at an acute angle: the centre is beyond one, and its foot on that is beyond the other.
TEST(SphereKdop, TheNearestEdgeMayBeOfAPlaneThatIsNotViolated) {
  Kdop<18> wedge;
  wedge.lower.fill(-10);
  wedge.upper.fill(10);
  wedge.upper[3] = 0;  // x + y ≤ 0
  wedge.lower[5] = 0;  // x + z ≥ 0
  const Vec3 centre{1, 1, 0};
  EXPECT_EQ(kdop_region(centre, wedge), 1U << 7);
  const Rational square = squared_distance(oracle::exact(centre), half_spaces(wedge));
  EXPECT_EQ(square.to_double(), 2.0);  // the foot (0, 0, 0) lies on the edge
  const Vec3 aside{1, 1, -1};
  EXPECT_EQ(kdop_region(aside, wedge), 1U << 7);
  const Rational to_edge = squared_distance(oracle::exact(aside), half_spaces(wedge));
  EXPECT_GT(to_edge, Rational(2));  // as far as the plane
  EXPECT_FALSE(overlap_by_regions(PosedSphere(aside, 1.5), wedge));
  EXPECT_TRUE(overlap_by_regions(PosedSphere(centre, 1.5), wedge));
}

TEST(SphereKdop, AnEmptyOneMeetsNothing) {
  EXPECT_FALSE(overlap_by_regions(PosedSphere({0, 0, 0}, 1e300), Kdop<26>{}));
}

TEST(SphereKdop, HoldsAtTheEndsOfTheDoubles) {
  for (const double size : {1e-300, 1e-160, 1e150, 1e300}) {
    const Kdop<26> kdop = fit<Kdop<26>>(std::vector<Vec3>{{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {size, size, size}});
    EXPECT_TRUE(overlap_by_regions(PosedSphere({-size, 0, 0}, size), kdop)) << size;
    EXPECT_FALSE(overlap_by_regions(PosedSphere({-size, 0, 0}, std::nextafter(size, 0.0)), kdop)) << size;
  }
}

}  // namespace
}  // namespace toccata::test
