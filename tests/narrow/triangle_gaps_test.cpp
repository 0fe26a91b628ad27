#include "narrow/triangles/triangle_gaps.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "oracle/oracle.hpp"
#include "support/simd_levels.hpp"
#include "toccata/core/random.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata {
namespace {

constexpr std::size_t lanes = TrianglePairBlock::lanes;
using Pairs = std::array<std::array<Triangle, 2>, lanes>;

Vec3 random_point(Random& random, double size) {
  const double x = random.between(-size, size), y = random.between(-size, size);
  return {x, y, random.between(-size, size)};
}

Triangle moved(const Triangle& triangle, const Vec3& by) {
  return {{triangle[0] + by, triangle[1] + by, triangle[2] + by}};
}

Triangle random_triangle(Random& random, double size) {
  Triangle t{{random_point(random, size), random_point(random, size), random_point(random, size)}};
  switch (random.below(6)) {
    case 0:
      t.vertex[1] = t.vertex[0];
      break;
    case 1:
      t.vertex[2] = t.vertex[0] + random.unit() * (t.vertex[1] - t.vertex[0]);  // a needle
      break;
    case 2:
      t.vertex[1] = t.vertex[0] + 1e-9 * (t.vertex[1] - t.vertex[0]);
      break;
    default:
      break;
  }
  return t;
}

/// One may be the other moved by a little, so that edges are parallel and vertices above each other.
std::array<Triangle, 2> random_pair(Random& random, double size, double offset) {
  const Triangle a = random_triangle(random, size);
  const double way = size * std::exp2(random.between(-40, 8));
  const Vec3 by = random.below(2) == 0 ? Vec3{0, 0, way} : random_point(random, way);
  const Triangle b = random.below(2) == 0 ? a : random_triangle(random, size);
  const Vec3 far = random_point(random, offset * size);
  return {moved(a, far), moved(b, far + by)};
}

struct Bounds {
  TriangleGaps::Lanes lower, upper;
  friend bool operator==(const Bounds&, const Bounds&) = default;
};

/// As `bound_gaps` has them, and as `refine_gaps` makes them of that.
std::array<Bounds, 2> bounds_of(const Pairs& pairs) {
  TrianglePairBlock block{};
  for (std::size_t lane = 0; lane < lanes; ++lane) set_pair(block, lane, pairs[lane][0], pairs[lane][1]);
  TriangleGaps gaps{};
  bound_gaps(block, gaps);
  const Bounds first{gaps.lower, gaps.upper};
  refine_gaps(block, gaps);
  return {first, {gaps.lower, gaps.upper}};
}

oracle::Rational squared_distance(const std::array<Triangle, 2>& pair) {
  const auto set_of = [](const Triangle& t) {
    return oracle::surface_set(TriangleMesh({t[0], t[1], t[2]}, {{0, 1, 2}}), Pose{});
  };
  return oracle::squared_distance(set_of(pair[0]), set_of(pair[1]));
}

void expect_holds(double lower, double upper, const oracle::Rational& squared) {
  EXPECT_GE(lower, 0);
  EXPECT_LE(oracle::Rational(lower) * oracle::Rational(lower), squared);
  if (!std::isfinite(upper)) return;
  EXPECT_GE(oracle::Rational(upper) * oracle::Rational(upper), squared);
}

struct Family {
  double size;
  double offset;
};

TEST(TriangleGaps, HoldTheExactDistanceAtEverySize) {
  for (const Family family : {Family{1, 0}, Family{1, 1e6}, Family{1e-55, 0}, Family{1e-70, 1}, Family{1e55, 0},
                              Family{1e70, 1}, Family{1e-150, 0}, Family{1e150, 0}})
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      SCOPED_TRACE("size " + std::to_string(std::log10(family.size)) + ", seed " + std::to_string(seed));
      Random random(seed);
      Pairs pairs;
      for (auto& pair : pairs) pair = random_pair(random, family.size, family.offset);
      const auto [first, refined] = bounds_of(pairs);
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        const oracle::Rational squared = squared_distance(pairs[lane]);
        expect_holds(first.lower[lane], first.upper[lane], squared);
        expect_holds(refined.lower[lane], refined.upper[lane], squared);
      }
    }
}

TEST(TriangleGaps, AreTheSameInEveryLaneAtEverySimdLevel) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Random random(seed);
    Pairs pairs;
    for (auto& pair : pairs)
      pair = random_pair(random, std::exp2(random.between(-8, 8)), random.below(2) == 0 ? 0 : 100);
    const auto truth = bounds_of(pairs);
    Pairs turned;
    for (std::size_t lane = 0; lane < lanes; ++lane) turned[(lane + 3) % lanes] = pairs[lane];
    const auto of_turned = bounds_of(turned);
    for (std::size_t lane = 0; lane < lanes; ++lane)
      for (std::size_t stage = 0; stage < 2; ++stage) {
        EXPECT_EQ(of_turned[stage].lower[(lane + 3) % lanes], truth[stage].lower[lane]) << "seed " << seed;
        EXPECT_EQ(of_turned[stage].upper[(lane + 3) % lanes], truth[stage].upper[lane]) << "seed " << seed;
      }
    test::at_every_simd_level(
        [&](SimdLevel level) { EXPECT_TRUE(bounds_of(pairs) == truth) << name_of(level) << ", seed " << seed; });
  }
}

TEST(TriangleGaps, OfTrianglesInGeneralPositionAreNarrowOnceRefined) {
  Random random(5);
  int narrow = 0, all = 0;
  for (int i = 0; i < 100; ++i) {
    Pairs pairs;
    for (auto& [a, b] : pairs) {
      a = {{random_point(random, 1), random_point(random, 1), random_point(random, 1)}};
      b = moved({{random_point(random, 1), random_point(random, 1), random_point(random, 1)}}, {0, 0, 2.00001});
    }
    const auto [first, refined] = bounds_of(pairs);
    for (std::size_t lane = 0; lane < lanes; ++lane, ++all)
      narrow += refined.upper[lane] - refined.lower[lane] < 1e-13 * refined.upper[lane] ? 1 : 0;
  }
  EXPECT_GT(narrow, all * 99 / 100);
}

}  // namespace
}  // namespace toccata
