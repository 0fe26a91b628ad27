#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "toccata/core/random.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/query/overlap.hpp"
#include "toccata/robots/generated_arm.hpp"
#include "toccata/robots/robot_scene.hpp"

namespace toccata::test {

/// Two boxes of length 1 in a plane, and a ball that slides out of the second.
inline RobotDescription planar_robot() {
  const LinkShape bar{Box{{0.5, 0.1, 0.1}}, Pose::translation(0.5, 0, 0)};
  return {"planar",
          {{"ground"}, {"upper", {bar}}, {"lower", {bar}}, {"tip", {{Sphere(0.1)}}}},
          {{.name = "shoulder",
            .kind = RobotJointKind::continuous,
            .parent = "ground",
            .child = "upper",
            .axis = {0, 0, 2}},
           {.name = "elbow",
            .kind = RobotJointKind::revolute,
            .parent = "upper",
            .child = "lower",
            .origin = Pose::translation(1, 0, 0),
            .axis = {0, 0, 1},
            .limits = JointLimits{-3, 3}},
           {.name = "slide",
            .kind = RobotJointKind::prismatic,
            .parent = "lower",
            .child = "tip",
            .origin = Pose::translation(1, 0, 0),
            .axis = {1, 0, 0},
            .limits = JointLimits{0, 1}}},
          {}};
}

/// A description without its element of that number.
template <class T>
std::vector<T> one_of(std::vector<T> all, std::size_t number) {
  return {all[number]};
}

/// Seven joints, some shapes of every kind on its links, several on one.
inline RobotDescription mixed_arm(std::uint64_t seed) {
  Random random(seed);
  RobotDescription arm = generated_arm({.subdivisions = 1, .seed = seed});
  arm.links[2].shapes.push_back({Capsule({0, 0, 0}, {0, 0, 0.2}, 0.09)});
  arm.links[3].shapes = {{Cylinder(0.08, 0.1), Pose::translation(0, 0, 0.1)}};
  arm.links[5].shapes.push_back({Box{{0.12, 0.03, 0.03}}, Pose::rotation({0, 0, 1}, random.between(0, 90))});
  arm.links[7].shapes = {{Compound{{Sphere(0.05), Pose::translation(0, 0, 0.1)}, {Box{{0.02, 0.1, 0.02}}, {}}}}};
  arm.base = Pose{rotation_about({0, 0, 1}, random.between(0, 360)), {0.1, 0.2, 0}};
  return arm;
}

/// What a scene answers, pair by pair, by the questions about two models.
inline std::vector<RobotContact> contacts_by_pairs(const RobotScene& scene, const std::vector<double>& configuration) {
  const Robot& robot = scene.robot();
  const std::vector<SceneInstance> posed = robot.posed(configuration);
  const std::vector<AllowedPair> adjacent = adjacent_pairs(robot);
  std::vector<RobotContact> contacts;
  const auto is_adjacent = [&](Index a, Index b) {
    for (const AllowedPair& pair : adjacent)
      if (pair.a == robot.links()[a].name && pair.b == robot.links()[b].name) return true;
    return false;
  };
  const auto meet = [](const SceneInstance& a, const SceneInstance& b) {
    return overlap(a.model, b.model, {a.pose, b.pose, a.solid, b.solid});
  };
  for (Index i = 0; i < posed.size(); ++i) {
    const Index link = robot.bodies()[i].link;
    for (Index j = 0; j < posed.size(); ++j) {
      const Index other = robot.bodies()[j].link;
      if (link < other && !is_adjacent(link, other) && meet(posed[i], posed[j]))
        contacts.push_back({link, false, other});
    }
    for (Index j = 0; j < scene.obstacles().size(); ++j)
      if (meet(posed[i], scene.obstacles()[j])) contacts.push_back({link, true, j});
  }
  std::sort(contacts.begin(), contacts.end());
  contacts.erase(std::unique(contacts.begin(), contacts.end()), contacts.end());
  return contacts;
}

/// One of many written one after the other.
inline std::vector<double> nth(const std::vector<double>& configurations, std::size_t i, std::size_t positions) {
  const auto first = configurations.begin() + static_cast<std::ptrdiff_t>(i * positions);
  return {first, first + static_cast<std::ptrdiff_t>(positions)};
}

}  // namespace toccata::test
