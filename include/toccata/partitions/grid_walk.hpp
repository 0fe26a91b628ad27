#pragma once

#include <array>

#include "toccata/core/function_ref.hpp"
#include "toccata/partitions/grid_cells.hpp"

namespace toccata {

/// The cells that a point is in while it moves straight from `from` to `to`, in order, each once; of D = 4 the last
/// coordinate is the time. After J. Amanatides, A. Woo, "A fast voxel traversal algorithm for ray tracing", 1987, but
/// which plane comes next is decided by exact signs: exactly these cells, also where the point passes through an edge
/// or a corner of cells. There it is, for that moment, in the cell that holds the corner.
///
/// `found` returns whether to go on. Throws Error where an end is outside of the grid.
template <std::size_t D>
void walk_cells(const GridCells<D>& cells, const std::array<double, D>& from, const std::array<double, D>& to,
                FunctionRef<bool(const GridCell<D>&)> found);

}  // namespace toccata
