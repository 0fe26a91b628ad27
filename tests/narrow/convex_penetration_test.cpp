#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "support/simd_levels.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/narrow/convex_convex.hpp"

// Named cases: the lectures' questions, and where other libraries are known to fail.
namespace toccata {
namespace {

Pose standing_at(double x, double y, double z) { return Pose::translation(x, y, z); }

bool contains(const Penetration& p, double depth) { return p.lower <= depth && depth <= p.upper; }

void expect_depth(const PosedPolytope& a, const PosedPolytope& b, double depth) {
  for (const Penetration& p :
       {penetration(a, b), penetration_by_expansion(a, b), penetration_by_separating_axes(a, b)}) {
    EXPECT_TRUE(contains(p, depth)) << p.lower << ' ' << depth << ' ' << p.upper;
    EXPECT_LE(p.upper - p.lower, 0x1p-39 * p.upper);
    EXPECT_NEAR(dot(p.direction, p.direction), 1, 1e-14);
    EXPECT_EQ(p.status, Status::exact);
  }
}

TEST(ConvexPenetration, OfIdenticalCubesIsTheirEdge) {
  const PosedPolytope cube(Box({0.5, 0.5, 0.5}));
  expect_depth(cube, cube, 1);
}

// danfis/libccd#25: the direction of two stacked cubes is NaN.
TEST(ConvexPenetration, OfStackedCubesIsZeroWithADirection) {
  const PosedPolytope below(Box({0.5, 0.5, 0.5})), above(Box({0.5, 0.5, 0.5}), standing_at(0, 0, 1));
  expect_depth(below, above, 0);
  EXPECT_EQ(penetration(below, above).direction, (Vec3{0, 0, 1}));
}

// Jolt drops contacts that are 1e-6 deep, and what is tiny in what is huge.
TEST(ConvexPenetration, OfShallowContactsIsRelativelyRight) {
  for (const double depth : {0x1p-20, 0x1p-30, 0x1p-40, 0x1p-50})
    expect_depth(PosedPolytope(Box({1, 1, 1})), PosedPolytope(Box({1, 1, 1}), standing_at(2 - depth, 0.25, 0.5)),
                 depth);
}

TEST(ConvexPenetration, OfATinyShapeDeepInAHugeOneIsTheWayToTheNearestFace) {
  expect_depth(PosedPolytope(Box({0x1p20, 0x1p20, 0x1p20})), PosedPolytope(Box({0x1p-20, 0x1p-20, 0x1p-20})),
               0x1p20 + 0x1p-20);
}

TEST(ConvexPenetration, OfConcentricSpheresIsTheSumOfTheirRadii) {
  const PosedPolytope a{Sphere(1)}, b{Sphere(0.25)};
  expect_depth(a, b, 1.25);
  expect_depth(a, a, 2);
}

TEST(ConvexPenetration, OfCrossingCapsulesIsAlongTheirCommonNormal) {
  const PosedPolytope a(Capsule({-1, 0, 0}, {1, 0, 0}, 0.25)), b(Capsule({0, -1, 0}, {0, 1, 0}, 0.5));
  expect_depth(a, b, 0.75);
  EXPECT_EQ(std::fabs(penetration(a, b).direction.z), 1);
}

TEST(ConvexPenetration, OfASphereWithItsCentreInABoxIsTheWayOutAndTheRadius) {
  expect_depth(PosedPolytope(Box({1, 2, 3})), PosedPolytope(Sphere(0.5), standing_at(0.75, 0.5, 1)), 0.75);
}

TEST(ConvexPenetration, OfACapsuleInABoxIsDefinedForItsFlatCore) {
  expect_depth(PosedPolytope(Box({1, 2, 3})), PosedPolytope(Capsule({0, -1, 0}, {0, 1, 0}, 0.5)), 1.5);
}

TEST(ConvexPenetration, OfShapesApartIsZero) {
  expect_depth(PosedPolytope(Box({1, 1, 1})), PosedPolytope(Box({1, 1, 1}), standing_at(5, 5, 5)), 0);
  expect_depth(PosedPolytope(Sphere(1)), PosedPolytope(Sphere(1), standing_at(5, 5, 5)), 0);
}

// Apart by less than the least double: of the facets of their difference one has the origin before it, and another,
// which doubles cannot tell from it, has it behind.
double reach(const PosedPolytope& shape, const Vec3& direction) {
  double farthest = -std::numeric_limits<double>::infinity();
  for (Index i = 0; i < shape.vertex_count(); ++i) farthest = std::max(farthest, dot(direction, shape.vertex(i)));
  return farthest + shape.radius();
}

TEST(ConvexPenetration, OfShapesApartHasADirectionAlongWhichTheyAre) {
  Random random(31);
  const auto coordinates = [&](double size) {
    return Vec3{random.between(-size, size), random.between(-size, size), random.between(-size, size)};
  };
  int apart = 0;
  for (int k = 0; k < 300; ++k) {
    std::vector<Vec3> points(10);
    for (Vec3& point : points) point = coordinates(1);
    const ConvexHull hull(points);
    const Pose pose_a = Pose::rotation(coordinates(1), 40),
               pose_b = Pose::translation(coordinates(4)) * pose_a * pose_a;
    const PosedPolytope a = k % 3 == 0 ? PosedPolytope(Rounded(hull, 0.25), pose_a) : PosedPolytope(hull, pose_a);
    const PosedPolytope b =
        k % 2 == 0 ? PosedPolytope(Capsule({-1, 0, 0}, {1, 0.5, 0}, 0.5), pose_b) : PosedPolytope(hull, pose_b);
    const Penetration found = penetration(a, b), exchanged = penetration(b, a);
    if (overlap(a, b)) continue;
    ++apart;
    const Vec3& n = found.direction;
    EXPECT_EQ(found.upper, 0);
    EXPECT_NEAR(dot(n, n), 1, 1e-14);
    EXPECT_LT(reach(a, n), -reach(b, -n));
    EXPECT_NEAR(dot(n, found.on_a), reach(a, n), 1e-13);
    EXPECT_NEAR(dot(n, found.on_b), -reach(b, -n), 1e-13);
    EXPECT_TRUE(exchanged.direction == -n && exchanged.on_a == found.on_b && exchanged.on_b == found.on_a);
  }
  EXPECT_GT(apart, 200);
}

TEST(ConvexPenetration, OfShapesApartByLessThanADoubleIsZero) {
  const double hair = std::numeric_limits<double>::denorm_min();
  const std::vector<Vec3> of_a{{3, -1 + 0x1p-53, 6}, {4, 0, 7},  {2, -hair, 5}, {4, -2 + 0x1p-52, 6}, {3, 0, 5},
                               {4, -3 + 0x1p-51, 6}, {2, -1, 5}, {3, -3, 5},    {3, -2 - 0x1p-51, 4}};
  const std::vector<Vec3> of_b{{4, 3, 5}, {4, 2, 2}, {5, 0, 3}, {2, 0, 5}, {5, 0, 4}, {2, 0, 4}};
  const ConvexHull a(of_a), b(of_b);
  EXPECT_FALSE(overlap(PosedPolytope(a), PosedPolytope(b)));
  EXPECT_EQ(penetration(PosedPolytope(a), PosedPolytope(b)).upper, 0);
  EXPECT_EQ(penetration_by_separating_axes(PosedPolytope(a), PosedPolytope(b)).upper, 0);
}

TEST(ConvexPenetration, DoesNotDependOnWhereAndHowLargeTheShapesAre) {
  for (const double scale : {0x1p-20, 0x1p-300, 0x1p300})
    expect_depth(PosedPolytope(Box({scale, scale, scale})),
                 PosedPolytope(Box({scale, scale, scale}), standing_at(1.5 * scale, 0, 0)), 0.5 * scale);
  const double far = 0x1p30;
  expect_depth(PosedPolytope(Box({1, 1, 1}), standing_at(far, far, far)),
               PosedPolytope(Box({1, 1, 1}), standing_at(far + 1.5, far, far)), 0.5);
}

TEST(ConvexPenetration, OfSurfacesIsAnError) {
  const PosedPolytope solid(Box({1, 1, 1})), flat(Triangle{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}});
  EXPECT_THROW(static_cast<void>(penetration(solid, flat)), Error);
  EXPECT_THROW(static_cast<void>(penetration_by_separating_axes(flat, solid)), Error);
}

/// Points on a sphere: a hull of which every point is a vertex.
ConvexHull ball_hull(Random& random, int count) {
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    const double x = random.between(-1, 1), y = random.between(-1, 1), z = random.between(-1, 1);
    points.push_back((1 / std::sqrt(x * x + y * y + z * z + 1e-9)) * Vec3{x, y, z});
  }
  return ConvexHull(points);
}

