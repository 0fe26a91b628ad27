#pragma once

#include <array>
#include <optional>
#include <vector>

#include "query/decomposition/cut_plane.hpp"
#include "query/decomposition/cut_search.hpp"
#include "toccata/query/model.hpp"

namespace toccata {

/// A cell, or two: what lies in front of a plane and behind it.
struct CutNode {
  std::optional<Index> plane;
  std::array<Index, 2> child{};  ///< in front and behind; nodes come after their parents
};

/// Planes that cut space, each within a cell of those before it. Node 0 is all of space.
struct CutTree {
  std::vector<CutPlane> planes;
  std::vector<CutNode> nodes{CutNode{}};
};

/// What of a solid lies in a cell.
struct CellContent {
  std::vector<Vec3> points;      ///< their convex hull contains it
  std::vector<Index> triangles;  ///< that have more than their border in the cell
};

/// The content of each node that is a cell, by its number; nothing for other nodes. The union of the hulls contains the
/// solid and its surface.
[[nodiscard]] std::vector<CellContent> cell_contents(const Model& solid, const CutTree& tree);

}  // namespace toccata
