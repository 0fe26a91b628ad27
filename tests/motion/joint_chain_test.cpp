#include "toccata/motion/joint_chain.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "support/error_message.hpp"
#include "toccata/query/overlap.hpp"

namespace toccata::test {
namespace {

/// Two links of length 1 in a plane, and a gripper that slides out of the second.
std::vector<Joint> planar_arm() {
  return {{.axis = {0, 0, 2}},
          {.origin = Pose::translation(1, 0, 0), .parent = 0},
          {.kind = JointKind::prismatic, .origin = Pose::translation(1, 0, 0), .axis = {1, 0, 0}, .parent = 1}};
}

TEST(JointChain, LinksAreWhereTheirJointsPutThem) {
  const std::vector<Pose> poses =
      link_poses(planar_arm(), std::vector<double>{90, -90, 0.5}, Pose::translation(0, 0, 3));
  EXPECT_LT(length(poses[0] * Vec3{1, 0, 0} - Vec3{0, 1, 3}), 1e-15);
  EXPECT_LT(length(poses[1] * Vec3{} - Vec3{0, 1, 3}), 1e-15);
  EXPECT_LT(length(poses[2] * Vec3{} - Vec3{1.5, 1, 3}), 1e-15);
}

TEST(JointChain, ALinkMovesAsItsJointsDoAndNeverFasterThanItsBound) {
  const std::vector<Joint> joints = planar_arm();
  const std::vector<double> from{0, 10, 0}, to{60, 60, 0.25};
  const std::vector<RigidMotion> motions = link_motions(joints, from, to);
  ASSERT_EQ(motions.size(), 3U);
  constexpr int steps = 500;
  for (std::size_t link = 0; link < motions.size(); ++link) {
    double fastest = 0;
    for (int i = 0; i <= steps; ++i) {
      const double time = static_cast<double>(i) / steps;
      std::vector<double> positions;
      for (std::size_t j = 0; j < joints.size(); ++j) positions.push_back(from[j] + time * (to[j] - from[j]));
      const Pose expected = link_poses(joints, positions)[link];
      for (const Vec3& p : {Vec3{}, Vec3{1, 0, 0}, Vec3{0, 1, 0}})
        EXPECT_LT(length(motions[link].at(time) * p - expected * p), 1e-13);
      if (i > 0) {
        const double before = static_cast<double>(i - 1) / steps;
        fastest =
            std::max(fastest, steps * length(motions[link].at(time) * Vec3{} - motions[link].at(before) * Vec3{}));
      }
    }
    if (!motions[link].pieces().empty()) continue;  // a move tells itself how fast it is
    EXPECT_LE(fastest, motions[link].speed().speed);
    EXPECT_LE(motions[link].speed().speed, 1.5 * fastest) << "link " << link;
    EXPECT_GE(motions[link].speed().turns, (60 + 50) / 360.0);
  }
}

TEST(JointChain, AnArmBetweenTwoConfigurationsIsSweptLinkByLink) {
  const std::vector<Joint> joints = planar_arm();
  const std::vector<RigidMotion> motions =
      link_motions(joints, std::vector<double>{0, 0, 0}, std::vector<double>{90, 90, 0});
  const Model link = Box({0.5, 0.05, 0.05}), post = Sphere(0.1);
  const auto meets = [&](std::size_t i, const Vec3& at) {
    return sweep(link, motions[i].carrying(Pose::translation(0.5, 0, 0)), post, Pose::translation(at));
  };
  EXPECT_TRUE(meets(0, {0.5, 0.5, 0}));
  EXPECT_FALSE(meets(0, {1.2, 0.5, 0}));
  EXPECT_TRUE(meets(1, {1.2, 0.6, 0}));
  EXPECT_FALSE(meets(1, {-1.5, 0, 0}));
}

TEST(JointChain, LargeNumbersInBetweenDoNotLookLikeSpeed) {
  const std::vector<Joint> gantry{{.kind = JointKind::prismatic, .axis = {1, 0, 0}}, {.axis = {0, 0, 1}, .parent = 0}};
  for (const double out : {1e3, 5e3, 1e6})
    EXPECT_TRUE(sweep(Box({1, 0.1, 0.1}),
                      link_motions(gantry, std::vector<double>{-out - 1, 0}, std::vector<double>{-out + 1, 90},
                                   Pose::translation(out, 0, 0))[1],
                      Sphere(0.01), Pose{}));
  const std::vector<Joint> two{{.axis = {0, 0, 1}}, {.origin = Pose::translation(1, 0, 0), .parent = 0}};
  for (const double turned : {0.0, 10080.0, 100800.0, 36e6}) {
    const std::vector<double> from{turned, turned}, to{turned + 90, turned + 90};
    const RigidMotion arm = link_motions(two, from, to)[1].carrying(Pose::translation(0.5, 0, 0));
    EXPECT_TRUE(sweep(Box({0.5, 0.05, 0.05}), arm, Sphere(0.1), Pose::translation(1.2, 0.6, 0)));
  }
}

TEST(JointChain, ErrorsNameTheJoint) {
  std::vector<Joint> joints = planar_arm();
  const std::vector<double> two{0, 0}, three{0, 0, 0}, infinite{0, HUGE_VAL, 0};
  const auto error = [&](const std::vector<double>& positions) {
    return message_of([&] { (void)link_poses(joints, positions); });
  };
  EXPECT_NE(error(two).find("a chain of 3 joints has 2 positions"), std::string::npos);
  EXPECT_NE(error(infinite).find("joint 1: its position is not finite"), std::string::npos);
  joints[1].axis = {};
  EXPECT_NE(error(three).find("joint 1: its axis is zero"), std::string::npos);
  joints = planar_arm();
  joints[2].parent = 2;
  EXPECT_NE(error(three).find("joint 2: its parent is joint 2"), std::string::npos);
  joints = planar_arm();
  joints[0].origin = scaled(Pose{}, 2);
  EXPECT_NE(error(three).find("joint 0: its origin is off from a rotation"), std::string::npos);
}

}  // namespace
}  // namespace toccata::test
