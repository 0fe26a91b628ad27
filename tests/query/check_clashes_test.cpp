// What check_all tells of a clash beside its relation: kind, volume, a point of both, and how it stands to a tolerance.
#include <gtest/gtest.h>

#include <algorithm>

#include "support/error_message.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/query/signed_distance.hpp"

namespace toccata::test {
namespace {

PairAnswer only_pair(const Model& a, const Model& b, const Pose& pose_b, const CheckOptions& options) {
  const std::vector<SceneInstance> models{{.model = a, .name = "a"}, {.model = b, .pose = pose_b, .name = "b"}};
  const CheckAnswer answer = check_all(models, options);
  EXPECT_EQ(answer.pairs.size(), 1U);
  return answer.pairs.empty() ? PairAnswer{} : answer.pairs[0];
}

PairAnswer only_pair(const TriangleMesh& a, const TriangleMesh& b, const Pose& pose_b, const CheckOptions& options) {
  return only_pair(Model(a), Model(b), pose_b, options);
}

using ClashKind = PairAnswer::Kind;
using ToleranceVerdict = PairAnswer::Tolerance;

const CheckOptions with_volume{.volume = true};

TEST(CheckClashes, ARodThroughAPlatePiercesAndItsEndInItProtrudes) {
  const TriangleMesh plate = box_mesh({1, 1, 0.1}), rod = box_mesh({0.1, 0.2, 1});
  const PairAnswer through = only_pair(plate, rod, {}, with_volume);
  EXPECT_EQ(through.kind, ClashKind::pierce);
  ASSERT_TRUE(through.volume);
  EXPECT_NEAR(through.volume->upper, 0.2 * 0.4 * 0.2, 1e-12);
  EXPECT_EQ(only_pair(plate, rod, Pose::translation(0.3, 0.1, 1), with_volume).kind, ClashKind::protrude);
  EXPECT_EQ(only_pair(plate, rod, Pose::translation(0.3, 0.1, 1), {.penetration = true}).kind, ClashKind::protrude);
  EXPECT_EQ(only_pair(plate, rod, {}, {.penetration = true}).kind, ClashKind::pierce);
  EXPECT_EQ(only_pair(plate, rod, {}, {}).kind, ClashKind::overlap);
}

TEST(CheckClashes, AForkInAPlateProtrudesAtTwoPlaces) {
  const std::vector<Vec2> fork = {{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};
  const TriangleMesh plate = box_mesh({9, 1, 9}), prongs = extruded_mesh(fork, 0.5);
  const Pose upside_down{{{Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, -1}}}, {0, 3.5, 0}};
  EXPECT_EQ(only_pair(plate, prongs, upside_down, with_volume).kind, ClashKind::protrude);
}

TEST(CheckClashes, ShapesAreToldTheSameWay) {
  EXPECT_EQ(only_pair(Model(Box({1, 1, 0.1})), Model(Cylinder(0.2, 1)), {}, with_volume).kind, ClashKind::pierce);
  EXPECT_EQ(only_pair(Model(Sphere(1)), Model(Sphere(1)), Pose::translation(1.5, 0, 0), with_volume).kind,
            ClashKind::protrude);
}

TEST(CheckClashes, OtherKindsFollowTheRelation) {
  const TriangleMesh box = box_mesh({1, 1, 1}), small = box_mesh({0.5, 0.5, 0.5});
  EXPECT_EQ(only_pair(box, small, {}, with_volume).kind, ClashKind::contains);
  EXPECT_EQ(only_pair(box, box, {}, with_volume).kind, ClashKind::equal);
  EXPECT_EQ(only_pair(box, box, Pose::translation(2, 0, 0), with_volume).kind, ClashKind::touching);
  EXPECT_EQ(only_pair(box, box, Pose::translation(2.5, 0, 0), {.clearance = 1}).kind, ClashKind::clearance);
  EXPECT_EQ(only_pair(box, height_field_mesh({}), {}, with_volume).kind, ClashKind::crossing);
  EXPECT_FALSE(only_pair(box, height_field_mesh({}), {}, with_volume).volume);
}

TEST(CheckClashes, ThePointIsOfBoth) {
  const Model gear(gear_mesh({.teeth = 9})), torus(torus_mesh({.tube_radius = 0.3, .around = 24, .sides = 12}));
  for (const double apart : {0.1, 0.7, 1.2}) {
    const Pose pose = Pose::translation(apart, 0.2, 0.1);
    const PairAnswer pair = only_pair(gear, torus, pose, with_volume);
    ASSERT_TRUE(pair.common_point) << apart;
    EXPECT_EQ(signed_distance(*pair.common_point, gear).side, Side::inside) << apart;
    EXPECT_EQ(signed_distance(*pair.common_point, torus, pose).side, Side::inside) << apart;
  }
}

TEST(CheckClashes, AnOverlapIsHeldAgainstTheTolerance) {
  const TriangleMesh box = box_mesh({1, 1, 1});
  const auto verdict = [&](double by, double tolerance) {
    return only_pair(box, box, Pose::translation(by, 0.25, 0.125), {.tolerance = tolerance}).tolerance;
  };
  EXPECT_EQ(verdict(1.75, 0.5), ToleranceVerdict::within);
  EXPECT_EQ(verdict(1.75, 0.125), ToleranceVerdict::beyond);
  EXPECT_EQ(verdict(2, 0.125), ToleranceVerdict::none);
  EXPECT_EQ(only_pair(box, box, Pose::translation(1.75, 0, 0), {}).tolerance, ToleranceVerdict::none);
}

TEST(CheckClashes, WhereTheBracketHoldsTheToleranceItIsAskedMorePrecisely) {
  const Model ball(icosphere_mesh(1, 3)), gear(gear_mesh({.teeth = 9}));
  const Pose pose = Pose::translation(1.3, 0.2, 0.1);
  const PairAnswer wide = only_pair(ball, gear, pose, {.penetration = true, .depth = {.precision = 0.5}});
  ASSERT_TRUE(wide.penetration);
  ASSERT_LT(wide.penetration->lower, wide.penetration->upper);
  const double between = 0.5 * (wide.penetration->lower + wide.penetration->upper);
  const PairAnswer asked = only_pair(ball, gear, pose, {.depth = {.precision = 0.5}, .tolerance = between});
  ASSERT_TRUE(asked.penetration);
  EXPECT_LE(asked.penetration->upper - asked.penetration->lower, wide.penetration->upper - wide.penetration->lower);
  const bool is_within = asked.penetration->upper <= between, is_beyond = asked.penetration->lower > between;
  EXPECT_EQ(asked.tolerance, is_within   ? ToleranceVerdict::within
                             : is_beyond ? ToleranceVerdict::beyond
                                         : ToleranceVerdict::undecided);
}

TEST(CheckClashes, WhatHasNoDepthIsUndecided) {
  const PairAnswer pair = only_pair(box_mesh({1, 1, 1}), height_field_mesh({}), {}, {.tolerance = 100});
  EXPECT_EQ(pair.tolerance, ToleranceVerdict::undecided);
  EXPECT_FALSE(pair.penetration);
}

TEST(CheckClashes, AToleranceThatIsNoLengthIsRefused) {
  const std::vector<SceneInstance> none;
  EXPECT_NE(message_of([&] { static_cast<void>(check_all(none, {.tolerance = -1})); }).find("the tolerance is -1"),
            std::string::npos);
}

}  // namespace
}  // namespace toccata::test
