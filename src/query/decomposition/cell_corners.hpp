#pragma once

#include <span>
#include <vector>

#include "query/decomposition/cut_plane.hpp"
#include "query/decomposition/cut_search.hpp"
#include "toccata/query/model.hpp"

namespace toccata {

/// The corners of a cell near which all of the cell is solid; where that cannot be told, they are among them too.
[[nodiscard]] std::vector<RationalPoint> solid_corners(const Model& solid, std::span<const CutPlane> planes,
                                                       std::span<const CellSide> cell);

}  // namespace toccata
