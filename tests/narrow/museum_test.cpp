#include "narrow/museum.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "toccata/core/random.hpp"
#include "toccata/math/pose.hpp"

// Failures of other libraries with convex shapes, as their users described them: where a report tells a configuration
// without its numbers, it is made here, and the comment says so. Those with their own numbers: museum_reports_test.cpp.
namespace toccata {
namespace {

using namespace museum;

// libccd#25: no direction (NaN) for two stacked cubes. Made here: unit cubes, the upper 0.01 deep in the lower, and
// exactly upon it.
TEST(Museum, Libccd25StackedCubesHaveADirection) {
  const Penetration p = penetration(cube(1), cube(1, at(0, 0, 0.99)));
  EXPECT_EQ(p.direction, (Vec3{0, 0, 1}));
  EXPECT_NEAR(p.upper, 0.01, 1e-13);
  expect_right(cube(1), cube(1, at(0, 0, 0.99)));
  expect_right(cube(1), cube(1, at(0, 0, 1)));
  const Manifold m = manifold(cube(1), cube(1, at(0, 0, 1)));
  EXPECT_EQ(m.count, 4);
  EXPECT_EQ(m.normal, (Vec3{0, 0, 1}));
}

// libccd#17: a wrong point for boxes of 5 m and 0.2 m. Made here: the small one on the large one's top.
TEST(Museum, Libccd17ASmallBoxOnALargeOneHasItsPointThere) {
  const PosedPolytope large = cube(5), small = cube(0.25, at(1, 2, 2.75));
  const Distance d = distance(large, small);
  EXPECT_EQ(d.lower, 0.125);
  EXPECT_EQ(d.upper, 0.125);
  EXPECT_EQ(d.on_a, (Vec3{0.875, 1.875, 2.5}));  // of all pairs the least
  EXPECT_EQ(d.on_b, (Vec3{0.875, 1.875, 2.625}));
}

// fcl#319, #390, #398, #493, #495: exceptions ("should not happen", "the origin is outside of the polytope") on plain
// boxes. Made here: boxes that touch in faces, edges and corners, and cover each other, under whole and general turns.
TEST(Museum, Fcl319PlainBoxesNeverThrow) {
  for (const double gap : {-0.5, -1e-9, -1e-15, 0.0, 1e-15, 1e-9})
    for (const Vec3& way : {Vec3{1, 0, 0}, Vec3{1, 1, 0}, Vec3{1, 1, 1}, Vec3{1, 0.5, 0.25}}) {
      const Pose place{{}, (1 + gap) * way};
      expect_right(cube(1), cube(1, place));
      expect_right(PosedPolytope(Box({0.5, 0.25, 0.01})), PosedPolytope(Box({0.01, 0.5, 0.5}), place));
    }
}

// fcl#366: a search that did not converge is told as "separated". Made here: 500 cubes of size 1 turned at random, deep
// in each other.
TEST(Museum, Fcl366DeepOverlapsAreNeverCalledSeparated) {
  Random random(366);
  for (int i = 0; i < 500; ++i) {
    const double x = random.between(-1, 1);
    const double y = random.between(-1, 1);
    const double z = random.between(-1, 1);
    const Mat3 turned = rotation_of({x, y, z, 0.5});
    ASSERT_TRUE(overlap(cube(1), cube(1, {turned, {0.4 * x, 0.4 * y, 0.4 * z}})));
  }
}

// openGJK#13: 2 of 10,000 pairs of cubes that overlap are told apart. Made here: 2,000 cubes around the distance at
// which they begin to touch.
TEST(Museum, OpenGjk13NoFalseNegativesOnCubes) {
  Random random(13);
  for (int i = 0; i < 2000; ++i) {
    const double x = random.between(-1.2, 1.2);
    const double y = random.between(-1.2, 1.2);
    const double z = random.between(-1.2, 1.2);
    const bool truth = std::max({std::abs(x), std::abs(y), std::abs(z)}) <= 1;
    ASSERT_EQ(overlap(cube(1, at(0, 0, 0)), cube(1, at(x, y, z))), truth) << x << " " << y << " " << z;
  }
}

// andreacasalino/Flexible-GJK-and-EPA#8, fcl#243, libccd#7: searches that hang on parallel faces. Made here: plates
// that are turned alike, with gaps and overlaps of a last place.
TEST(Museum, FlexibleGjk8ParallelFacesEnd) {
  const Mat3 turned = rotation_of({0.1, 0.2, 0.3, 0.9});
  for (const double gap : {-1e-16, 0.0, 1e-16, 1e-14, 1e-8}) {
    const Pose lower{turned, {}};
    const PosedPolytope a(Box({1, 1, 0.1}), lower);
    const PosedPolytope b(Box({1, 1, 0.1}), {turned, transform(lower, {0.5, 0.25, 0.2 + gap})});
    expect_right(a, b);
  }
}

// fcl#375: a zero normal. Made here: spheres with one centre, capsules on one axis, a sphere centred on a face.
TEST(Museum, Fcl375ConcentricShapesHaveANormal) {
  const PosedPolytope ball{Sphere(1)}, smaller{Sphere(0.25)}, capsule{Capsule({0, 0, -1}, {0, 0, 1}, 0.5)};
  for (const PosedPolytope* other : {&ball, &smaller, &capsule}) {
    EXPECT_TRUE(is_unit(penetration(ball, *other).direction));
    EXPECT_TRUE(is_unit(manifold(ball, *other).normal));
    expect_right(ball, *other);
  }
  EXPECT_TRUE(is_unit(penetration(cube(1), PosedPolytope(Sphere(0.25), at(0.5, 0, 0))).direction));
}

// fcl#545: the normal points to a corner, and the depth is √3 times too large. Made here: a sphere in a cube's middle.
TEST(Museum, Fcl545ASphereLeavesABoxThroughAFace) {
  const Penetration p = penetration(cube(2), PosedPolytope(Sphere(0.5)));
  EXPECT_NEAR(p.upper, 1.5, 1e-12);
  EXPECT_EQ(std::max({std::abs(p.direction.x), std::abs(p.direction.y), std::abs(p.direction.z)}), 1);
}

// Jolt PR#2108: a depth of 7.25 m for shapes that touch; Jolt#940: up to 16 m. Made here: large boxes that touch.
TEST(Museum, Jolt2108WhatTouchesHasNoDepth) {
  for (const double size : {0.1, 1.0, 16.0, 1024.0}) {
    const Penetration p = penetration(cube(size), cube(size, at(size, size / 4, 0)));
    EXPECT_EQ(p.lower, 0);
    EXPECT_EQ(p.upper, 0);
    EXPECT_EQ(relation(cube(size), cube(size, at(size, size / 4, 0))).kind, RelationKind::touching);
  }
}

// distance3d#78: the depth is 11.8 for (A, B) and 198.8 for (B, A). Made here: a long box through a flat one.
TEST(Museum, Distance3d78DepthIsTheSameBothWaysRound) {
  const Mat3 turned = rotation_of({0.3, 0.1, 0.2, 0.9});
  const PosedPolytope a(Box({100, 5, 5})), b(Box({20, 30, 2}), {turned, {3, 2, 1}});
  EXPECT_EQ(penetration(a, b).upper, penetration(b, a).upper);
  EXPECT_EQ(penetration(a, b).lower, penetration(b, a).lower);
  expect_right(a, b);
}

// parry#378: the expansion is stuck and a witness point is wrong. Made here: a thin wedge in a box.
TEST(Museum, Parry378AWedgeInABoxHasWitnessesOnBoth) {
  const std::array<Vec3, 6> wedge{{{0, 0, 0}, {1, 1e-7, 0}, {1, -1e-7, 0}, {0, 0, 1}, {1, 1e-7, 1}, {1, -1e-7, 1}}};
  const ConvexHull hull(wedge);
  const PosedPolytope thin(hull, at(0.4, 0.1, -0.5));
  expect_right(cube(1), thin);
  const Penetration p = penetration(cube(1), thin);
  EXPECT_NEAR(std::abs(dot(p.on_a - p.on_b, p.direction)), p.upper, 1e-12);
}

// coal#144: one contact, in a corner, makes boxes spin. Made here: a box on a box.
TEST(Museum, Coal144AFaceContactHasFourPoints) {
  const Manifold m = manifold(cube(1), cube(0.5, at(0.125, 0.125, 0.7499)));
  EXPECT_EQ(m.count, 4);
  EXPECT_NEAR(m.normal.z, 1, 1e-15);
}

// PEERS: Jolt counts shapes 1e-4 apart as touching and drops shallow contacts; every library fails on shapes of size
// 1e-6; 150 of 150 tiny shapes in huge ones are missed.
TEST(Museum, SizesDoNotMatter) {
  EXPECT_FALSE(overlap(cube(1), cube(1, at(1.0001, 0, 0))));
  EXPECT_TRUE(overlap(cube(1), cube(1, at(0.999999, 0, 0))));
  EXPECT_TRUE(overlap(cube(1e-6), cube(1e-6, at(0.99e-6, 0, 0))));
  EXPECT_FALSE(overlap(cube(1e-6), cube(1e-6, at(1.01e-6, 0, 0))));
  expect_right(cube(1e-6), cube(1e-6, at(0.99e-6, 0.3e-6, 0)));
  EXPECT_EQ(relation(cube(1e6), cube(1e-6, at(1000, 2000, 3000))).containment, Containment::b_in_a);
}

// godot#48905, jsk_roseus#616: a hidden margin of 4 cm; cubes of size 10 have a distance that is off by 70. Made here.
TEST(Museum, JskRoseus616NoHiddenMargin) {
  const Distance d = distance(cube(10), cube(10, at(80, 0, 0)));
  EXPECT_EQ(d.lower, 70);
  EXPECT_EQ(d.upper, 70);
}

// PEERS: libccd gives wrong normals on every exact face contact and misses 8 of 8 vertex contacts.
TEST(Museum, CubesThatTouchInACornerMeet) {
  for (int i = 0; i < 8; ++i) {
    const PosedPolytope other = cube(1, at((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1));
    EXPECT_EQ(relation(cube(1), other).kind, RelationKind::touching);
    EXPECT_EQ(manifold(cube(1), other).count, 1);
  }
}

// PEERS: FCL's default penetration is not minimal in 77 % of deep pairs; its box–box, as Bullet's and ODE's, prefers
// faces although edges are nearer by up to a twentieth (0.049 here, seen by `bench convex --pair box --regime deep`).
TEST(Museum, BoxesPartAlongEdgesWhereThatIsShorter) {
  Random random(77);
  for (int i = 0; i < 100; ++i) {
    const double x = random.between(-1, 1);
    const double y = random.between(-1, 1);
    const double z = random.between(-1, 1);
    expect_right(PosedPolytope(Box({0.5, 0.7, 0.9})),
                 PosedPolytope(Box({0.6, 0.4, 0.8}), {rotation_of({x, y, z, 0.4}), {z, x, y}}));
  }
}

// PEERS: box in the corner of a larger one: touching in three faces and overlapping.
TEST(Museum, ABoxInTheCornerOfALargerOneIsInside) {
  const Relation r = relation(cube(2), cube(1, at(0.5, 0.5, 0.5)));
  EXPECT_EQ(r.kind, RelationKind::overlapping);
  EXPECT_EQ(r.containment, Containment::b_in_a);
  EXPECT_NEAR(penetration(cube(2), cube(1, at(0.5, 0.5, 0.5))).upper, 1, 1e-12);
}

}  // namespace
}  // namespace toccata
