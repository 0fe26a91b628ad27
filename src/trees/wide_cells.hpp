#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "trees/box_runs.hpp"
#include "trees/wide_frame.hpp"

namespace toccata {

/// Items by the cells of a grid, so that the first levels of a tree over many items are found from few cells (K.
/// Garanzha, J. Pantaleoni, D. McAllister, "Simpler and faster HLBVH with work queues", 2011).
struct CellGrid {
  std::unique_ptr<FloatItem[]> items;  ///< cell by cell
  std::vector<Cell> cells;             ///< those that hold items
};

/// The items that boxes tell, sorted by the cells that their centres are in: cubes, so many that most of them hold a
/// few dozen items of a surface. `around` is the box around all.
[[nodiscard]] CellGrid sort_into_cells(const BoxRuns& boxes, const Aabb& around, const WideFrame& frame, int threads);

}  // namespace toccata
