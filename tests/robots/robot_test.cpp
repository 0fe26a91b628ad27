#include "toccata/robots/robot.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "robots/robot_cases.hpp"
#include "support/error_message.hpp"
#include "toccata/core/random.hpp"

namespace toccata::test {
namespace {

constexpr double right_angle = std::numbers::pi / 2;

/// Where a point of the last link of a chain is, by sines and cosines alone: from the tip inwards, with long doubles.
using LongVector = std::array<long double, 3>;

LongVector turned(const LongVector& v, const Vec3& axis, long double angle) {
  const long double length =
      std::sqrt(static_cast<long double>(axis.x) * axis.x + static_cast<long double>(axis.y) * axis.y +
                static_cast<long double>(axis.z) * axis.z);
  const LongVector a{axis.x / length, axis.y / length, axis.z / length};
  const long double c = std::cos(angle), s = std::sin(angle);
  const long double along = a[0] * v[0] + a[1] * v[1] + a[2] * v[2];
  const LongVector across{a[1] * v[2] - a[2] * v[1], a[2] * v[0] - a[0] * v[2], a[0] * v[1] - a[1] * v[0]};
  LongVector result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = c * v[i] + s * across[i] + (1 - c) * along * a[i];
  return result;
}

LongVector moved(const Pose& pose, const LongVector& v) {
  LongVector result;
  for (int i = 0; i < 3; ++i)
    result[static_cast<std::size_t>(i)] =
        pose.linear[i].x * v[0] + pose.linear[i].y * v[1] + pose.linear[i].z * v[2] + pose.offset[i];
  return result;
}

LongVector point_of_link(const Robot& robot, Index link, const std::vector<double>& configuration, LongVector point) {
  while (const std::optional<Index> number = robot.parent_joint(link)) {
    const RobotJoint& joint = robot.joints()[*number];
    std::size_t position = 0;
    while (position < robot.positions().size() && robot.positions()[position].joint != *number) ++position;
    if (joint.kind == RobotJointKind::prismatic) {
      const Vec3 axis = normalized(joint.axis);
      for (int i = 0; i < 3; ++i) point[static_cast<std::size_t>(i)] += configuration[position] * axis[i];
    } else if (joint.kind != RobotJointKind::fixed) {
      point = turned(point, joint.axis, configuration[position]);
    }
    point = moved(joint.origin, point);
    link = robot.link_of(joint.parent);
  }
  return point;
}

TEST(Robot, LinksAreWhereTheirJointsPutThem) {
  const Robot robot(planar_robot());
  ASSERT_EQ(robot.positions().size(), 3U);
  EXPECT_EQ(robot.positions()[1].name, "elbow");
  EXPECT_TRUE(robot.positions()[1].turns);
  EXPECT_FALSE(robot.positions()[2].turns);
  const std::vector<Pose> poses = robot.link_poses(std::vector<double>{right_angle, -right_angle, 0.5});
  // Quarter turns are exact.
  EXPECT_EQ(poses[robot.link_of("upper")] * (Vec3{1, 0, 0}), (Vec3{0, 1, 0}));
  EXPECT_EQ(poses[robot.link_of("lower")] * Vec3(), (Vec3{0, 1, 0}));
  EXPECT_EQ(poses[robot.link_of("tip")] * Vec3(), (Vec3{1.5, 1, 0}));
}

TEST(Robot, AnyArmIsWhereLongDoublesSayItIs) {
  Random random(7);
  for (int run = 0; run < 50; ++run) {
    RobotDescription arm = generated_arm({.subdivisions = 0});
    for (RobotJoint& joint : arm.joints) {
      joint.axis = {random.between(-1, 1), random.between(-1, 1), random.between(0.1, 1)};
      joint.origin = Pose::rigid({random.between(-1, 1), random.between(-1, 1), random.between(-1, 1), 1},
                                 {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)});
      if (random.below(3) == 0) joint.kind = RobotJointKind::prismatic;
    }
    const Robot robot(arm);
    const std::vector<double> configuration = sampled_configurations(robot, 1, random.bits());
    const std::vector<Pose> poses = robot.link_poses(configuration);
    for (Index link = 0; link < robot.links().size(); ++link) {
      const LongVector expected = point_of_link(robot, link, configuration, {0.1L, 0.2L, 0.3L});
      const Vec3 found = poses[link] * Vec3{0.1, 0.2, 0.3};
      for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(found[i], static_cast<double>(expected[static_cast<std::size_t>(i)]), 1e-13) << run;
    }
  }
}

TEST(Robot, ManyConfigurationsAreEachAlone) {
  const Robot robot(generated_arm({.subdivisions = 0}));
  const std::vector<double> configurations = sampled_configurations(robot, 100);
  const std::vector<Pose> all = robot.link_poses_each(configurations, 2);
  for (std::size_t i = 0; i < 100; ++i) {
    const std::vector<Pose> alone = robot.link_poses(nth(configurations, i, 7));
    for (std::size_t link = 0; link < alone.size(); ++link) EXPECT_EQ(all[i * alone.size() + link], alone[link]);
  }
}

TEST(Robot, PlanarAndFloatingJointsAreSeveralPositions) {
  RobotDescription cart{"cart", {{"world"}, {"cart", {{Sphere(0.1)}}}, {"bird", {{Sphere(0.1)}}}}, {}, {}};
  cart.joints = {
      {.name = "drive", .kind = RobotJointKind::planar, .parent = "world", .child = "cart", .axis = {0, 0, 1}},
      {.name = "fly", .kind = RobotJointKind::floating, .parent = "cart", .child = "bird"}};
  const Robot robot(cart);
  std::vector<std::string> names;
  for (const RobotPosition& position : robot.positions()) names.push_back(position.name);
  EXPECT_EQ(names, (std::vector<std::string>{"drive/x", "drive/y", "drive/turn", "fly/x", "fly/y", "fly/z", "fly/roll",
                                             "fly/pitch", "fly/yaw"}));
  const std::vector<Pose> poses =
      robot.link_poses(std::vector<double>{2, 3, right_angle, 1, 0, 5, right_angle, 0, right_angle});
  EXPECT_EQ(poses[1] * (Vec3{1, 0, 0}), (Vec3{2, 4, 0}));
  EXPECT_EQ(poses[2] * Vec3(), (Vec3{2, 4, 5}));
  // It rolls about its fixed x axis first: y goes to z, and then about z, which leaves it.
  EXPECT_EQ(poses[2].linear * (Vec3{0, 1, 0}), (Vec3{0, 0, 1}));
}

TEST(Robot, WhatMimicsFollows) {
  RobotDescription arm = planar_robot();
  arm.joints[1].mimic = JointMimic{"shoulder", -1, 0.25};
  arm.joints[2].mimic = JointMimic{"elbow", 2, 1};
  const Robot robot(arm);
  ASSERT_EQ(robot.positions().size(), 1U);
  const Robot free(planar_robot());
  const double q = 0.3;
  EXPECT_EQ(robot.link_poses(std::vector<double>{q}), free.link_poses(std::vector<double>{q, -q + 0.25, -2 * q + 1.5}));
}

TEST(Robot, RestAndLimits) {
  RobotDescription arm = planar_robot();
  arm.joints[2].limits = JointLimits{0.5, 1};
  const Robot robot(arm);
  EXPECT_EQ(robot.rest(), (std::vector<double>{0, 0, 0.75}));
  EXPECT_EQ(robot.beyond_limits(robot.rest()), std::nullopt);
  EXPECT_EQ(robot.beyond_limits(std::vector<double>{100, 3.1, 0}), 1U);
  EXPECT_EQ(robot.beyond_limits(std::vector<double>{100, -3, 1.01}), 2U);
}

TEST(Robot, SharedMeshesAreOneModel) {
  RobotDescription arm = generated_arm({.subdivisions = 0});
  arm.links[3].shapes = arm.links[2].shapes;
  const Robot robot(arm);
  EXPECT_EQ(&robot.bodies()[2].model.mesh(), &robot.bodies()[3].model.mesh());
}

std::string fault_of(const std::function<void(RobotDescription&)>& break_it) {
  RobotDescription arm = planar_robot();
  break_it(arm);
  return message_of([&] { static_cast<void>(Robot(arm)); });
}

TEST(Robot, BrokenTreesAreNamed) {
  EXPECT_EQ(fault_of([](RobotDescription&) {}), "");
  EXPECT_EQ(fault_of([](auto& arm) { arm.links.clear(); }), "the robot 'planar' has no link; describe one at least");
  EXPECT_EQ(fault_of([](auto& arm) { arm.links[3].name = "upper"; }),
            "two links are called 'upper'; give each a name of its own");
  EXPECT_EQ(fault_of([](auto& arm) { arm.joints[1].name = "shoulder"; }),
            "two joints are called 'shoulder'; give each a name of its own");
  EXPECT_EQ(fault_of([](auto& arm) { arm.joints[1].parent = "uper"; }),
            "joint 'elbow': its parent is link 'uper', which there is not; did you mean 'upper'?");
  EXPECT_EQ(fault_of([](auto& arm) { arm.joints[2].child = "lower"; }),
            "link 'lower' has two parents, by joints 'elbow' and 'slide'; a robot is a tree");
  EXPECT_EQ(fault_of([](auto& arm) { arm.joints[0].parent = "tip"; }),
            "link 'tip' hangs on itself, in a circle of joints of which 'slide' is one; a robot is a tree");
  EXPECT_EQ(fault_of([](auto& arm) { arm.joints.erase(arm.joints.begin()); }),
            "links 'ground' and 'upper' both hang on none; join them, so that the robot is one tree");
  EXPECT_EQ(fault_of([](auto& arm) { arm.joints[0].axis = {}; }),
            "joint 'shoulder': its axis has no direction; give three finite numbers that are not all 0");
  EXPECT_EQ(fault_of([](auto& arm) { arm.joints[1].origin.linear[0].x = 2; }),
            "joint 'elbow': its origin is no rotation and translation; Pose::nearest_rigid makes one of it");
  EXPECT_EQ(fault_of([](auto& arm) {
              arm.joints[1].limits = JointLimits{1, -1};
            }),
            "joint 'elbow': its limits are 1 to -1; the lower one comes first, and both are finite");
  EXPECT_EQ(fault_of([](auto& arm) { arm.joints[1].mimic = JointMimic{"sholder"}; }),
            "joint 'elbow': it mimics joint 'sholder', which there is not; did you mean 'shoulder'?");
  EXPECT_NE(fault_of([](auto& arm) {
              arm.joints[1].mimic = JointMimic{"slide"};
              arm.joints[2].mimic = JointMimic{"elbow"};
            }).find("mimics itself"),
            std::string::npos);
  EXPECT_NE(fault_of([](auto& arm) {
              arm.joints[0].kind = RobotJointKind::fixed;
              arm.joints[1].mimic = JointMimic{"shoulder"};
            }).find("has not one position"),
            std::string::npos);
}

TEST(Robot, ConfigurationsAreChecked) {
  const Robot robot(planar_robot());
  EXPECT_EQ(message_of([&] { static_cast<void>(robot.link_poses(std::vector<double>{1})); }),
            "a robot of 3 positions was given 1; give one number for each");
  EXPECT_EQ(message_of([&] {
              static_cast<void>(robot.link_poses(std::vector<double>{1, NAN, 0}));
            }),
            "the position of 'elbow' is nan; it has to be finite");
  EXPECT_EQ(message_of([&] { static_cast<void>(robot.link_poses_each(std::vector<double>(7))); }),
            "7 numbers are no configurations of 3 positions each");
  EXPECT_EQ(message_of([&] {
              static_cast<void>(robot.link_poses_each(std::vector<double>{0, 0, 0, INFINITY, 0, 0}));
            }),
            "configuration 1: the position of 'shoulder' is inf; it has to be finite");
  EXPECT_EQ(message_of([&] { static_cast<void>(robot.link_of("tap")); }),
            "the robot has no link 'tap'; did you mean 'tip'?");
}

TEST(Robot, AttachedObjectsMoveWithTheirLink) {
  const Robot robot(planar_robot());
  const Robot holding =
      robot.with_attached({{"cup", {{Box{{0.1, 0.1, 0.1}}}}}, "tip", Pose::translation(0.25, 0, 0), {"lower"}});
  EXPECT_EQ(robot.links().size(), 4U);
  ASSERT_EQ(holding.links().size(), 5U);
  const std::vector<double> configuration{right_angle, 0, 1};
  EXPECT_EQ(holding.link_poses(configuration)[4] * Vec3(), (Vec3{0, 3.25, 0}));
  EXPECT_EQ(holding.touching_attachments().size(), 2U);
  EXPECT_NE(message_of([&] {
              static_cast<void>(robot.with_attached({{"cup", {}}, "tap", {}, {}}));
            }).find("no link 'tap'"),
            std::string::npos);
}

}  // namespace
}  // namespace toccata::test
