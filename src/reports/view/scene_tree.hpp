#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "io/formats/json.hpp"
#include "reports/view/display_frame.hpp"
#include "reports/view/view_data.hpp"
#include "toccata/reports/report.hpp"

namespace toccata::io {

/// A hierarchy over the objects of a scene, as it is drawn: its boxes in the world, level by level, down to 100,000.
struct DrawnBvh {
  struct Level {
    std::size_t first = 0, count = 0;  ///< of `boxes`
    const HierarchyLevel* told = nullptr;
  };
  std::string name;
  std::vector<Aabb> boxes;
  std::vector<Level> levels;
};

/// The scene's tree of nodes as it is, cured, and rebuilt. `report` is about that scene, and outlives what is returned.
[[nodiscard]] std::array<DrawnBvh, 3> drawn_bvhs(const Scene& scene, const RebalanceReport& report);

/// Their layers: of each a slider over its levels, and all its boxes as a finding.
[[nodiscard]] std::vector<Json> scene_tree_layers(const Scene& scene, const RebalanceReport& report,
                                                  const DisplayFrame& frame, ViewData& data);

}  // namespace toccata::io
