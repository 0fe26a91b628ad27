#pragma once

#include <span>
#include <string>

#include "toccata/query/check_all.hpp"
#include "toccata/query/scene_hierarchy.hpp"

namespace toccata {

/// A scene's tree of nodes as a hierarchy, and what making it better would gain.
struct RebalanceReport {
  HierarchyReport as_is;
  HierarchyReport cured;
  HierarchyReport rebuilt;
  std::size_t named_nodes = 0;  ///< inner nodes as it is that stand for a node of the scene
  std::size_t kept_nodes = 0;   ///< of these, those that the cure keeps
  std::size_t unbounded = 0;    ///< objects that have no end and so no place in it
};

/// Takes as long as `report_of` for each of the three. Throws Error like `hierarchy_of`.
[[nodiscard]] RebalanceReport rebalance_report(const Scene& scene);

/// JSON by docs/methods/scene-graph.md#the-report.
[[nodiscard]] std::string hierarchy_report_json(const Scene& scene, std::span<const SceneInstance> models,
                                                const RebalanceReport& report, std::span<const std::string> warnings);

}  // namespace toccata
