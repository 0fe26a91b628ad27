#include <fmt/format.h>

#include <array>
#include <utility>

#include "io/glb/glb_scene.hpp"
#include "io/view/scene_tree.hpp"

namespace toccata::io {
namespace {

const GlbPaint edges{"boxes of trees", 0x0072b2};

/// Both ends of the twelve edges of boxes.
std::vector<Vec3> edges_of(std::span<const Aabb> boxes) {
  std::vector<Vec3> ends;
  ends.reserve(24 * boxes.size());
  for (const Aabb& box : boxes)
    for (int axis = 0; axis < 3; ++axis)
      for (int side = 0; side < 4; ++side)
        for (const bool is_upper : {false, true}) {
          Vec3 end = is_upper ? box.upper : box.lower;
          end[(axis + 1) % 3] = (side & 1) != 0 ? box.upper[(axis + 1) % 3] : box.lower[(axis + 1) % 3];
          end[(axis + 2) % 3] = (side & 2) != 0 ? box.upper[(axis + 2) % 3] : box.lower[(axis + 2) % 3];
          ends.push_back(end);
        }
  return ends;
}

}  // namespace

void add_trees(GlbScene& glb, const Scene& scene, const RebalanceReport& report) {
  std::vector<std::size_t> trees;
  for (const DrawnTree& tree : drawn_trees(scene, report)) {
    std::vector<std::size_t> levels;
    for (const DrawnTree::Level& level : tree.levels) {
      const std::string name = fmt::format("level {}", levels.size());
      const std::vector<Vec3> ends = edges_of(std::span(tree.boxes).subspan(level.first, level.count));
      const GlbFrame frame = GlbFrame::around(ends);
      GlbWriter::Json parts = GlbWriter::Json::array();
      parts.push_back(glb.part(joined_part(ends, frame), GlbMode::lines, edges));
      levels.push_back(glb.add_node(
          name, {}, frame, {{"mesh", glb.add_mesh(name, std::move(parts))}, {"extras", {{"boxes", level.count}}}}));
    }
    if (!levels.empty()) trees.push_back(glb.add_parent("tree of nodes " + tree.name, levels));
  }
  glb.add_group("trees", trees);
}

}  // namespace toccata::io
