#include "oracle/penetration.hpp"

#include <gtest/gtest.h>

#include "toccata/core/random.hpp"

namespace toccata::oracle {
namespace {

ConvexSet cube(double half, const Vec3& centre = {}) {
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back(centre +
                      Vec3{(i & 1) != 0 ? half : -half, (i & 2) != 0 ? half : -half, (i & 4) != 0 ? half : -half});
  return box_set(corners);
}

/// Several times as slow: the planes through every three points of A − B that have all others on one side.
Rational brute_force_squared(const ConvexSet& a, const ConvexSet& b) {
  std::vector<RationalPoint> d;
  for (const RationalPoint& p : a.vertices)
    for (const RationalPoint& q : b.vertices) d.push_back(p - q);
  Rational least = -1;
  for (const RationalPoint& p : d)
    for (const RationalPoint& q : d)
      for (const RationalPoint& r : d) {
        const HalfSpace h = half_space(p, cross(q - p, r - p));
        if (is_zero(h.normal) || h.offset < 0) continue;
        if (!std::ranges::all_of(d, [&](const RationalPoint& v) { return height_above(h, v) <= 0; })) continue;
        const Rational squared = h.offset * h.offset / dot(h.normal, h.normal);
        if (least < 0 || squared < least) least = squared;
      }
  return least;
}

TEST(OraclePenetration, CubesPartAlongTheirShortestWay) {
  const ConvexSet a = cube(1);
  const auto sign = [&](const Vec3& centre, double depth) {
    return compare_penetration(a, cube(1, centre), exact(depth));
  };
  EXPECT_EQ(sign({1.5, 0.25, 0}, 0.5), 0);
  EXPECT_EQ(sign({1.5, 0.25, 0}, 0.499), 1);
  EXPECT_EQ(sign({1.5, 0.25, 0}, 0.501), -1);
  EXPECT_EQ(sign({}, 2), 0);
  EXPECT_EQ(sign({2, 0, 0}, 0), 0);
  EXPECT_EQ(sign({3, 0, 0}, 0), 0);
  EXPECT_EQ(sign({3, 0, 0}, 1e-300), -1);
}

TEST(OraclePenetration, RadiiAddToCores) {
  const ConvexSet a = rounded(cube(1), 0.5);
  const auto sign = [&](const Vec3& centre, double depth) {
    return compare_penetration(a, sphere_set(centre, 0.25), exact(depth));
  };
  EXPECT_EQ(sign({0.5, 0, 0}, 1.25), 0);  // centre inside the core: 0.5 + 0.75
  EXPECT_EQ(sign({1.5, 0, 0}, 0.25), 0);  // outside of it
  EXPECT_EQ(sign({1, 0, 0}, 0.75), 0);    // on it
  EXPECT_EQ(sign({1.75, 0, 0}, 0), 0);    // the sets touch
  EXPECT_EQ(compare_penetration(capsule_set({-1, 0, 0}, {1, 0, 0}, 0.5), capsule_set({0, -1, 0}, {0, 1, 0}, 0.25),
                                exact(0.75)),
            0);
  EXPECT_EQ(compare_penetration(sphere_set({}, 0.5), sphere_set({}, 0.25), exact(0.75)), 0);
}

TEST(OraclePenetration, AHalfSpaceIsLeftAlongItsNormal) {
  const HalfSpace ground = half_space_set({0, 0, 1}, {0, 0, 2});
  EXPECT_EQ(compare_penetration(cube(1), ground, 2), 0);
  EXPECT_EQ(compare_penetration(rounded(cube(1), 0.5), ground, exact(2.5)), 0);
  EXPECT_EQ(compare_penetration(cube(1, {0, 0, 2}), ground, 0), 0);
  EXPECT_EQ(compare_penetration(sphere_set({0, 0, 2}, 1.5), ground, exact(0.5)), 0);
  EXPECT_EQ(compare_penetration(sphere_set({0, 0, 2}, 1.5), ground, exact(0.25)), 1);
  EXPECT_EQ(compare_penetration(sphere_set({0, 0, 2}, 1.5), ground, 1), -1);
  EXPECT_EQ(compare_penetration(sphere_set({0, 0, 9}, 1.5), ground, 0), 0);
  EXPECT_EQ(compare_penetration(sphere_set({0, 0, 9}, 1.5), ground, 1), -1);
}

TEST(OraclePenetration, EdgesAndFacesAreAllCandidates) {
  Random random(1);
  const auto whole = [&] { return static_cast<double>(random.below(9)) - 4; };
  const auto random_set = [&] {
    ConvexSet set;
    for (int i = 0; i < 4; ++i) {
      const double x = whole();
      const double y = whole();
      set.vertices.push_back(exact(Vec3{x, y, whole()}));
    }
    return set;
  };
  for (int i = 0; i < 20; ++i) {
    const ConvexSet a = random_set(), b = random_set();
    if (!is_solid(a) || !is_solid(b) || relation(a, b).kind != RelationKind::overlapping) continue;
    const Rational squared = brute_force_squared(a, b);
    for (const double depth : {0.1, 0.5, 1.0, 1.5, 2.0, 3.0})
      EXPECT_EQ(compare_penetration(a, b, exact(depth)), Rational(squared - exact(depth) * exact(depth)).sign())
          << "pair " << i;
  }
}

TEST(OraclePenetration, AMoveByTheDepthParts) {
  const ConvexSet a = cube(1), b = cube(1, {1.5, 0.25, 0});
  EXPECT_EQ(relation(a, moved(b, {Rational(1, 2), 0, 0})).kind, RelationKind::touching);
  EXPECT_EQ(relation(a, moved(b, {Rational(49, 100), 0, 0})).kind, RelationKind::overlapping);
}

}  // namespace
}  // namespace toccata::oracle
