#pragma once

#include <vector>

#include "toccata/broad/broad_phase.hpp"

namespace toccata::io {

/// Finite boxes to be drawn for the cells of a method, one for each, in their order. `scene` is around the boxes:
/// infinite sides end there. Intervals lie side by side in lanes beside the scene, as many as are ever open at once;
/// rectangles lie on a wall behind it.
[[nodiscard]] std::vector<Aabb> drawn_cells(const BroadPhaseCells& space, const Aabb& scene);

}  // namespace toccata::io
