#include "toccata/robots/robot_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "robots/robot_cases.hpp"
#include "support/error_message.hpp"

namespace toccata::test {
namespace {

constexpr double half_turn = std::numbers::pi;

std::vector<SceneInstance> small_room(std::uint64_t seed) {
  std::vector<SceneInstance> room = generated_room({.boxes = 12, .meshes = true, .seed = seed});
  room.push_back({HalfSpace({0, 0, -0.3}, {0, 0, 1}), {}, Solid::automatic, "floor"});
  const Compound both{{Sphere(0.1), Pose::translation(0.5, 0, 0.4)},
                      {Cylinder(0.05, 0.3), Pose::translation(-0.5, 0.2, 0.4)}};
  room.push_back({Model(both), {}, Solid::automatic, "both"});
  return room;
}

TEST(RobotScene, MeetsWhatItsBodiesMeetPairByPair) {
  std::size_t free = 0, met_itself = 0, count = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const RobotScene scene(Robot(mixed_arm(seed)), small_room(seed));
    constexpr std::size_t samples = 60;
    const std::vector<double> configurations = sampled_configurations(scene.robot(), samples, seed);
    const auto all = scene.contacts_each(configurations);
    const auto first = scene.contacts_each(configurations, ContactsTold::first);
    const auto meets = scene.meets_each(configurations);
    for (std::size_t i = 0; i < samples; ++i, ++count) {
      const std::vector<RobotContact> expected = contacts_by_pairs(scene, nth(configurations, i, 7));
      EXPECT_EQ(all[i], expected) << "seed " << seed << " configuration " << i;
      EXPECT_EQ(meets[i] != 0, !expected.empty()) << "seed " << seed << " configuration " << i;
      EXPECT_EQ(first[i], expected.empty() ? expected : one_of(expected, 0)) << seed << " " << i;
      free += expected.empty() ? 1U : 0U;
      met_itself += std::ranges::any_of(expected, [](const RobotContact& c) { return !c.with_obstacle; }) ? 1U : 0U;
    }
  }
  // All kinds of answers are among them.
  EXPECT_GT(free, 5U);
  EXPECT_LT(free, count - 50);
  EXPECT_GT(met_itself, 5U);
}

TEST(RobotScene, ManyAreEachAloneOnAnyThreads) {
  const RobotScene scene(Robot(mixed_arm(3)), small_room(3));
  const std::vector<double> configurations = sampled_configurations(scene.robot(), 300, 5);
  const auto one = scene.meets_each(configurations, {.threads = 1});
  EXPECT_EQ(one, scene.meets_each(configurations, {.threads = 3}));
  EXPECT_EQ(scene.contacts_each(configurations, ContactsTold::first, {.threads = 1}),
            scene.contacts_each(configurations, ContactsTold::first, {.threads = 3}));
  for (std::size_t i = 0; i < 300; i += 7) {
    const std::vector<double> alone = nth(configurations, i, 7);
    EXPECT_EQ(scene.meets(alone), one[i] != 0);
  }
}

TEST(RobotScene, AllowedPairsAreNotLookedAt) {
  // Folded, the lower bar lies on the upper one.
  const Robot robot(planar_robot());
  const std::vector<double> folded{0, half_turn, 0};
  const std::vector<SceneInstance> room{
      {Box{{0.2, 0.2, 0.2}}, Pose::translation(0.5, 0, 0), Solid::automatic, "crate"}};
  using Contacts = std::vector<RobotContact>;
  EXPECT_EQ(RobotScene(robot, room).contacts(folded), (Contacts{{1, false, 3}, {1, true, 0}, {2, true, 0}}));
  EXPECT_EQ(RobotScene(robot, room, {.allow_adjacent = false}).contacts(folded),
            (Contacts{{1, false, 2}, {1, false, 3}, {1, true, 0}, {2, false, 3}, {2, true, 0}}));
  const RobotScene allowing(robot, room, {.allowed = {{"tip", "upper"}, {"crate", "upper"}, {"crate", "lower"}}});
  EXPECT_FALSE(allowing.meets(folded));
  EXPECT_EQ(message_of([&] {
              RobotScene(robot, room, {.allowed = {{"tip", "creat"}}});
            }),
            "a pair is allowed of 'creat', and no link or obstacle is called so; did you mean 'crate'?");
  EXPECT_EQ(text_of({1, true, 0}, allowing), "upper and object \"crate\"");
  EXPECT_EQ(text_of({1, false, 3}, allowing), "upper and tip");
}

TEST(RobotScene, AttachedObjectsMeetWhatTheirLinkDoesNotHold) {
  const Robot holding = Robot(planar_robot()).with_attached({{"cup", {{Box{{0.3, 0.1, 0.1}}}}}, "tip", {}, {"lower"}});
  const std::vector<double> straight{0, 0, 0};
  EXPECT_FALSE(RobotScene(holding).meets(straight));
  const std::vector<SceneInstance> wall{{Box{{0.1, 1, 1}}, Pose::translation(2.35, 0, 0), Solid::automatic, "wall"}};
  EXPECT_EQ(RobotScene(holding, wall).contacts(straight), (std::vector<RobotContact>{{4, true, 0}}));
}

TEST(RobotScene, PointCloudsAndVoxelMapsAreObstacles) {
  Random random(3);
  std::vector<Vec3> points;
  for (int i = 0; i < 500; ++i)
    points.push_back({random.between(-2, 2), random.between(-2, 2), random.between(-0.3, 0.3)});
  const Robot robot(planar_robot());
  for (const SceneInstance& obstacle : {point_cloud(points, 0.02), voxel_map(points, 0.03)}) {
    const RobotScene scene(robot, std::span(&obstacle, 1));
    std::size_t free = 0;
    for (int i = 0; i < 20; ++i) {
      const std::vector<double> configuration{random.between(-3, 3), random.between(-2.5, 2.5), random.between(0, 1)};
      EXPECT_EQ(scene.contacts(configuration), contacts_by_pairs(scene, configuration));
      free += scene.meets(configuration) ? 0U : 1U;
    }
    EXPECT_LT(free, 20U);
  }
  EXPECT_NE(message_of([&] { static_cast<void>(point_cloud({}, 0.1)); }), "");
}

TEST(RobotScene, WhatRestsMeetsObstaclesAlways) {
  RobotDescription arm = planar_robot();
  arm.links[0].shapes = {{Box{{0.1, 0.1, 0.1}}, Pose::translation(0, 0, -1)}};
  const std::vector<SceneInstance> floor{{HalfSpace({0, 0, -1}, {0, 0, 1}), {}, Solid::automatic, "floor"}};
  const RobotScene scene(Robot(arm), floor);
  EXPECT_EQ(scene.contacts(std::vector<double>{0, 0, 0}), (std::vector<RobotContact>{{0, true, 0}}));
  EXPECT_TRUE(scene.meets(std::vector<double>{1, 2, 0}));
}

/// The least distance of all pairs that are looked at, by the question about two models.
double distance_by_pairs(const RobotScene& scene, const std::vector<double>& configuration) {
  const Robot& robot = scene.robot();
  const std::vector<SceneInstance> posed = robot.posed(configuration);
  std::set<std::pair<std::string, std::string>> adjacent;
  for (const AllowedPair& pair : adjacent_pairs(robot)) adjacent.insert({pair.a, pair.b});
  double least = INFINITY;
  const auto look_at = [&](const SceneInstance& a, const SceneInstance& b) {
    least = std::min(least, distance(a.model, b.model, {a.pose, b.pose, a.solid, b.solid}).upper);
  };
  for (std::size_t i = 0; i < posed.size(); ++i) {
    for (std::size_t j = 0; j < posed.size(); ++j) {
      const Index a = robot.bodies()[i].link, b = robot.bodies()[j].link;
      if (a < b && !adjacent.contains({robot.links()[a].name, robot.links()[b].name})) look_at(posed[i], posed[j]);
    }
    for (const SceneInstance& obstacle : scene.obstacles()) look_at(posed[i], obstacle);
  }
  return least;
}

TEST(RobotScene, TheLeastDistanceIsThatOfAllPairs) {
  const RobotScene scene(Robot(mixed_arm(2)), small_room(2));
  constexpr std::size_t samples = 40;
  const std::vector<double> configurations = sampled_configurations(scene.robot(), samples, 9);
  const auto found = scene.distance_each(configurations);
  std::size_t apart = 0;
  for (std::size_t i = 0; i < samples; ++i) {
    ASSERT_TRUE(found[i]);
    const std::vector<double> configuration = nth(configurations, i, 7);
    const double expected = distance_by_pairs(scene, configuration);
    EXPECT_LE(found[i]->distance.lower, expected);
    EXPECT_NEAR(found[i]->distance.upper, expected, 1e-11 * expected);
    EXPECT_EQ(found[i]->distance.upper == 0, scene.meets(configuration));
    apart += expected > 0 ? 1U : 0U;
    const auto limited = scene.distance(configuration, 0.5 * expected);
    EXPECT_EQ(limited.has_value(), expected == 0);
  }
  EXPECT_GT(apart, 2U);
}

TEST(RobotScene, GradientsAreThoseOfSmallChanges) {
  RobotDescription arm = mixed_arm(5);
  arm.joints[6].mimic = JointMimic{"joint 5", 0.5, 0.1};
  arm.joints[3].kind = RobotJointKind::prismatic;
  arm.joints[3].limits = JointLimits{-0.1, 0.1};
  const RobotScene scene(Robot(arm), generated_room({.boxes = 12, .meshes = true, .seed = 5}));
  const std::size_t positions = scene.robot().positions().size();
  ASSERT_EQ(positions, 6U);
  constexpr std::size_t samples = 60;
  constexpr double step = 1e-6;
  const std::vector<double> configurations = sampled_configurations(scene.robot(), samples, 11);
  std::size_t compared = 0, among_links = 0, off = 0;
  for (std::size_t i = 0; i < samples; ++i) {
    std::vector<double> configuration = nth(configurations, i, positions);
    const auto here = scene.distance(configuration);
    ASSERT_TRUE(here);
    ASSERT_EQ(here->gradient.size(), positions);
    if (here->distance.upper == 0) {
      EXPECT_EQ(here->gradient, std::vector<double>(positions));
      continue;
    }
    for (std::size_t j = 0; j < positions; ++j) {
      configuration[j] += step;
      const double after = scene.distance(configuration)->distance.upper;
      configuration[j] -= 2 * step;
      const double before = scene.distance(configuration)->distance.upper;
      configuration[j] += step;
      const double difference = (after - before) / (2 * step);
      // Where another pair of features becomes the nearest, a distance bends, and may have two gradients.
      off += std::fabs(difference - here->gradient[j]) > 1e-4 ? 1U : 0U;
      ++compared;
    }
    among_links += here->pair.with_obstacle ? 0U : 1U;
  }
  EXPECT_GT(compared, 60U);
  EXPECT_GT(among_links, 0U);
  EXPECT_LE(off * 50, compared);
}

TEST(RobotScene, EverythingIsChecked) {
  const RobotScene scene{Robot(planar_robot())};
  const std::vector<double> configuration{0, 0, 0};
  EXPECT_EQ(message_of([&] { static_cast<void>(scene.distance(configuration, -1)); }),
            "the greatest distance is -1; it has to be a length of 0 or more");
  EXPECT_EQ(message_of([&] {
              static_cast<void>(scene.meets(std::vector<double>{0, 0}));
            }),
            "a robot of 3 positions was given 2; give one number for each");
  EXPECT_EQ(message_of([&] {
              static_cast<void>(scene.meets_each(std::vector<double>{0, 0, 0, 0, 0, std::nan("")}));
            }),
            "configuration 1: the position of 'slide' is nan; it has to be finite");
  EXPECT_EQ(message_of([&] { static_cast<void>(scene.edge(configuration, configuration, {.precision = 0})); }),
            "the precision of an edge is 0; it has to be at least 2^-40, and 1 at most");
  const Robot rigid({"stone", {{"stone", {{Sphere(1)}}}}, {}, {}});
  EXPECT_FALSE(RobotScene(rigid).meets(std::vector<double>{}));
  EXPECT_NE(message_of([&] { static_cast<void>(RobotScene(rigid).meets_each(std::vector<double>{})); }), "");
}

TEST(AllowedPairs, AdjacentLinksAreJoinedAlsoByLinksWithoutShapes) {
  RobotDescription arm = planar_robot();
  arm.links[1].shapes.clear();
  arm.links[0].shapes = {{Sphere(0.1)}};
  const std::vector<AllowedPair> pairs = adjacent_pairs(Robot(arm));
  EXPECT_EQ(pairs, (std::vector<AllowedPair>{{"ground", "lower", AllowedReason::adjacent},
                                             {"lower", "tip", AllowedReason::adjacent}}));
}

TEST(AllowedPairs, SamplesTellWhyAPairNeedNotBeLookedAt) {
  RobotDescription arm = planar_robot();
  // The tip never reaches the mast, and meets the pin at rest alone; all are within the collar.
  arm.links.push_back({"mast", {{Box{{0.1, 0.1, 0.1}}, Pose::translation(0, 0, 9)}}});
  arm.links.push_back({"collar", {{Sphere(5)}}});
  arm.links.push_back({"pin", {{Sphere(0.01), Pose::translation(2, 0, 0)}}});
  for (const char* link : {"mast", "collar", "pin"})
    arm.joints.push_back({.name = std::string("to ") + link, .parent = "ground", .child = link});
  const std::vector<AllowedPair> pairs = allowed_pairs_by_samples(Robot(arm), {.samples = 200});
  const auto reason_of = [&](const std::string& a, const std::string& b) -> std::string {
    for (const AllowedPair& pair : pairs)
      if (pair.a == a && pair.b == b) return std::string(name_of(pair.reason));
    return "looked at";
  };
  EXPECT_EQ(reason_of("upper", "lower"), "adjacent");
  EXPECT_EQ(reason_of("tip", "mast"), "never");
  EXPECT_EQ(reason_of("tip", "pin"), "at rest");
  EXPECT_EQ(reason_of("upper", "collar"), "adjacent");
  EXPECT_EQ(reason_of("lower", "collar"), "always");
  EXPECT_EQ(reason_of("upper", "tip"), "looked at");
  EXPECT_EQ(pairs, allowed_pairs_by_samples(Robot(arm), {.samples = 200, .threads = 1}));
  // Each pair would be "never", seen by nobody.
  EXPECT_THROW(static_cast<void>(allowed_pairs_by_samples(Robot(arm), {.samples = 0})), Error);
}

}  // namespace
}  // namespace toccata::test
