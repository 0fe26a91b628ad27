#include <fmt/format.h>

#include <array>
#include <utility>

#include "reports/glb/glb_scene.hpp"
#include "reports/view/scene_tree.hpp"

namespace toccata::io {
namespace {

const GlbPaint edges{"boxes of trees", 0x0072b2};

}  // namespace

void add_trees(GlbScene& glb, const Scene& scene, const RebalanceReport& report) {
  std::vector<std::size_t> trees;
  for (const DrawnBvh& tree : drawn_bvhs(scene, report)) {
    std::vector<std::size_t> levels;
    for (const DrawnBvh::Level& level : tree.levels) {
      const std::string name = fmt::format("level {}", levels.size());
      const std::span<const Aabb> boxes = std::span(tree.boxes).subspan(level.first, level.count);
      Aabb around;
      for (const Aabb& box : boxes) around = merge(around, box);
      const GlbFrame frame = GlbFrame::around(DisplayFrame::around(around));
      Json parts = Json::array();
      parts.push_back(glb.part(edges_part(boxes, {}, frame), GlbMode::lines, edges));
      levels.push_back(glb.add_node(
          name, {}, frame, {{"mesh", glb.add_mesh(name, std::move(parts))}, {"extras", {{"boxes", level.count}}}}));
    }
    if (!levels.empty()) trees.push_back(glb.add_parent("tree of nodes " + tree.name, levels));
  }
  glb.add_group("trees", trees);
}

}  // namespace toccata::io
