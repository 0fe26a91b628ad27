// A cast that starts in contact: what it is told to stand against, and how it goes on from there.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "toccata/generate/meshes.hpp"
#include "toccata/motion/rigid_motion.hpp"
#include "toccata/query/casts.hpp"
#include "toccata/query/overlap.hpp"

namespace toccata {
namespace {

/// The hit at the start of a cast along x, of what `query` poses; whichever of the two moves, it is the same.
ShapeHit at_start(const Model& a, const Model& b, const PairQuery& query = {}) {
  const std::optional<ShapeHit> hit = cast_shape(a, {1, 0, 0}, b, query);
  EXPECT_TRUE(hit);
  EXPECT_EQ(hit->upper, 0);
  const std::optional<ShapeHit> turning = sweep(a, {query.pose_a, {.turns = 0.25}}, b, query.pose_b);
  EXPECT_EQ(turning->normal, hit->normal);
  EXPECT_EQ(turning->element_a, hit->element_a);
  EXPECT_EQ(turning->element_b, hit->element_b);
  const std::optional<ShapeHit> other = cast_shape(b, {1, 0, 0}, a, {.pose_a = query.pose_b, .pose_b = query.pose_a});
  EXPECT_LT(length(other->normal + hit->normal), 1e-12);
  return hit.value_or(ShapeHit{});
}

void expect_near(const Vec3& found, const Vec3& expected) { EXPECT_LT(length(found - expected), 1e-12); }

const Vec3 up{0, 0, 1};

TEST(CastAtStart, TheNormalIsThatOfWhatIsTouched) {
  const Model floor = Box({5, 5, 1}), ball = Sphere(1);
  expect_near(at_start(Capsule({0, 0, -1}, {0, 0, 1}, 0.5), floor, {.pose_a = Pose::translation(0, 0, 2.5)}).normal,
              up);
  expect_near(at_start(Box({1, 1, 1}), floor, {.pose_a = Pose::translation(0.3, 0, 2)}).normal, up);
  expect_near(at_start(ball, ball, {.pose_a = Pose::translation(0, 0, 2)}).normal, up);
  expect_near(at_start(ball, HalfSpace({0, 0, 0}, up), {.pose_a = Pose::translation(0, 0, 1)}).normal, up);
  expect_near(at_start(Cylinder(1, 2), floor, {.pose_a = Pose::translation(0, 0, 3)}).normal, up);
  expect_near(at_start(ConvexHull({{0, 0, 0}, {1, 0, 2}, {0, 1, 2}, {-1, -1, 2}}), floor,
                       {.pose_a = Pose::translation(0, 0, 1)})
                  .normal,
              up);
}

TEST(CastAtStart, WhatIsDeeperIsToldTheShortestWayOut) {
  expect_near(at_start(Box({1, 1, 1}), Box({5, 5, 1}), {.pose_a = Pose::translation(0.3, 0, 1.75)}).normal, up);
  expect_near(at_start(Sphere(1), Sphere(1), {.pose_a = Pose::translation(0, 0, 1)}).normal, up);
}

TEST(CastAtStart, OfAMeshItIsThatOfTheTriangleWhichIsTold) {
  const TriangleMesh table = generate_mesh("box");
  const Model box(table);
  double top = 0;
  for (const Vec3& v : table.vertices()) top = std::max(top, v.z);
  const std::optional<ShapeHit> hit =
      at_start(Capsule({0, 0, 0}, {0, 0, 1}, 0.5), box, {.pose_a = Pose::translation(0.25, 0.125, top + 0.5)});
  expect_near(hit->normal, up);
  const auto corners = table.triangles()[hit->element_b];
  for (const Index corner : corners) EXPECT_EQ(table.vertices()[corner].z, top);
  const Model ball(generate_mesh("icosphere"));
  EXPECT_LT(dot(at_start(box, ball, {.pose_b = Pose::translation(0, 0, top + 0.9)}).normal, up), 0);
}

TEST(CastAtStart, WhatIsWithinASolidHasNoNormal) {
  const Model room(generate_mesh("box", {{"half-x", 9}, {"half-y", 9}, {"half-z", 9}}));
  const std::optional<ShapeHit> hit = cast_shape(Sphere(1), {1, 0, 0}, room, {.solid_b = Solid::all});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->upper, 0);
  EXPECT_EQ(hit->normal, Vec3{});
}

// What a character controller asks: it stands on the floor, and neither may that stop it nor may it pass the wall.
TEST(CastAtStart, WhatStandsOnAFloorWalksUntilTheWall) {
  const Model body = Capsule({0, 0, 0.5}, {0, 0, 1.5}, 0.5), floor(generate_mesh("height-field", {{"height", 0}}));
  const Model wall = Box({0.5, 5, 5});
  const RigidMotion walk = RigidMotion::straight(Pose{}, {3, 0, 0});
  const double allowed = 0.01;
  ASSERT_TRUE(overlap(body, floor));
  EXPECT_FALSE(sweep(body, walk, floor, Pose{}, {.stop_before = -allowed}));
  EXPECT_FALSE(sweep(body, RigidMotion::straight(Pose{}, {0, 0, 3}), floor, Pose{}, {.stop_before = -allowed}));
  EXPECT_TRUE(sweep(body, RigidMotion::straight(Pose{}, {0, 0, -3}), floor, Pose{}, {.stop_before = -allowed}));
  const std::optional<ShapeHit> hit = sweep(body, walk, wall, Pose::translation(3, 0, 0), {.stop_before = allowed});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->upper * 3, 2 - allowed, 1e-9);
  expect_near(hit->normal, {-1, 0, 0});
}

}  // namespace
}  // namespace toccata
