#pragma once

#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "reports/glb/glb_frame.hpp"
#include "reports/glb/glb_writer.hpp"
#include "reports/view/view_meshes.hpp"
#include "toccata/partitions/measure.hpp"
#include "toccata/reports/pages.hpp"
#include "toccata/reports/scene_question.hpp"

namespace toccata::io {

/// A colour of M. Okabe and K. Ito ("Color universal design", 2008), and how much it covers.
struct GlbPaint {
  std::string name;
  unsigned colour = 0;
  double cover = 1;
};

/// The colours of levels and of parts, one after the other.
constexpr std::array<unsigned, 6> colours_in_turn{0x0072b2, 0xe69f00, 0x009e73, 0xcc79a7, 0x56b4e9, 0xd55e00};

/// Where a mesh lies: some poses no node can have, and its vertices take them.
struct GlbPlace {
  Pose node;
  Pose vertices;

  static GlbPlace of(const Pose& pose);
  [[nodiscard]] bool is_plain() const { return vertices == Pose{}; }
  /// Its vertices as they are in the frame of the node.
  [[nodiscard]] std::vector<Vec3> placed(std::span<const Vec3> points) const;
};

/// Where something that moves is from a frame on: nowhere while it has no pose.
struct GlbKey {
  std::size_t frame = 0;
  std::optional<Pose> pose{};
};

/// A key for each pose, one a frame.
[[nodiscard]] std::vector<GlbKey> keys_of(std::span<const Pose> poses);

/// A GLB file that is being filled with objects and what was found of them: groups of nodes under one that holds the
/// unit, the axes, and where the scene is.
class GlbScene {
 public:
  GlbScene(std::span<const SceneInstance> models, const ViewMeshes& meshes)
      : models_(models), meshes_(&meshes), frame_(GlbFrame::around(meshes.frame())) {}
  /// For things around that place, and not for the objects: nothing is drawn of these.
  GlbScene(std::span<const SceneInstance> models, const DisplayFrame& place, GlbWriter writer)
      : models_(models), frame_(GlbFrame::around(place)), writer_(std::move(writer)) {}

  [[nodiscard]] std::span<const SceneInstance> models() const { return models_; }
  [[nodiscard]] const ViewMeshes& meshes() const { return *meshes_; }
  [[nodiscard]] std::string name_of(std::size_t object) const;
  /// From what is drawn of the object to the world.
  [[nodiscard]] Pose pose_of(std::size_t object) const;

  /// A primitive of these points, or of what `corners` make of them.
  [[nodiscard]] Json part(const GlbPart& part, GlbMode mode, const GlbPaint& paint);
  [[nodiscard]] Json painted(Json part, const GlbPaint& paint);
  std::size_t add_mesh(const std::string& name, Json parts);
  /// A node at `pose`, of what is counted in `own`; `more` are its other members.
  std::size_t add_node(const std::string& name, const Pose& pose, const GlbFrame& own, const Json& more);
  std::size_t add_parent(const std::string& name, const std::vector<std::size_t>& children);
  void add_group(const std::string& name, const std::vector<std::size_t>& children);
  /// A node without a mesh that tells how many pairs were not looked at.
  void add_stopped(std::size_t unfinished);

  // Answers about many poses: one a frame of 24 a second, all in one animation.

  /// A node of an object that moves, under the one that moves it: as `add_node`, but in the object's own frame.
  std::size_t add_moved(const std::string& name, const Pose& pose, const GlbFrame& own, const Json& more);
  /// What moves `child`: the keys' frames ascend from 0, and some key has a pose. Throws Error naming the first pose
  /// that no node can have.
  std::size_t add_moving(const std::string& name, std::size_t child, std::span<const GlbKey> keys);
  /// What is seen at one of so many poses alone.
  std::size_t add_at_pose(const std::string& name, const std::vector<std::size_t>& children, std::size_t pose,
                          std::size_t poses, const Json& more);

  /// To be asked for once.
  [[nodiscard]] std::string file(const ViewOptions& options, const std::string& unit);
  /// What is filled, and the node under which all is.
  std::pair<GlbWriter, std::size_t> take(const ViewOptions& options, const std::string& unit) &&;

 private:
  std::size_t add_root(const ViewOptions& options, const std::string& unit);
  std::size_t node_at(const std::string& name, const Pose& pose, const Json& more);
  [[nodiscard]] GlbTurn turn_at(const std::string& name, const GlbKey& key) const;
  /// `keys` of a node's translation, rotation or scale, each held until the next.
  void animate(std::size_t node, const char* path, const std::vector<float>& times, std::span<const float> keys,
               std::size_t width);
  std::size_t material(const GlbPaint& paint);

  std::span<const SceneInstance> models_;
  const ViewMeshes* meshes_ = nullptr;
  GlbFrame frame_;
  GlbWriter writer_;
  std::map<std::string, std::size_t> materials_;
  std::vector<std::size_t> groups_;
  std::map<std::vector<float>, std::size_t> times_;  ///< which several things move by
  Json samplers_ = Json::array();
  Json channels_ = Json::array();
};

/// Points, each kept once, and their numbers in the order given.
[[nodiscard]] GlbPart joined_part(std::span<const Vec3> points, const GlbFrame& frame);

/// The edges of boxes in the frame of a place, each box by itself.
[[nodiscard]] GlbPart edges_part(std::span<const Aabb> boxes, const GlbPlace& place, const GlbFrame& frame);

/// Every object under its name, those of which something was found seen through and in the two colours.
void add_objects(GlbScene& glb, const SceneAnswer& answer);
/// Every object through its keys; seen through are those of which `is_named` says so.
void add_moving_objects(GlbScene& glb, const std::vector<std::vector<GlbKey>>& keys, const std::vector<bool>& is_named);
/// What was found: of pairs the faces and curves in which they meet, depth, distance; ways of rays, and so on.
void add_findings(GlbScene& glb, const SceneAnswer& answer);
/// The scene's tree of nodes as it is, cured, and rebuilt: the edges of its boxes, level by level.
void add_trees(GlbScene& glb, const Scene& scene, const RebalanceReport& report);
/// Adds the levels of a hierarchy of each mesh. Throws Error when there are too many meshes to be looked at.
void add_hierarchies(GlbScene& glb, CostVolume volume);
/// Adds the edges of the cells of a partition of space over each mesh, depth by depth. Throws Error as partition_layers
/// does.
void add_partitions(GlbScene& glb, PartitionKind kind);
/// Adds the Voronoi regions of each convex polytope. Throws Error as voronoi_layers does.
void add_voronoi(GlbScene& glb);
/// Adds the walk through each pair of convex polytopes, visit by visit. Throws Error as voronoi_walk_layers does.
void add_voronoi_walks(GlbScene& glb);

}  // namespace toccata::io
