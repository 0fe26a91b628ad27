#include "reports/questions/question_kinds.hpp"
#include "reports/report_parts.hpp"
#include "toccata/core/error.hpp"
#include "toccata/reports/report.hpp"

namespace toccata {
namespace {

io::Json json_of(const HierarchyLevel& level) {
  return {{"nodes", level.nodes},
          {"leaves", level.leaves},
          {"most_children", level.most_children},
          {"sibling_pairs", level.sibling_pairs},
          {"overlapping_sibling_pairs", level.overlapping_sibling_pairs}};
}

io::Json json_of(const HierarchyReport& report) {
  io::Json levels = io::Json::array();
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

struct HierarchyKind {
  using Question = HierarchyQuestion;
  using Report = RebalanceReport;
  static constexpr const char* name = "hierarchy";

  static io::Json write(const HierarchyQuestion&) { return io::Json::object(); }

  static HierarchyQuestion read(const io::JsonValue& value) {
    value.expect_keys({"question"});
    return HierarchyQuestion{};
  }

  static RebalanceReport ask(const HierarchyQuestion&, const io::Asking& asking) {
    if (asking.scene == nullptr)
      throw Error("this is asked about a scene's tree of nodes: hand the scene over, ask(scene, models, question)");
    return rebalance_report(*asking.scene);
  }

  static std::string json(const RebalanceReport& report, const io::Reporting& reporting) {
    io::Json json = reporting.head("toccata/hierarchy/1");
    json["as_is"] = json_of(report.as_is);
    json["cured"] = json_of(report.cured);
    json["rebuilt"] = json_of(report.rebuilt);
    json["named_nodes"] = report.named_nodes;
    json["kept_nodes"] = report.kept_nodes;
    json["unbounded_objects"] = report.unbounded;
    return io::document(json);
  }
};

}  // namespace

RebalanceReport rebalance_report(const Scene& scene) {
  const SceneHierarchy as_is = hierarchy_of(scene);
  const SceneHierarchy cured = rebalanced(as_is, Rebalance::cure);
  const SceneHierarchy rebuilt = rebalanced(as_is, Rebalance::rebuild);
  return {report_of(as_is),         report_of(cured),         report_of(rebuilt),
          named_inner_nodes(as_is), named_inner_nodes(cured), as_is.unbounded.size()};
}

constinit const io::QuestionKind HierarchyQuestion::kind = io::question_kind<HierarchyKind>();

}  // namespace toccata
