#include "reports/view/drawn_hierarchy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "reports/view/display_mesh.hpp"
#include "toccata/bounds/all_volumes.hpp"
#include "toccata/core/error.hpp"
#include "toccata/trees/builders.hpp"

namespace toccata::io {
namespace {

constexpr std::size_t most_nodes = 1024;
constexpr std::size_t most_meshes = 32;

std::vector<Triangle> triangles_of(const TriangleMesh& mesh) {
  std::vector<Triangle> triangles;
  triangles.reserve(mesh.triangle_count());
  for (const auto& corner : mesh.triangles())
    triangles.push_back({{mesh.vertices()[corner[0]], mesh.vertices()[corner[1]], mesh.vertices()[corner[2]]}});
  return triangles;
}

/// The nodes of a level below these; the same ones when all are leaves.
std::vector<Index> next_level(const BvhShape& shape, const std::vector<Index>& level) {
  std::vector<Index> next;
  for (const Index number : level) {
    const auto& node = shape.nodes[number];
    if (node.is_leaf()) next.push_back(number);
    for (Index child = 0; !node.is_leaf() && child < node.child_count; ++child) next.push_back(node.first + child);
  }
  return next;
}

Vec3 normal_of(const ConvexHull& hull, Index face) {
  const HullTopology topology = hull.topology();
  Vec3 normal;
  const Index first = topology.face_start[face], end = topology.face_start[face + 1];
  const Vec3 start = hull.vertex(topology.origin[first]);
  for (Index i = first + 1; i + 1 < end; ++i)
    normal = normal + cross(hull.vertex(topology.origin[i]) - start, hull.vertex(topology.origin[i + 1]) - start);
  const double length = std::hypot(normal.x, normal.y, normal.z);
  return length > 0 ? (1 / length) * normal : normal;
}

BvhShape binary_shape(const std::vector<Triangle>& triangles) {
  return build_bvh_shape(triangles, 2, {.method = BvhMethod::heuristic, .leaf_size = 2});
}

/// The production tree as a hierarchy of up to eight children a node, with an item in each leaf.
BvhShape bvh_shape_of(const WideBvh& tree) {
  BvhShape shape{{{}}, tree.items};
  std::vector<std::int32_t> child_of{0};  // of each node, as the blocks tell it: a block, or the place of an item
  for (std::size_t number = 0; number < shape.nodes.size(); ++number) {
    const std::int32_t child = child_of[number];
    if (child < 0) {
      shape.nodes[number].first = static_cast<Index>(~child);
      shape.nodes[number].count = 1;
      continue;
    }
    const WideBlock& block = tree.blocks[static_cast<std::size_t>(child)];
    shape.nodes[number].first = static_cast<Index>(shape.nodes.size());
    shape.nodes[number].child_count = block.count;
    for (std::uint32_t lane = 0; lane < block.count; ++lane) {
      shape.nodes.emplace_back();
      child_of.push_back(block.child[lane]);
    }
  }
  return shape;
}

/// The points of which the drawn polyhedron is the hull: the corners where the volume tells them, else those that are
/// farthest along directions all around. That gives all corners where each is farthest along one. For many volumes
/// fewer directions are taken.
template <class Volume>
std::vector<Vec3> drawn_points(const Volume& volume, std::size_t siblings) {
  constexpr std::size_t few = 64;
  std::vector<Vec3> points;
  if constexpr (requires { corner_points(volume); }) points = corner_points(volume);
  if (!points.empty()) return points;
  for (const Vec3& direction : sphere_points(siblings <= few ? 8 : 4))
    points.push_back(farthest_point(volume, direction));
  return points;
}

/// Volumes of one kind around the nodes of each level.
template <class Volume>
class Drawing {
 public:
  Drawing(const std::vector<Triangle>& triangles, BvhShape shape) : shape_(std::move(shape)), runs_(item_runs(shape_)) {
    for (const Index item : shape_.items) ordered_.push_back(triangles[item]);
    drawn_.order = shape_.items;
  }

  DrawnHierarchy all_levels() {
    std::vector<Index> level{0};
    while (level.size() <= most_nodes) {
      add_level(level);
      std::vector<Index> next = next_level(shape_, level);
      if (next == level) break;
      level = std::move(next);
    }
    return std::move(drawn_);
  }

 private:
  static constexpr bool is_round = requires(const Volume& volume) { round_volume(volume); };

  [[nodiscard]] std::span<const Triangle> held_by(Index node) const {
    return std::span<const Triangle>(ordered_).subspan(runs_[node].first, runs_[node].count);
  }