TEST(ConvexPenetration, OfBothMethodsIsTheSame) {
  Random random(7);
  for (int i = 0; i < 40; ++i) {
    const ConvexHull hull_a = ball_hull(random, 20), hull_b = ball_hull(random, 40);
    const double x = random.between(-1, 1), y = random.between(-1, 1), z = random.between(-1, 1);
    const PosedPolytope a(hull_a), b(hull_b, standing_at(x, y, z));
    const Penetration p = penetration_by_expansion(a, b), q = penetration_by_separating_axes(a, b);
    EXPECT_LE(std::max(p.lower, q.lower), std::min(p.upper, q.upper));
    EXPECT_EQ(p.status, Status::exact);
    EXPECT_TRUE(overlap_by_separating_axes(a, b));
  }
}

// A face of one and a vertex of the other: two edges of the faces have the same normal, but do not meet.
TEST(SeparatingAxes, OfOneTetrahedronTwiceHaveTheirPointsOnBoth) {
  const std::vector<Vec3> corners{{-1.4706262369694867e-16, -58136.97855902966, 1.6684012340269923e+17},
                                  {1.0306189379146549e+17, 3.2581433994054845e-07, 4.815453430751474e-12},
                                  {-1.917211583315568e-09, 1.7959356069586768e+17, 2.1382728023076042e-05},
                                  {0, -7.5699421533826585e-14, -0.030650802180207749}};
  const ConvexHull hull(corners);
  const Penetration p = penetration_by_separating_axes(PosedPolytope(hull), PosedPolytope(hull));
  EXPECT_LE(distance(PosedPolytope(Point(p.on_a)), PosedPolytope(hull)).upper, 1e6);
  EXPECT_LE(distance(PosedPolytope(Point(p.on_b)), PosedPolytope(hull)).upper, 1e6);
}

