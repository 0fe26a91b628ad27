#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "query/inside/inside_point.hpp"
#include "query/relation/relation_cells.hpp"
#include "toccata/core/index.hpp"
#include "toccata/narrow/triangle_triangle.hpp"
#include "toccata/shapes/primitives.hpp"

namespace toccata {

/// A set of different triangles with area, each once whatever its orientation, and how they cut one another into
/// patches: the connected pieces of their union without the segments in which more than two of its parts, or two that
/// do not share a whole edge there, come together.
class Arrangement {
 public:
  /// `beside` are triangles that only cut those of interest. Where all that meet these are among the two, their patches
  /// are those of the whole.
  explicit Arrangement(std::vector<Triangle> of_interest, std::vector<Triangle> beside = {});

  /// Calls `visit` with a point of every patch of the triangles of interest and the triangle it lies on, of some
  /// patches more than once. Isolated points in which a sheet is touched are not avoided: `visit` asks for another.
  /// Ends when `visit` says stop.
  void visit_patches(const std::function<CellVisit(const ExactPoint&, const Triangle&)>& visit) const;

 private:
  struct Edge {
    Vec3 from;  ///< lexicographically before `to`
    Vec3 to;
    Index sheet;
    int number;  ///< in the sheet
  };

  void find_cuts();
  void note_intersection(Index i, Index j);
  void note_side(Index sheet, Index other, const Feature& on_sheet);
  [[nodiscard]] std::vector<Index> patch_leaders() const;
  [[nodiscard]] std::vector<Edge> sorted_edges() const;
  [[nodiscard]] std::vector<Triangle> cuts_of(Index sheet) const;

  std::vector<Triangle> sheets_;  ///< first those of interest
  std::size_t interest_count_;
  std::vector<std::vector<Index>> cuts_;           ///< of each sheet, the sheets that cut its interior
  std::vector<std::array<bool, 3>> edge_blocked_;  ///< touched along a part of it, other than by a whole edge
};

}  // namespace toccata
