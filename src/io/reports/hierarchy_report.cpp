#include "toccata/io/report.hpp"

#include "io/reports/report_parts.hpp"

namespace toccata {
namespace {

using io::Json;

Json json_of(const HierarchyLevel& level) {
  return {{"nodes", level.nodes},
          {"leaves", level.leaves},
          {"most_children", level.most_children},
          {"sibling_pairs", level.sibling_pairs},
          {"overlapping_sibling_pairs", level.overlapping_sibling_pairs}};
}

Json json_of(const HierarchyReport& report) {
  Json levels = Json::array();
  for (const HierarchyLevel& level : report.levels) levels.push_back(json_of(level));
  return {{"nodes", report.nodes},
          {"leaves", report.leaves},
          {"depth", report.levels.empty() ? 0 : report.levels.size() - 1},
          {"mean_depth", report.mean_depth},
          {"most_children", report.most_children},
          {"sibling_pairs", report.sibling_pairs},
          {"overlapping_sibling_pairs", report.overlapping_sibling_pairs},
          {"N_bv", report.counts.volume_tests},
          {"N_p", report.counts.items},
          {"F", report.cost()},
          {"levels", std::move(levels)}};
}

std::size_t named_inner_nodes(const SceneHierarchy& hierarchy) {
  std::size_t named = 0;
  for (std::size_t i = 0; i < hierarchy.scene_nodes.size(); ++i)
    named += hierarchy.scene_nodes[i] && !hierarchy.tree.nodes[i].is_leaf() ? 1 : 0;
  return named;
}

}  // namespace

RebalanceReport rebalance_report(const Scene& scene) {
  const SceneHierarchy as_is = hierarchy_of(scene);
  const SceneHierarchy cured = rebalanced(as_is, Rebalance::cure);
  const SceneHierarchy rebuilt = rebalanced(as_is, Rebalance::rebuild);
  return {report_of(as_is),         report_of(cured),         report_of(rebuilt),
          named_inner_nodes(as_is), named_inner_nodes(cured), as_is.unbounded.size()};
}

std::string hierarchy_report_json(const Scene& scene, std::span<const SceneInstance> models,
                                  const RebalanceReport& report, std::span<const std::string> warnings) {
  Json json = io::report_head("toccata/hierarchy/1", scene, models, warnings);
  json["as_is"] = json_of(report.as_is);
  json["cured"] = json_of(report.cured);
  json["rebuilt"] = json_of(report.rebuilt);
  json["named_nodes"] = report.named_nodes;
  json["kept_nodes"] = report.kept_nodes;
  json["unbounded_objects"] = report.unbounded;
  return io::document(json);
}

}  // namespace toccata