// The squares of the short edges underflow.
TEST(SeparatingAxes, OfEdgesTooShortForTheirSquaresLeaveNoDoubt) {
  const PosedPolytope triangle(Triangle{{Vec3{0, 1e5, 0}, Vec3{0, 0, -3e-26}, Vec3{0, 0, -4e205}}});
  const std::vector<Vec3> corners{
      {-1e132, -1e208, 0}, {-1e160, 0, 0}, {-1e132, 2e64, 0}, {-1e132, 0, 4e203}, {4e172, 0, -5e137}};
  const ConvexHull hull(corners);
  EXPECT_EQ(overlap_by_separating_axes(triangle, PosedPolytope(hull)), overlap(triangle, PosedPolytope(hull)));
}

// Two long boxes across each other: of the triangles of the facet between them, only some hold the points.
TEST(ConvexPenetration, OfTwoFacesOverEachOtherHasItsPointsOnBoth) {
  const Box beam({7.2766334986734344, 2.4219240670679155, 3.0537355872677389},
                 {-4.5812162789204066, -0.49026383611256509, 2.7589031228962008});
  const PosedPolytope along(beam), across(beam, {rotation_about({0, 0, 1}, 90), {}});
  for (const Penetration& p :
       {penetration_by_expansion(along, across), penetration_by_separating_axes(along, across),
        penetration_by_expansion(across, along), penetration_by_separating_axes(across, along)}) {
    const bool first = p.direction.x > 0;
    EXPECT_LE(distance(PosedPolytope(Point(p.on_a)), first ? along : across).upper, 1e-9);
    EXPECT_LE(distance(PosedPolytope(Point(p.on_b)), first ? across : along).upper, 1e-9);
  }
}

TEST(SeparatingAxes, KeepTheAxisThatSeparatedLast) {
  Random random(8);
  const ConvexHull hull = ball_hull(random, 32);
  const PosedPolytope a(hull), b(hull, standing_at(2.5, 0, 0));
  SimplexCache workspace;
  EXPECT_FALSE(overlap_by_separating_axes(a, b, &workspace));
  EXPECT_NE(workspace.direction, Vec3{});
  EXPECT_FALSE(overlap_by_separating_axes(a, PosedPolytope(hull, standing_at(2.51, 0, 0)), &workspace));
}

TEST(SeparatingAxes, OfBoxesTellTouchingFromALastPlace) {
  const PosedPolytope cube(Box({1, 1, 1}));
  EXPECT_TRUE(overlap_by_separating_axes(cube, PosedPolytope(Box({1, 1, 1}), standing_at(2, 2, 2))));
  EXPECT_FALSE(
      overlap_by_separating_axes(cube, PosedPolytope(Box({1, 1, 1}), standing_at(2, 2, std::nextafter(2, 3)))));
}

TEST(SeparatingAxes, OfBoxesNeedTheEdgePairs) {
  // Two bars, each turned about its own length by an eighth: only the cross product of two edges separates them.
  const PosedPolytope below(Box({2, 0.5, 0.5}), {rotation_about({1, 0, 0}, 45), {}});
  const PosedPolytope above(Box({0.5, 2, 0.5}), {rotation_about({0, 1, 0}, 45), {0, 0, 1.42}});
  EXPECT_FALSE(overlap_by_separating_axes(below, above));
}

/// Where splitting a double for an exact product overflows, and a fused operation would not.
TEST(ConvexPenetration, OfHugeHullsHasTheSameBitsAtEveryLevel) {
  Random random(17);
  int deep = 0;
  for (int i = 0; i < 60; ++i) {
    const auto points = [&](double offset) {
      std::vector<Vec3> result;
      for (int k = 0; k < 8; ++k)
        result.push_back({random.between(-1, 1) + offset, random.between(-1, 1), random.between(-1, 1)});
      return ConvexHull(result);
    };
    const ConvexHull hull_a = points(0), hull_b = points(0.75);
    for (const int exponent : {245, 250, 256}) {
      const PosedPolytope a = PosedPolytope(hull_a).scaled(exponent), b = PosedPolytope(hull_b).scaled(exponent);
      std::vector<Penetration> found;
      test::at_every_simd_level([&](SimdLevel) { found.push_back(penetration(a, b)); });
      for (const Penetration& p : found) EXPECT_EQ(p, found.front()) << i << ' ' << exponent;
      deep += found.front().upper > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(deep, 60);
}

}  // namespace
}  // namespace toccata
