// View culling as a question (METHODS A13): what a camera sees is what overlaps the solid it sees.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"
#include "toccata/query/overlap.hpp"
#include "toccata/query/scene_index.hpp"
#include "toccata/shapes/primitives.hpp"

namespace toccata {
namespace {

/// By the definition, in the camera's own coordinates; at least `slack` off every plane, or nothing is told.
enum class Seen { yes, no, unsure };

Seen seen(const View& view, const Vec3& point, double slack) {
  const auto unit = [](const Vec3& v) { return (1 / std::sqrt(dot(v, v))) * v; };
  const Vec3 ahead = unit(view.direction), right = unit(cross(ahead, view.up)), up = cross(right, ahead);
  const Vec3 from_eye = point - view.eye;
  const double depth = dot(from_eye, ahead);
  const double reach = std::tan(view.field_of_view * 3.141592653589793 / 360) * depth;
  double least = std::min(depth - view.nearest, view.farthest - depth);
  least = std::min(least, reach - std::abs(dot(from_eye, up)));
  least = std::min(least, view.aspect * reach - std::abs(dot(from_eye, right)));
  return least > slack ? Seen::yes : least < -slack ? Seen::no : Seen::unsure;
}

View random_view(Random& random) {
  const auto vector = [&] {
    const double x = random.between(-1, 1), y = random.between(-1, 1), z = random.between(-1, 1);
    return Vec3{x, y, z};
  };
  View view{vector(), vector(), vector()};
  view.field_of_view = random.between(5, 120);
  view.aspect = random.between(0.4, 2.5);
  view.nearest = random.between(0.1, 1);
  view.farthest = view.nearest + random.between(0.5, 5);
  return view;
}

TEST(ViewFrustum, HoldsThePointsThatAreSeenAndNoOthers) {
  int yes = 0, no = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Random random(seed);
    const View view = random_view(random);
    const Model frustum(view_frustum(view));
    for (int i = 0; i < 60; ++i) {
      const Vec3 p = view.eye + random.between(0, 8) * view.direction +
                     Vec3{random.between(-2, 2), random.between(-2, 2), random.between(-2, 2)};
      const Seen expected = seen(view, p, 1e-9);
      if (expected == Seen::unsure) continue;
      ++(expected == Seen::yes ? yes : no);
      EXPECT_EQ(overlap(frustum, Point(p)), expected == Seen::yes) << seed;
    }
  }
  EXPECT_GT(yes, 100);
  EXPECT_GT(no, 100);
}

/// Straight ahead with a right angle of view every corner is a whole number.
TEST(ViewFrustum, HasTheCornersOfItsPlanes) {
  const ConvexHull frustum = view_frustum({.field_of_view = 90, .aspect = 2, .nearest = 1, .farthest = 4});
  ASSERT_EQ(frustum.vertex_count(), 8U);
  EXPECT_EQ(frustum.topology().face_count(), 6U);
  for (Index i = 0; i < 8; ++i) {
    const Vec3 v = frustum.vertex(i);
    EXPECT_TRUE(v.z == -1 || v.z == -4) << v.z;
    EXPECT_DOUBLE_EQ(std::abs(v.y), -v.z);
    EXPECT_DOUBLE_EQ(std::abs(v.x), -2 * v.z);
  }
}

/// A ball beside the corner of the frustum is before none of the six planes as a whole, which is why tests of planes
/// keep it; it is not in view.
TEST(ViewFrustum, WhatTestsOfPlanesKeepIsTold) {
  const SceneInstance frustum{Model(view_frustum({.field_of_view = 90, .nearest = 1, .farthest = 10}))};
  const std::vector<SceneInstance> scene{
      {Model(Box({1, 1, 1})), Pose::translation(0, 0, -5), Solid::automatic, "seen"},
      {Model(Sphere(1)), Pose::translation(10.8, 10.8, -10.5), Solid::automatic, "corner"},
      {Model(Sphere(1)), Pose::translation(0, 0, -11), Solid::automatic, "touching"},
      {Model(Box({1, 1, 1})), Pose::translation(0, 0, 5), Solid::automatic, "behind"}};
  EXPECT_EQ(SceneIndex(scene).overlapping(frustum), (std::vector<Index>{0, 2}));
  // The ball's centre is less than its radius beyond the two sides and the far plane.
  EXPECT_LT((10.8 - 10.5) / std::sqrt(2), 1);
  EXPECT_LT(10.5 - 10, 1);
}

TEST(ViewFrustum, NumbersOutOfRangeAreErrors) {
  EXPECT_THROW((void)view_frustum({.direction = {0, 0, 0}}), Error);
  EXPECT_THROW((void)view_frustum({.direction = {0, 1, 0}}), Error);  // along up
  EXPECT_THROW((void)view_frustum({.field_of_view = 180}), Error);
  EXPECT_THROW((void)view_frustum({.field_of_view = 0}), Error);
  EXPECT_THROW((void)view_frustum({.aspect = 0}), Error);
  EXPECT_THROW((void)view_frustum({.nearest = 0}), Error);
  EXPECT_THROW((void)view_frustum({.nearest = 5, .farthest = 5}), Error);
  EXPECT_THROW((void)view_frustum({.eye = {1e300, 0, 0}}), Error);
  EXPECT_THROW((void)view_frustum({.farthest = HUGE_VAL}), Error);
}

}  // namespace
}  // namespace toccata