  void add_level(const std::vector<Index>& nodes) {
    DrawnLevel& level = drawn_.levels.emplace_back();
    level.first_node = drawn_.runs.size();
    level.nodes = nodes.size();
    level.first_face = drawn_.faces.size();
    std::vector<Volume> volumes;
    double size = 0, held = 0;
    for (const Index node : nodes) {
      drawn_.runs.push_back({runs_[node].first, runs_[node].count});
      volumes.push_back(fit<Volume>(held_by(node)));
      size += measure(volumes.back());
      held += measure(fit<HullBound>(held_by(node)));
      draw(volumes.back(), nodes.size(), static_cast<Index>(volumes.size() - 1));
      if constexpr (is_round) drawn_.rounds.push_back(round_volume(volumes.back()));
    }
    level.fill = size > 0 ? std::min(1.0, held / size) : 0;
    level.overlapping_pairs = overlapping_pairs(volumes);
    level.faces = drawn_.faces.size() - level.first_face;
  }

  static std::size_t overlapping_pairs(const std::vector<Volume>& volumes) {
    std::vector<Aabb> boxes;
    for (const Volume& volume : volumes) boxes.push_back(box_around(volume));
    std::size_t count = 0;
    for (std::size_t i = 0; i < volumes.size(); ++i)
      for (std::size_t j = i + 1; j < volumes.size(); ++j)
        if (overlap(boxes[i], boxes[j]) && overlap(volumes[i], volumes[j])) ++count;
    return count;
  }

  void draw(const Volume& volume, std::size_t siblings, Index number) {
    draw(ConvexHull(drawn_points(volume, siblings)), number);
  }

  void draw(const ConvexHull& hull, Index number) {
    const HullTopology topology = hull.topology();
    if (hull.dimension() < 1) return;
    for (Index face = 0; face < topology.face_count(); ++face) {
      const Index first = topology.face_start[face], end = topology.face_start[face + 1];
      const auto is_drawn = [&](Index edge) {
        return is_edge(hull, topology.face[edge], topology.face[topology.twin[edge]]);
      };
      for (Index i = first + 1; i + 1 < end; ++i) {
        drawn_.faces.push_back({hull.vertex(topology.origin[first]), hull.vertex(topology.origin[i]),
                                hull.vertex(topology.origin[i + 1])});
        drawn_.node_of_face.push_back(number);
        const bool sides[3] = {i == first + 1 && is_drawn(first), is_drawn(i), i + 2 == end && is_drawn(i + 1)};
        drawn_.edges_of_face.push_back(
            static_cast<std::uint8_t>((sides[0] ? 1U : 0U) | (sides[1] ? 2U : 0U) | (sides[2] ? 4U : 0U)));
      }
    }
  }

  /// Faces that rounding alone has parted have no edge between them, and round volumes none at all.
  static bool is_edge(const ConvexHull& hull, Index one, Index other) {
    if (is_round) return false;
    return one == other || dot(normal_of(hull, one), normal_of(hull, other)) < 0.9999;
  }

  BvhShape shape_;
  std::vector<ItemRun> runs_;
  std::vector<Triangle> ordered_;
  DrawnHierarchy drawn_;
};

template <class Volume>
DrawnHierarchy drawn(const std::vector<Triangle>& triangles) {
  return Drawing<Volume>(triangles, binary_shape(triangles)).all_levels();
}

}  // namespace

DrawnHierarchy drawn_hierarchy(const Model& model, CostVolume volume) {
  const std::vector<Triangle> triangles = triangles_of(model.mesh());
  if (volume == CostVolume::wide) return Drawing<Aabb>(triangles, bvh_shape_of(model.wide_bvh())).all_levels();
  constexpr auto drawings = AllVolumes::of_each([]<class V>(std::type_identity<V>) { return &drawn<V>; });
  return drawings[static_cast<std::size_t>(volume)](triangles);
}

std::map<const TriangleMesh*, DrawnHierarchy> drawn_hierarchies(std::span<const SceneInstance> models,
                                                                CostVolume volume) {
  std::map<const TriangleMesh*, const Model*> model_of;
  for (const SceneInstance& posed : models)
    if (posed.model.has_mesh()) model_of.try_emplace(&posed.model.mesh(), &posed.model);
  if (model_of.size() > most_meshes)
    throw Error(fmt::format("hierarchies of more than {} meshes are too many to look at: show fewer", most_meshes));
  std::map<const TriangleMesh*, DrawnHierarchy> hierarchies;
  for (const auto& [mesh, model] : model_of) hierarchies.emplace(mesh, drawn_hierarchy(*model, volume));
  return hierarchies;
}

}  // namespace toccata::io
