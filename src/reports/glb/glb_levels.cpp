#include <fmt/format.h>

#include <map>
#include <utility>

#include "reports/glb/glb_scene.hpp"
#include "reports/view/drawn_hierarchy.hpp"

namespace toccata::io {
namespace {

GlbPaint paint_of(std::size_t colour) {
  constexpr double seen_through = 0.2;
  return {fmt::format("volumes {}", colour + 1), colours_in_turn[colour], seen_through};
}

/// Without the triangles of which floats have left a line, and what only those use: rounding makes corners of volumes
/// that are hardly any.
void add_volume(GlbPart& part, const GlbPart& volume) {
  std::map<Index, Index> used;
  const auto number_of = [&](Index corner) {
    const auto [found, is_new] = used.try_emplace(corner, static_cast<Index>(part.points.size()));
    if (is_new) part.points.push_back(volume.points[corner]);
    return found->second;
  };
  for (std::size_t i = 0; i < volume.corners.size(); i += 3) {
    const Index a = volume.corners[i], b = volume.corners[i + 1], c = volume.corners[i + 2];
    if (a == b || b == c || c == a) continue;
    for (const Index corner : {a, b, c}) part.corners.push_back(number_of(corner));
  }
}

/// The volumes of a level by colour, neighbours in different ones. Each is a surface of its own.
std::array<GlbPart, colours_in_turn.size()> parts_of(const DrawnHierarchy& hierarchy, const DrawnLevel& level,
                                                     const GlbPlace& place, const GlbFrame& frame) {
  std::array<GlbPart, colours_in_turn.size()> parts;
  for (std::size_t face = level.first_face; face < level.first_face + level.faces;) {
    const Index node = hierarchy.node_of_face[face];
    std::vector<Vec3> corners;
    for (; face < level.first_face + level.faces && hierarchy.node_of_face[face] == node; ++face)
      corners.insert(corners.end(), hierarchy.faces[face].begin(), hierarchy.faces[face].end());
    add_volume(parts[node % colours_in_turn.size()], joined_part(place.placed(corners), frame));
  }
  return parts;
}

class HierarchyNodes {
 public:
  HierarchyNodes(GlbScene& glb, CostVolume volume)
      : glb_(glb), volume_(volume), hierarchies_(drawn_hierarchies(glb.models(), volume)) {}

  void add(std::size_t object) {
    const Model& model = glb_.models()[object].model;
    if (!model.has_mesh()) return;
    const DrawnHierarchy& hierarchy = hierarchies_.at(&model.mesh());
    const GlbPlace place = GlbPlace::of(glb_.models()[object].pose);
    const GlbFrame frame = place.is_plain() ? GlbFrame::around(DisplayFrame::around(model.bounds()))
                                            : GlbFrame::around(place.placed(model.mesh().vertices()));
    const std::vector<std::size_t> meshes = meshes_of(model.mesh(), hierarchy, place, frame);
    std::vector<std::size_t> levels;
    for (std::size_t i = 0; i < meshes.size(); ++i)
      levels.push_back(glb_.add_node(fmt::format("level {}", i), place.node, frame,
                                     {{"mesh", meshes[i]},
                                      {"extras",
                                       {{"volumes", hierarchy.levels[i].nodes},
                                        {"filled", hierarchy.levels[i].fill},
                                        {"overlapping_pairs", hierarchy.levels[i].overlapping_pairs}}}}));
    if (!levels.empty())
      nodes_.push_back(
          glb_.add_parent(fmt::format("hierarchy of {} over {}", name_of(volume_), glb_.name_of(object)), levels));
  }

  [[nodiscard]] const std::vector<std::size_t>& nodes() const { return nodes_; }

 private:
  /// Levels that have something to show: the volume around a single point has not. Copies of a mesh share them.
  std::vector<std::size_t> meshes_of(const TriangleMesh& mesh, const DrawnHierarchy& hierarchy, const GlbPlace& place,
                                     const GlbFrame& frame) {
    const bool is_shared = place.is_plain();
    if (const auto known = shared_.find(&mesh); is_shared && known != shared_.end()) return known->second;
    std::vector<std::size_t> meshes;
    for (const DrawnLevel& level : hierarchy.levels) {
      Json parts = Json::array();
      const auto by_colour = parts_of(hierarchy, level, place, frame);
      for (std::size_t colour = 0; colour < colours_in_turn.size(); ++colour)
        if (!by_colour[colour].corners.empty())
          parts.push_back(glb_.part(by_colour[colour], GlbMode::triangles, paint_of(colour)));
      if (parts.empty()) break;
      meshes.push_back(glb_.add_mesh(fmt::format("{} level {}", name_of(volume_), meshes.size()), std::move(parts)));
    }
    if (is_shared) shared_[&mesh] = meshes;
    return meshes;
  }

  GlbScene& glb_;
  CostVolume volume_;
  std::map<const TriangleMesh*, DrawnHierarchy> hierarchies_;
  std::map<const TriangleMesh*, std::vector<std::size_t>> shared_;
  std::vector<std::size_t> nodes_;
};

}  // namespace

void add_hierarchies(GlbScene& glb, CostVolume volume) {
  HierarchyNodes hierarchies(glb, volume);
  for (std::size_t object = 0; object < glb.models().size(); ++object) hierarchies.add(object);
  glb.add_group("hierarchies", hierarchies.nodes());
}

}  // namespace toccata::io
