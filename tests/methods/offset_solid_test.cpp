#include "toccata/methods/minkowski.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "oracle/convex.hpp"
#include "oracle/hull_boundary.hpp"
#include "support/convex_cases.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

/// How far along a direction from a vertex a test still accepts points.
template <class Test>
double reach(const Vec3& from, const Vec3& direction, Test accepts) {
  const Vec3 unit = (1 / std::sqrt(dot(direction, direction))) * direction;
  double inside = 0, outside = 1e6;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (inside + outside);
    (accepts(from + middle * unit) ? inside : outside) = middle;
  }
  return inside;
}

struct Reaches {
  double moved, beveled, exact;
};

Reaches reaches(const OffsetSolid& grown, const Vec3& from, const Vec3& direction) {
  return {reach(from, direction, [&](const Vec3& p) { return grown.in_moved_planes(p); }),
          reach(from, direction, [&](const Vec3& p) { return grown.in_beveled_planes(p); }),
          reach(from, direction, [&](const Vec3& p) { return grown.contains(p); })};
}

// Why is the test a hack? At edges and corners it accepts points that are too far away.
TEST(LectureQuestion, MovedPlanesReachTooFarAtEdgesAndCorners) {
  const OffsetSolid box(PosedPolytope(Box{{1, 1, 1}}), 0.5);
  const Reaches face = reaches(box, {1, 0, 0}, {1, 0, 0});
  EXPECT_NEAR(face.moved, 0.5, 1e-12);
  EXPECT_NEAR(face.exact, 0.5, 1e-12);
  const Reaches edge = reaches(box, {1, 1, 0}, {1, 1, 0});
  EXPECT_NEAR(edge.moved, std::sqrt(2.0) * 0.5, 1e-12);
  EXPECT_NEAR(edge.beveled, 0.5, 1e-12);
  EXPECT_NEAR(edge.exact, 0.5, 1e-12);
  const Reaches corner = reaches(box, {1, 1, 1}, {1, 1, 1});
  EXPECT_NEAR(corner.moved, std::sqrt(3.0) * 0.5, 1e-12);  // (√3 − 1) r too far: 73 % of r
  EXPECT_NEAR(corner.beveled, 0.5, 1e-12);
  EXPECT_NEAR(corner.exact, 0.5, 1e-12);
}

// With r the error grows in proportion, and at a sharp edge without bound.
TEST(LectureQuestion, MovedPlanesReachAnyDistanceAtSharpEdges) {
  for (const double degrees : {90.0, 60.0, 20.0, 5.0, 1.0}) {
    const double half = 0.5 * degrees * 3.14159265358979323846 / 180, height = 4 * std::tan(half);
    const ConvexHull wedge(std::vector<Vec3>{
        {0, -9, 0}, {0, 9, 0}, {-4, -9, height}, {-4, 9, height}, {-4, -9, -height}, {-4, 9, -height}});
    const OffsetSolid grown(PosedPolytope(wedge), 0.25);
    const Reaches edge = reaches(grown, {0, 0, 0}, {1, 0, 0});
    EXPECT_NEAR(edge.moved, 0.25 / std::sin(half), 1e-9) << degrees;
    EXPECT_NEAR(edge.beveled, 0.25, 1e-9) << degrees;
    EXPECT_NEAR(edge.exact, 0.25, 1e-12) << degrees;
  }
}

TEST(OffsetSolid, BevelsOfABoxErrByAnEighthOfTheDistance) {
  const OffsetSolid box(PosedPolytope(Box{{1, 1, 1}}), 1);
  double moved = 0, beveled = 0;
  for (int i = 0; i <= 40; ++i)
    for (int j = 0; j <= i; ++j) {
      const Vec3 direction{1, i / 40.0, j / 40.0};
      const Reaches r = reaches(box, {1, 1, 1}, direction);
      EXPECT_NEAR(r.exact, 1, 1e-12);
      moved = std::max(moved, r.moved - 1);
      beveled = std::max(beveled, r.beveled - 1);
    }
  EXPECT_NEAR(moved, std::sqrt(3.0) - 1, 1e-12);
  EXPECT_GT(beveled, 0.12);
  EXPECT_LT(beveled, 0.1281);  // where x = 1, x + y = √2 and x + y + z = √3
}

TEST(OffsetSolid, AgreesWithTheOracleAndEachTestAcceptsMore) {
  int accepted[4] = {};
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Random random(seed);
    const test::ConvexCase pair = test::convex_case("hull", "box", test::convex_regimes()[seed % 15], random);
    const PosedPolytope solid = test::posed(seed % 2 == 0 ? pair.a : pair.b);
    oracle::ConvexSet set = test::set_of(seed % 2 == 0 ? pair.a : pair.b);
    if (!oracle::is_solid(set) || set.vertices.size() > 12) continue;
    const Vec3 v = solid.vertex(0), w = solid.vertex(1);
    const double r = std::sqrt(dot(w - v, w - v));
    const OffsetSolid grown(solid, r);
    const auto faces = oracle::boundary(set.vertices, oracle::spanning(set.vertices));
    set.radius = oracle::exact(r);
    for (const Vec3& offset :
         {Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{0.6, 0.8, 0}, Vec3{-0.7, 0.7, 0.7}, Vec3{0.5, 0.1, -2}})
      for (const Vec3& from : {v, w, 0.5 * (v + w)}) {
        const Vec3 p = from + r * offset;
        const bool exact = oracle::side_of(oracle::exact(p), set) <= 0;
        bool moved = true;
        for (const auto& face : faces) {
          const oracle::Rational height = height_above(face.behind, oracle::exact(p));
          moved &=
              height <= 0 || height * height <= set.radius * set.radius * dot(face.behind.normal, face.behind.normal);
        }
        ASSERT_EQ(grown.contains(p), exact) << seed;
        ASSERT_EQ(grown.in_moved_planes(p), moved) << seed;
        const bool beveled = grown.in_beveled_planes(p);
        ASSERT_TRUE(!exact || beveled) << seed;
        ASSERT_TRUE(!beveled || moved) << seed;
        ++accepted[exact ? 0 : beveled ? 1 : moved ? 2 : 3];
      }
  }
  for (const int count : accepted) EXPECT_GT(count, 3);
}

TEST(OffsetSolid, RefusesSurfacesAndNegativeDistances) {
  EXPECT_THROW(OffsetSolid(PosedPolytope(Segment({0, 0, 0}, {1, 0, 0})), 1), Error);
  EXPECT_THROW(OffsetSolid(PosedPolytope(Sphere(1)), 1), Error);
  EXPECT_THROW(OffsetSolid(PosedPolytope(Box{{1, 1, 1}}), -1), Error);
}

TEST(OffsetSolid, RefusesPointsThatAreNotFinite) {
  const OffsetSolid grown(PosedPolytope(Box{{1, 1, 1}}), 0.5);
  for (const double bad : {HUGE_VAL, -HUGE_VAL, std::nan("")}) {
    EXPECT_THROW(static_cast<void>(grown.in_moved_planes({0, bad, 0})), Error);
    EXPECT_THROW(static_cast<void>(grown.in_beveled_planes({0, bad, 0})), Error);
    EXPECT_THROW(static_cast<void>(grown.contains({0, bad, 0})), Error);
  }
}

}  // namespace
}  // namespace toccata
