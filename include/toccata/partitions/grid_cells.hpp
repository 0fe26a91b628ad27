#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "toccata/bounds/aabb.hpp"
#include "toccata/core/function_ref.hpp"

namespace toccata {

/// A box along the axes of D dimensions: x, y of D = 2, x, y, z of 3, x, y, z and time of 4. Closed.
template <std::size_t D>
struct GridBox {
  std::array<double, D> lower{};
  std::array<double, D> upper{};
  friend constexpr bool operator==(const GridBox&, const GridBox&) = default;
};

/// The number of a cell along each axis.
template <std::size_t D>
using GridCell = std::array<std::int32_t, D>;

/// The cells from first to last along each axis, both included.
template <std::size_t D>
struct CellRange {
  GridCell<D> first{};
  GridCell<D> last{};
  friend constexpr bool operator==(const CellRange&, const CellRange&) = default;
};

/// How many cells the range has; 2^64 − 1 when they are more.
template <std::size_t D>
[[nodiscard]] std::uint64_t cell_count(const CellRange<D>& range);

/// Calls `found` with each cell of the range, the last axis first to vary.
template <std::size_t D, class Found>
void each_cell(const CellRange<D>& range, const Found& found) {
  for (std::size_t axis = 0; axis < D; ++axis)
    if (range.last[axis] < range.first[axis]) return;
  GridCell<D> cell = range.first;
  for (std::size_t axis = D; axis > 0;) {
    found(cell);
    for (axis = D; axis > 0 && cell[axis - 1] == range.last[axis - 1]; --axis) cell[axis - 1] = range.first[axis - 1];
    if (axis > 0) ++cell[axis - 1];
  }
}

/// Space cut into cells of one size, none of them stored. Cell i of an axis holds the coordinates from plane(i) up to,
/// not including, plane(i + 1), where plane(i) = origin + i · size as rounded; so every coordinate of the grid is in
/// one cell, and which never depends on how it was found. It ends at cells ±2^30: what reaches farther has no cells.
template <std::size_t D>
class GridCells {
  static_assert(D >= 2 && D <= 4, "grids have 2, 3 or 4 dimensions");

 public:
  static constexpr std::int32_t farthest = std::int32_t{1} << 30;

  /// Throws Error for an origin that is not finite, and a size that is not above 0.
  GridCells(const std::array<double, D>& origin, const std::array<double, D>& size);

  [[nodiscard]] const std::array<double, D>& origin() const { return origin_; }
  [[nodiscard]] const std::array<double, D>& size() const { return size_; }
  [[nodiscard]] double plane(std::size_t axis, std::int32_t i) const {
    return origin_[axis] + static_cast<double>(i) * size_[axis];
  }
  /// None where the coordinate is NaN or outside of the grid.
  [[nodiscard]] std::optional<std::int32_t> index(std::size_t axis, double coordinate) const;
  /// The cells that have a point of the box. None when a corner is outside of the grid, or lower > upper.
  [[nodiscard]] std::optional<CellRange<D>> range(const GridBox<D>& box) const;
  /// The cell with its upper sides.
  [[nodiscard]] GridBox<D> box(const GridCell<D>& cell) const;

 private:
  std::array<double, D> origin_;
  std::array<double, D> size_;
};

/// Cells about twice as large as most boxes are, the size that lectures advise, the same along all axes; of items
/// without size so large that a cell holds one of them on average. The boxes are finite.
[[nodiscard]] GridCells<3> grid_for(std::span<const Aabb> boxes);

extern template class GridCells<2>;
extern template class GridCells<3>;
extern template class GridCells<4>;

/// The cells that a point is in while it moves straight from `from` to `to`, in order, each once; of D = 4 the last
/// coordinate is the time. After J. Amanatides, A. Woo, "A fast voxel traversal algorithm for ray tracing", 1987, but
/// which plane comes next is decided by exact signs: exactly these cells, also where the point passes through an edge
/// or a corner of cells. There it is, for that moment, in the cell that holds the corner.
///
/// `found` returns whether to go on. Throws Error where an end is outside of the grid.
template <std::size_t D>
void walk_cells(const GridCells<D>& cells, const std::array<double, D>& from, const std::array<double, D>& to,
                FunctionRef<bool(const GridCell<D>&)> found);

/// A box whose sides move evenly, from `begin` at the time `from` to `end` at `until`.
struct MovingBox {
  Aabb begin;
  Aabb end;
  double from = 0;
  double until = 1;
};

/// Throws Error when a number is not finite, a box has lower > upper, or from > until.
void require_motion(const MovingBox& motion);

/// A box in space and time: it contains the box at all times from `from` to `until`, which lie within the motion's;
/// larger than the least such box by rounding alone.
[[nodiscard]] GridBox<4> swept(const MovingBox& motion, double from, double until);

}  // namespace toccata
