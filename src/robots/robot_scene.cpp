#include "toccata/robots/robot_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "math/vec3_measures.hpp"
#include "query/scenes/posed_name.hpp"
#include "robots/each_configuration.hpp"
#include "robots/inner_balls.hpp"
#include "robots/placed_robot.hpp"
#include "robots/scene_made.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

/// A model that is no compound, at its place: what a part of an obstacle was made of.
void add_part_boxes(const Model& model, const Pose& pose, std::vector<TurnedBox>& boxes) {
  const auto* compound = std::get_if<Compound>(&model.shape());
  if (compound == nullptr) {
    boxes.push_back(turned_box(local_box(model), pose));
    return;
  }
  for (std::size_t i = 0; i < model.parts().size(); ++i)
    add_part_boxes(model.parts()[i], pose * compound->parts()[i].pose, boxes);
}

/// The hull of a mesh that may be placed so; it is posed as the mesh is.
std::optional<ConvexHull> hull_around(const Model& model, const Pose& pose) {
  if (!model.has_mesh() || model.mesh().vertices().empty() || is_singular(pose.linear)) return {};
  return ConvexHull(model.mesh().vertices());
}

/// Makes a scene ready.
class SceneMaking {
 public:
  SceneMaking(const Robot& robot, std::span<const SceneInstance> obstacles, const RobotSceneOptions& options)
      : made_(std::make_shared<RobotScene::Made>(robot)), options_(options) {
    made_->obstacles.assign(obstacles.begin(), obstacles.end());
  }

  std::shared_ptr<const RobotScene::Made> made() {
    add_bodies();
    add_parts();
    find_allowed();
    add_self_pairs();
    find_contacts_at_rest();
    return made_;
  }

 private:
  [[nodiscard]] const Robot& robot() const { return made_->robot; }

  void add_bodies() {
    const Robot::Tree& tree = robot().tree();
    for (const Robot::Body& body : tree.bodies) {
      const LocalBox box = local_box(body.model);
      made_->body_boxes.push_back(box);
      made_->body_hulls.push_back(hull_around(body.model, body.pose));
      made_->body_balls.push_back(inner_balls(body.model, body.pose, body.solid));
      made_->body_radius.push_back(radius_around(turned_box(box, body.pose)));
      made_->body_is_link.push_back(body.pose == Pose{} ? 1 : 0);
      std::vector<Index> frames;
      for (Index frame = tree.frame_of_link[body.link]; frame != 0; frame = tree.frames[frame].parent)
        frames.push_back(frame);
      const bool moves = std::ranges::any_of(
          frames, [&](Index frame) { return tree.frames[frame].motion != RobotFrame::Motion::none; });
      made_->body_rests.push_back(moves ? 0 : 1);
      made_->body_frames.push_back(std::move(frames));
    }
  }

  void add_parts() {
    std::vector<Aabb> boxes;
    for (std::size_t i = 0; i < made_->obstacles.size(); ++i) {
      const SceneInstance& obstacle = made_->obstacles[i];
      PosedModel posed = pose_model(obstacle.model, obstacle.pose, obstacle.solid, name_for_messages(obstacle, i));
      for (PosedPart& part : posed.parts) {
        boxes.push_back(world_box(part.shape));
        made_->parts.push_back(std::move(part));
        made_->part_obstacle.push_back(static_cast<Index>(i));
      }
      add_part_boxes(obstacle.model, obstacle.pose, made_->part_boxes);
    }
    for (const PosedPart& part : made_->parts) add_part_hull(part.shape);
    for (std::size_t i = 0; i < made_->parts.size(); ++i) add_around(i);
    made_->nearest_parts = BoxBvh(boxes);
    made_->part_tree = ObstacleTree(boxes);
    for (const TurnedBox& box : made_->part_boxes) made_->part_radius.push_back(radius_around(box));
  }

  void add_part_hull(const PosedShape& shape) {
    const auto* triangles = std::get_if<PosedTriangles>(&shape);
    made_->part_hulls.push_back(triangles == nullptr ? std::nullopt
                                                     : hull_around(triangles->mesh.model(), triangles->mesh.pose()));
  }

  /// Once no hull moves any more.
  void add_around(std::size_t part) {
    const auto* triangles = std::get_if<PosedTriangles>(&made_->parts[part].shape);
    std::shared_ptr<const PosedPolytope>& outer = made_->part_outer.emplace_back();
    std::vector<Ball>& balls = made_->part_balls.emplace_back();
    if (triangles == nullptr) return;
    const PosedMesh& mesh = triangles->mesh;
    if (const auto& hull = made_->part_hulls[part]) outer = std::make_shared<const PosedPolytope>(*hull, mesh.pose());
    balls = inner_balls(mesh.model(), mesh.pose(), triangles->solid ? Solid::all : Solid::none);
  }

  /// The number of a link, or after them of an obstacle; there may be several obstacles of one name.
  std::vector<Index> named(const std::string& name) const {
    std::vector<Index> found;
    const std::size_t link_count = robot().links().size();
    for (std::size_t i = 0; i < link_count; ++i)
      if (robot().links()[i].name == name) found.push_back(static_cast<Index>(i));
    for (std::size_t i = 0; i < made_->obstacles.size(); ++i)
      if (made_->obstacles[i].name == name) found.push_back(static_cast<Index>(link_count + i));
    if (!found.empty()) return found;
    std::vector<std::string> known;
    for (const RobotLink& link : robot().links()) known.push_back(link.name);
    for (const SceneInstance& obstacle : made_->obstacles) known.push_back(obstacle.name);
    throw Error(fmt::format("a pair is allowed of '{}', and no link or obstacle is called so{}", name,
                            suggestion(name, known)));
  }

