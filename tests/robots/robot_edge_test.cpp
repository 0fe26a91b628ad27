#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "robots/robot_cases.hpp"
#include "toccata/robots/robot_scene.hpp"

namespace toccata::test {
namespace {

std::vector<double> on_the_way(const std::vector<double>& from, const std::vector<double>& to, double time) {
  std::vector<double> configuration(from.size());
  for (std::size_t i = 0; i < from.size(); ++i)
    configuration[i] = time == 1 ? to[i] : from[i] + time * (to[i] - from[i]);
  return configuration;
}

TEST(RobotEdge, OfABodyWithoutSizeEndsAtItsPrecision) {
  const RobotDescription slider{"slider",
                                {{"base"}, {"tip", {{Point({0, 0, 0})}}}},
                                {{.name = "slide",
                                  .kind = RobotJointKind::prismatic,
                                  .parent = "base",
                                  .child = "tip",
                                  .limits = JointLimits{0, 1}}},
                                {}};
  const std::vector<SceneInstance> box{{Box({0.1, 0.1, 0.1}), Pose::translation(0.7, 0, 0), {}, "box"}};
  const RobotEdge edge = RobotScene(Robot(slider), box).edge(std::vector<double>{0}, std::vector<double>{1});
  EXPECT_FALSE(edge.is_free);
  EXPECT_LE(edge.lower, 0.6);
  EXPECT_GE(edge.upper, 0.6 - 1e-12);
}

TEST(RobotEdge, ABarThatTurnsMeetsAPinAtTheAngleOfThePin) {
  RobotDescription arm = planar_robot();
  arm.links[1].shapes = {{Segment({0, 0, 0}, {1, 0, 0})}};
  arm.links[2].shapes.clear();
  arm.links[3].shapes.clear();
  const double angle = 1.1;
  const std::vector<SceneInstance> pin{{Point({0.7 * std::cos(angle), 0.7 * std::sin(angle), 0}), {}, {}, "pin"}};
  const RobotScene scene(Robot(arm), pin);
  const std::vector<double> from{0, 0, 0}, to{2, 0, 0};
  const RobotEdge edge = scene.edge(from, to);
  EXPECT_FALSE(edge.is_free);
  EXPECT_LE(edge.lower, angle / 2);
  EXPECT_GE(edge.upper, angle / 2);
  EXPECT_LE(edge.upper - edge.lower, 0x1p-20);
  // A turning segment and a point: no moment of doubles has them meet exactly.
  EXPECT_EQ(edge.status, Status::undecided);
  EXPECT_EQ(edge.pair, (RobotContact{1, true, 0}));
  EXPECT_TRUE(scene.edge(from, std::vector<double>{1.09, 0, 0}).is_free);
  EXPECT_TRUE(scene.edge(from, std::vector<double>{-2, 1, 1}).is_free);
}

TEST(RobotEdge, WhatMeetsAtTheStartIsMetAtZero) {
  const std::vector<SceneInstance> crate{{Box{{0.2, 0.2, 0.2}}, Pose::translation(0.5, 0, 0), {}, "crate"}};
  const RobotScene scene(Robot(planar_robot()), crate);
  const RobotEdge edge = scene.edge(std::vector<double>{0, 0, 0}, std::vector<double>{2, 0, 0});
  EXPECT_FALSE(edge.is_free);
  EXPECT_EQ(edge.lower, 0);
  EXPECT_EQ(edge.upper, 0);
  EXPECT_EQ(edge.status, Status::exact);
  EXPECT_EQ(edge.pair, (RobotContact{1, true, 0}));
}

TEST(RobotEdge, OneThatEndsInAContactMeetsThere) {
  const std::vector<SceneInstance> wall{{Box{{1, 1, 1}}, Pose::translation(3.5, 0, 0), {}, "wall"}};
  const RobotScene scene(Robot(planar_robot()), wall);
  // The ball of radius 0.1 at x = 2 slides up to x = 2.4, where it touches the wall at 2.5.
  const std::vector<double> from{0, 0, 0}, touching{0, 0, 0.40625}, before{0, 0, 0.375};
  EXPECT_FALSE(scene.edge(from, touching).is_free);
  EXPECT_TRUE(scene.edge(from, before).is_free);
  const RobotEdge through = scene.edge(from, std::vector<double>{0, 0, 0.8});
  EXPECT_FALSE(through.is_free);
  EXPECT_EQ(through.status, Status::exact);
  EXPECT_LE(through.lower, 0.5);
  EXPECT_GE(through.upper, 0.5 - 1e-12);
  EXPECT_LE(through.upper - through.lower, 2e-6);
}

/// Arms that turn; and one that flies, slides and has a joint that mimics another.
RobotDescription arm_on_edges(std::uint64_t seed) {
  RobotDescription arm = mixed_arm(seed);
  if (seed != 3) return arm;
  arm.joints[3].kind = RobotJointKind::prismatic;
  arm.joints[3].limits = JointLimits{-0.1, 0.1};
  arm.joints[6].mimic = JointMimic{"joint 5", -0.5, 0.1};
  arm.links.push_back({"world"});
  arm.joints.push_back({.name = "fly", .kind = RobotJointKind::floating, .parent = "world", .child = "base"});
  return arm;
}

/// Edges of many lengths, against moments that are near each other.
TEST(RobotEdge, NothingIsMetBeforeTheFirstContactAndSomethingThere) {
  std::size_t free = 0, met = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const RobotScene scene(Robot(arm_on_edges(seed)), generated_room({.boxes = 12, .meshes = true, .seed = seed}));
    const std::size_t positions = scene.robot().positions().size();
    constexpr std::size_t edges = 40;
    const std::vector<double> starts = sampled_configurations(scene.robot(), edges, seed);
    const std::vector<double> ends = sampled_configurations(scene.robot(), edges, seed + 100);
    std::vector<double> shorter;
    for (std::size_t i = 0; i < starts.size(); ++i) {
      const double part = (i / positions) % 2 == 0 ? 0.1 : 1;
      shorter.push_back(starts[i] + part * (ends[i] - starts[i]));
    }
    const std::vector<std::uint8_t> is_free = scene.free_each(starts, shorter);
    const std::vector<RobotEdge> found = scene.edge_each(starts, shorter);
    for (std::size_t i = 0; i < edges; ++i) {
      const std::vector<double> from = nth(starts, i, positions), to = nth(shorter, i, positions);
      const RobotEdge& edge = found[i];
      EXPECT_EQ(is_free[i] != 0, edge.is_free) << "seed " << seed << " edge " << i;
      constexpr int moments = 200;
      for (int k = 0; k <= moments; ++k) {
        const double time = static_cast<double>(k) / moments;
        if (!edge.is_free && time >= edge.lower) break;
        EXPECT_FALSE(scene.meets(on_the_way(from, to, time))) << "seed " << seed << " edge " << i << " at " << time;
      }
      if (edge.is_free) {
        ++free;
        continue;
      }
      ++met;
      if (edge.status != Status::exact) continue;
      const auto contacts = scene.contacts(on_the_way(from, to, edge.upper));
      ASSERT_FALSE(contacts.empty()) << "seed " << seed << " edge " << i;
      EXPECT_EQ(contacts.front(), edge.pair);
    }
  }
  EXPECT_GT(free, 5U);
  EXPECT_GT(met, 20U);
}

TEST(RobotEdge, ThreadsAndPrecisionChangeNoAnswer) {
  const RobotScene scene(Robot(mixed_arm(2)), generated_room({.boxes = 12, .meshes = true, .seed = 2}));
  const std::vector<double> starts = sampled_configurations(scene.robot(), 30, 1);
  const std::vector<double> ends = sampled_configurations(scene.robot(), 30, 2);
  const auto one = scene.edge_each(starts, ends, {.threads = 1}), three = scene.edge_each(starts, ends, {.threads = 3});
  const auto finer = scene.edge_each(starts, ends, {.precision = 0x1p-30});
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].is_free, three[i].is_free);
    EXPECT_EQ(one[i].lower, three[i].lower);
    EXPECT_EQ(one[i].upper, three[i].upper);
    EXPECT_EQ(one[i].pair, three[i].pair);
    EXPECT_LE(one[i].lower, finer[i].lower);
    if (one[i].status != Status::exact || finer[i].status != Status::exact) continue;
    EXPECT_GE(one[i].upper, finer[i].upper);
  }
}

}  // namespace
}  // namespace toccata::test
