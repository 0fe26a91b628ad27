// Shapes with a radius and half-spaces under poses that are rotations but for a drift: the core is posed as given.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "oracle/convex.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/query/model.hpp"
#include "toccata/query/overlap.hpp"
#include "toccata/query/relation.hpp"

namespace toccata {
namespace {

Vec3 vector(Random& random, double size) {
  return {random.between(-size, size), random.between(-size, size), random.between(-size, size)};
}

Pose drifted(Random& random, double by, double reach) {
  Pose pose{rotation_about(vector(random, 1) + Vec3{0, 0, 2}, random.between(-180, 180)), vector(random, reach)};
  for (Vec3& row : pose.linear.row) row += vector(random, by);
  return pose;
}

struct Made {
  Model model;
  oracle::ConvexSet set;  ///< of a half-space without vertices
  oracle::HalfSpace half_space;
  bool is_half_space = false;
};

oracle::ConvexSet posed_box(const Box& box, const Pose& pose, double radius) {
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i) corners.push_back(pose * box.corner(i));
  return oracle::rounded(oracle::box_set(corners), radius);
}

Made made(Random& random, const Pose& pose) {
  const double radius = random.between(0.1, 1);
  const Vec3 p = vector(random, 1), q = vector(random, 1);
  const Box box({random.between(0.1, 1), random.between(0.1, 1), random.between(0.1, 1)}, vector(random, 0.3));
  switch (random.below(5)) {
    case 0:
      return {Sphere(radius, p), oracle::sphere_set(pose * p, radius), {}};
    case 1:
      return {Capsule(p, q, radius), oracle::capsule_set(pose * p, pose * q, radius), {}};
    case 2:
      return {Rounded(box, radius), posed_box(box, pose, radius), {}};
    case 3:
      return {box, posed_box(box, pose, 0), {}};
    default:
      return {HalfSpace(p, q), {}, oracle::half_space_set(pose * p, Pose{pose.linear, {}} * q), true};
  }
}

bool oracle_overlap(const Made& a, const Made& b) {
  if (a.is_half_space && b.is_half_space) return oracle::overlap(a.half_space, b.half_space);
  if (a.is_half_space) return oracle::overlap(b.set, a.half_space);
  return b.is_half_space ? oracle::overlap(a.set, b.half_space) : oracle::overlap(a.set, b.set);
}

/// The sign of (exact distance) − gap.
int compared(const Made& a, const Made& b, double gap) {
  if (a.is_half_space) return oracle::compare_distance(b.set, a.half_space, oracle::exact(gap));
  return b.is_half_space ? oracle::compare_distance(a.set, b.half_space, oracle::exact(gap))
                         : oracle::compare_distance(a.set, b.set, oracle::exact(gap));
}

TEST(DriftedPoses, AnswersAreThoseOfTheCorePosedAsGiven) {
  Random random(1);
  int met = 0;
  for (int i = 0; i < 500; ++i) {
    const double by = i % 3 == 0 ? 0x1p-13 : i % 3 == 1 ? 0x1p-24 : 0x1p-38;
    const PairQuery query{.pose_a = drifted(random, by, 1.5), .pose_b = drifted(random, by, 1.5)};
    const Made a = made(random, query.pose_a), b = made(random, query.pose_b);
    const bool truth = oracle_overlap(a, b);
    met += truth;
    ASSERT_EQ(overlap(a.model, b.model, query), truth) << i;
    ASSERT_EQ(relation(a.model, b.model, query).kind == RelationKind::apart, !truth) << i;
    if (a.is_half_space && b.is_half_space) continue;
    const Distance found = distance(a.model, b.model, query);
    ASSERT_EQ(found.upper > 0, !truth) << i;
    ASSERT_LE(found.upper - found.lower, 1e-12 * found.upper) << i;
    if (truth) continue;
    ASSERT_GE(compared(a, b, found.lower), 0) << i;
    ASSERT_LE(compared(a, b, found.upper), 0) << i;
  }
  EXPECT_GT(met, 50);
  EXPECT_LT(met, 450);
}

TEST(DriftedPoses, APoseComposedForTenThousandFramesIsTaken) {
  const Pose step{rotation_about({1, 2, 3}, 0.7), {0.001, 0, 0}};
  Pose pose;
  for (int frame = 0; frame < 10000; ++frame) pose = step * pose;
  const PairQuery query{.pose_b = pose};
  EXPECT_TRUE(overlap(Sphere(1000), Capsule({0, 0, 0}, {0, 0, 1}, 0.5), query));
  EXPECT_TRUE(overlap(Sphere(1000), HalfSpace({0, 0, 0}, {0, 0, 1}), query));
}

TEST(DriftedPoses, TheRotationOfAQuaternionOfFloatsIsTaken) {
  const float half = std::sqrt(0.5F), w = half, z = half;
  Pose pose;  // as a program in floats makes it
  pose.linear = {{{Vec3{1 - 2 * z * z, -2 * z * w, 0}, {2 * z * w, 1 - 2 * z * z, 0}, {0, 0, 1.0F - 0x1p-23F}}}};
  EXPECT_TRUE(overlap(Rounded(Box({1, 1, 1}), 0.25), Sphere(1), {.pose_a = pose, .pose_b = pose}));
}

TEST(DriftedPoses, WhatStretchesIsRefusedWithItsDeviation) {
  Pose pose;
  pose.linear[0].x = 1.25;
  try {
    (void)overlap(Sphere(1), Sphere(1), {.pose_a = pose});
    FAIL() << "a stretched ball is no ball";
  } catch (const Error& error) {
    for (const std::string part : {"0.562", "nearest_rigid", "ellipsoid"})
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace toccata
