#include "reports/view/scene_tree.hpp"

#include <fmt/format.h>

namespace toccata::io {
namespace {

constexpr std::size_t most_boxes = 100'000;

/// Children come after their parent, so one pass finds how deep all are.
std::vector<std::vector<Aabb>> boxes_by_depth(const Bvh<Aabb, 0>& tree) {
  std::vector<std::vector<Aabb>> levels;
  std::vector<std::size_t> depths(tree.nodes.size(), 0);
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const BvhNode<Aabb>& node = tree.nodes[i];
    if (depths[i] == levels.size()) levels.emplace_back();
    levels[depths[i]].push_back(node.volume);
    for (Index child = 0; child < node.child_count; ++child) depths[node.first + child] = depths[i] + 1;
  }
  return levels;
}

DrawnBvh drawn_bvh(const char* name, const SceneHierarchy& hierarchy, const HierarchyReport& report) {
  DrawnBvh drawn{name, {}, {}};
  const std::vector<std::vector<Aabb>> levels = boxes_by_depth(hierarchy.tree);
  for (std::size_t depth = 0; depth < levels.size(); ++depth) {
    if (drawn.boxes.size() + levels[depth].size() > most_boxes) break;
    drawn.levels.push_back({drawn.boxes.size(), levels[depth].size(), &report.levels[depth]});
    drawn.boxes.insert(drawn.boxes.end(), levels[depth].begin(), levels[depth].end());
  }
  return drawn;
}

Json written(const std::vector<Aabb>& boxes, const DisplayFrame& frame, ViewData& data) {
  std::vector<float> numbers;
  numbers.reserve(6 * boxes.size());
  for (const Aabb& box : boxes)
    for (const Vec3& corner : {box.lower, box.upper}) {
      const std::array<float, 3> place = frame.shown(corner);
      numbers.insert(numbers.end(), place.begin(), place.end());
    }
  return data.add(numbers);
}

Json steps_of(const DrawnBvh& tree) {
  Json steps = Json::array();
  for (const DrawnBvh::Level& level : tree.levels)
    steps.push_back({{"label", fmt::format("level {}", steps.size())},
                     {"note", fmt::format("{} box{}, {} of them objects; {} of {} pairs of siblings overlap",
                                          level.count, level.count == 1 ? "" : "es", level.told->leaves,
                                          level.told->overlapping_sibling_pairs, level.told->sibling_pairs)},
                     {"first", level.first},
                     {"count", level.count}});
  return steps;
}

}  // namespace

std::array<DrawnBvh, 3> drawn_bvhs(const Scene& scene, const RebalanceReport& report) {
  const SceneHierarchy as_is = hierarchy_of(scene);
  return {drawn_bvh("as it is", as_is, report.as_is),
          drawn_bvh("cured", rebalanced(as_is, Rebalance::cure), report.cured),
          drawn_bvh("rebuilt", rebalanced(as_is, Rebalance::rebuild), report.rebuilt)};
}

std::vector<Json> scene_tree_layers(const Scene& scene, const RebalanceReport& report, const DisplayFrame& frame,
                                    ViewData& data) {
  std::vector<Json> layers;
  std::size_t finding = 0;
  for (const DrawnBvh& tree : drawn_bvhs(scene, report)) {
    const Json array = written(tree.boxes, frame, data);
    layers.push_back({{"kind", "boxes"}, {"role", "tree"}, {"finding", finding++}, {"data", array}});
    layers.push_back({{"kind", "boxes"},
                      {"role", "tree"},
                      {"data", array},
                      {"name", fmt::format("The tree of nodes {}", tree.name)},
                      {"steps", steps_of(tree)}});
  }
  return layers;
}

}  // namespace toccata::io
