#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "query/posed_shape.hpp"
#include "robots/obstacle_tree.hpp"
#include "robots/robot_tree.hpp"
#include "robots/turned_box.hpp"
#include "toccata/bounds/ball.hpp"
#include "toccata/broad/box_bvh.hpp"
#include "toccata/narrow/posed_polytope.hpp"
#include "toccata/robots/robot_scene.hpp"
#include "toccata/shapes/convex_hull.hpp"

namespace toccata {

/// A body and what it is asked about with: another body, or a part of an obstacle.
struct RobotBodyPair {
  Index body = 0;
  bool with_part = false;
  Index other = 0;
};

/// Two bodies that are looked at, the first of the lesser link; and how many frames either hangs on that the other does
/// not.
struct SelfPair {
  RobotBodyPair pair;
  std::size_t frames_of_body = 0;
  std::size_t frames_of_other = 0;
};

/// A robot and obstacles, ready. What an obstacle is made of lies in a tree part by part, where it stands.
struct RobotScene::Made {
  explicit Made(const Robot& of) : robot(of) {}

  Robot robot;
  std::vector<SceneInstance> obstacles;

  std::vector<LocalBox> body_boxes;
  std::vector<double> body_radius;                    ///< around the middle of its box, wherever it is
  std::vector<std::optional<ConvexHull>> body_hulls;  ///< of meshes
  std::vector<std::vector<Ball>> body_balls;          ///< within solid meshes, in the frame of the link
  std::vector<std::vector<Index>> body_frames;        ///< that it hangs on, from its own to the base
  std::vector<std::uint8_t> body_rests;               ///< no position moves it
  std::vector<std::uint8_t> body_is_link;             ///< it is where its link is
  std::vector<SelfPair> self_pairs;

  std::vector<PosedPart> parts;
  std::vector<TurnedBox> part_boxes;
  std::vector<std::optional<ConvexHull>> part_hulls;             ///< of meshes
  std::vector<std::shared_ptr<const PosedPolytope>> part_outer;  ///< these at their places
  std::vector<std::vector<Ball>> part_balls;                     ///< within solid meshes
  std::vector<Index> part_obstacle;
  BoxBvh nearest_parts;  ///< by their distance
  ObstacleTree part_tree;
  std::vector<double> part_radius;                  ///< around the middles of their boxes
  std::vector<std::uint8_t> allowed_with_obstacle;  ///< [link · obstacles + obstacle]

  std::vector<RobotContact> contacts_at_rest;  ///< of bodies that rest with obstacles: always

  /// Around a part, where there is one: itself where it is convex.
  [[nodiscard]] const PosedPolytope* convex_around(Index part) const {
    const auto* itself = std::get_if<PosedPolytope>(&parts[part].shape);
    return itself != nullptr ? itself : part_outer[part].get();
  }

  [[nodiscard]] const Robot::Body& body(Index number) const { return robot.bodies()[number]; }
  [[nodiscard]] bool is_allowed(Index body_number, Index part) const {
    return allowed_with_obstacle[body(body_number).link * obstacles.size() + part_obstacle[part]] != 0;
  }
  [[nodiscard]] RobotContact contact_of(const RobotBodyPair& pair) const {
    const Index link = body(pair.body).link;
    return pair.with_part ? RobotContact{link, true, part_obstacle[pair.other]}
                          : RobotContact{link, false, body(pair.other).link};
  }
};

}  // namespace toccata