  void allow(Index a, Index b) {
    const auto link_count = static_cast<Index>(robot().links().size());
    const auto [first, second] = std::minmax(a, b);
    if (first >= link_count) return;  // two obstacles
    if (second < link_count)
      allowed_links_.insert({first, second});
    else
      made_->allowed_with_obstacle[first * made_->obstacles.size() + (second - link_count)] = 1;
  }

  void find_allowed() {
    made_->allowed_with_obstacle.resize(robot().links().size() * made_->obstacles.size());
    for (const IndexPair& pair : robot().touching_attachments()) allow(pair.first, pair.second);
    const auto allow_pairs = [&](std::span<const AllowedPair> pairs) {
      for (const AllowedPair& pair : pairs)
        for (const Index a : named(pair.a))
          for (const Index b : named(pair.b)) allow(a, b);
    };
    if (options_.allow_adjacent) allow_pairs(adjacent_pairs(robot()));
    allow_pairs(options_.allowed);
  }

  void add_self_pairs() {
    const auto bodies = robot().bodies();
    for (Index a = 0; a < bodies.size(); ++a)
      for (Index b = 0; b < bodies.size(); ++b)
        if (bodies[a].link < bodies[b].link && !allowed_links_.contains({bodies[a].link, bodies[b].link}))
          made_->self_pairs.push_back(self_pair(a, b));
  }

  SelfPair self_pair(Index a, Index b) const {
    const std::vector<Index>&frames_a = made_->body_frames[a], &frames_b = made_->body_frames[b];
    std::size_t common = 0;
    while (common < frames_a.size() && common < frames_b.size() &&
           frames_a[frames_a.size() - 1 - common] == frames_b[frames_b.size() - 1 - common])
      ++common;
    return {{a, false, b}, frames_a.size() - common, frames_b.size() - common};
  }

  /// What no position moves meets obstacles everywhere or nowhere.
  void find_contacts_at_rest() {
    PlacedRobot placed(*made_);
    const std::vector<double> anywhere(robot().positions().size());
    placed.place(anywhere);
    std::set<RobotContact> contacts;
    for (Index body = 0; body < robot().bodies().size(); ++body)
      for (Index part = 0; part < made_->parts.size() && made_->body_rests[body] != 0; ++part) {
        const RobotBodyPair pair{body, true, part};
        if (!made_->is_allowed(body, part) && !placed.certainly_apart(pair, 0) && placed.overlap(pair))
          contacts.insert(made_->contact_of(pair));
      }
    made_->contacts_at_rest.assign(contacts.begin(), contacts.end());
  }

  std::shared_ptr<RobotScene::Made> made_;
  const RobotSceneOptions& options_;
  std::set<std::pair<Index, Index>> allowed_links_;
};

}  // namespace

RobotScene::RobotScene(const Robot& robot, std::span<const SceneInstance> obstacles, const RobotSceneOptions& options)
    : made_(SceneMaking(robot, obstacles, options).made()) {}

const Robot& RobotScene::robot() const { return made_->robot; }
std::span<const SceneInstance> RobotScene::obstacles() const { return made_->obstacles; }

bool RobotScene::looks_at(const RobotContact& pair) const {
  if (pair.with_obstacle) return made_->allowed_with_obstacle[pair.link * made_->obstacles.size() + pair.other] == 0;
  return std::ranges::any_of(made_->self_pairs,
                             [&](const SelfPair& self) { return made_->contact_of(self.pair) == pair; });
}

bool RobotScene::meets(std::span<const double> configuration) const {
  return of_configuration(*made_, configuration, [](PlacedRobot& placed) { return placed.meets(); });
}

std::vector<std::uint8_t> RobotScene::meets_each(std::span<const double> configurations,
                                                 const BatchOptions& options) const {
  return of_each_configuration<std::uint8_t>(*made_, configurations, options, [](PlacedRobot& placed) {
    return static_cast<std::uint8_t>(placed.meets() ? 1 : 0);
  });
}

std::vector<RobotContact> RobotScene::contacts(std::span<const double> configuration, ContactsTold told) const {
  return of_configuration(*made_, configuration, [told](PlacedRobot& placed) { return placed.contacts(told); });
}

std::vector<std::vector<RobotContact>> RobotScene::contacts_each(std::span<const double> configurations,
                                                                 ContactsTold told, const BatchOptions& options) const {
  return of_each_configuration<std::vector<RobotContact>>(
      *made_, configurations, options, [told](PlacedRobot& placed) { return placed.contacts(told); });
}

std::string text_of(const RobotContact& contact, const RobotScene& scene) {
  const auto links = scene.robot().links();
  if (!contact.with_obstacle) return fmt::format("{} and {}", links[contact.link].name, links[contact.other].name);
  return fmt::format("{} and {}", links[contact.link].name,
                     name_for_messages(scene.obstacles()[contact.other], contact.other));
}

SceneInstance point_cloud(std::span<const Vec3> points, double radius, const std::string& name) {
  std::vector<CompoundPart> balls;
  for (const Vec3& point : points) balls.push_back({Sphere(radius), Pose::translation(point)});
  return {Model(Compound(balls)), {}, Solid::automatic, name};
}

SceneInstance voxel_map(std::span<const Vec3> middles, double edge, const std::string& name) {
  const Box cell({0.5 * edge, 0.5 * edge, 0.5 * edge});
  std::vector<CompoundPart> cells;
  for (const Vec3& middle : middles) cells.push_back({cell, Pose::translation(middle)});
  return {Model(Compound(cells)), {}, Solid::automatic, name};
}

}  // namespace toccata
