#include "toccata/partitions/grid_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "toccata/core/error.hpp"

namespace toccata {

template <std::size_t D>
std::uint64_t cell_count(const CellRange<D>& range) {
  std::uint64_t count = 1;
  for (std::size_t axis = 0; axis < D; ++axis) {
    if (range.last[axis] < range.first[axis]) return 0;
    const auto along = static_cast<std::uint64_t>(std::int64_t{range.last[axis]} - range.first[axis] + 1);
    if (count > std::numeric_limits<std::uint64_t>::max() / along) return std::numeric_limits<std::uint64_t>::max();
    count *= along;
  }
  return count;
}

template <std::size_t D>
GridCells<D>::GridCells(const std::array<double, D>& origin, const std::array<double, D>& size)
    : origin_(origin), size_(size) {
  for (std::size_t axis = 0; axis < D; ++axis) {
    if (!std::isfinite(origin[axis])) throw Error(fmt::format("the grid's origin {} is not finite", "xyzt"[axis]));
    if (!(size[axis] > 0 && std::isfinite(size[axis])))
      throw Error(fmt::format("cells of size {} along {}: it must be above 0, and finite", size[axis], "xyzt"[axis]));
  }
}

template <std::size_t D>
std::optional<std::int32_t> GridCells<D>::index(std::size_t axis, double coordinate) const {
  if (!(plane(axis, -farthest) <= coordinate && coordinate < plane(axis, farthest))) return std::nullopt;
  const auto holds = [&](std::int32_t i) { return plane(axis, i) <= coordinate && coordinate < plane(axis, i + 1); };
  const double quotient = std::floor((coordinate - origin_[axis]) / size_[axis]);
  const auto guess = static_cast<std::int32_t>(std::clamp(quotient, -0x1p30 + 1, 0x1p30 - 2));
  for (const std::int32_t i : {guess, guess + 1, guess - 1})
    if (holds(i)) return i;
  // Far from the origin planes coincide: of the equal ones the last.
  std::int64_t below = -farthest, above = farthest;
  while (above - below > 1) {
    const std::int64_t middle = below + (above - below) / 2;
    (plane(axis, static_cast<std::int32_t>(middle)) <= coordinate ? below : above) = middle;
  }
  return static_cast<std::int32_t>(below);
}

template <std::size_t D>
std::optional<CellRange<D>> GridCells<D>::range(const GridBox<D>& box) const {
  CellRange<D> range;
  for (std::size_t axis = 0; axis < D; ++axis) {
    const std::optional<std::int32_t> first = index(axis, box.lower[axis]), last = index(axis, box.upper[axis]);
    if (!first || !last || *last < *first) return std::nullopt;
    range.first[axis] = *first;
    range.last[axis] = *last;
  }
  return range;
}

template <std::size_t D>
GridBox<D> GridCells<D>::box(const GridCell<D>& cell) const {
  GridBox<D> box;
  for (std::size_t axis = 0; axis < D; ++axis) {
    box.lower[axis] = plane(axis, cell[axis]);
    box.upper[axis] = plane(axis, cell[axis] + 1);
  }
  return box;
}

GridCells<3> grid_for(std::span<const Aabb> boxes) {
  Aabb all;
  std::vector<double> longest_sides;
  // Halves, which do not overflow.
  const auto half_side = [](const Aabb& box) {
    const Vec3 half = 0.5 * box.upper - 0.5 * box.lower;
    return std::max({half.x, half.y, half.z});
  };
  for (const Aabb& box : boxes) {
    if (is_empty(box)) continue;
    all = merge(all, box);
    longest_sides.push_back(half_side(box));
  }
  if (longest_sides.empty()) return GridCells<3>({0, 0, 0}, {1, 1, 1});
  const auto middle = longest_sides.begin() + static_cast<std::ptrdiff_t>(longest_sides.size() / 2);
  std::nth_element(longest_sides.begin(), middle, longest_sides.end());
  const double extent = half_side(all);
  double size = std::min(4 * *middle, 0x1p1022);
  if (size == 0) size = 2 * (extent / std::cbrt(static_cast<double>(longest_sides.size())));
  size = std::max({size, extent * 0x1p-28, 0x1p-1022});
  if (extent == 0 && *middle == 0) size = 1;
  return GridCells<3>({all.lower.x, all.lower.y, all.lower.z}, {size, size, size});
}

template std::uint64_t cell_count(const CellRange<2>&);
template std::uint64_t cell_count(const CellRange<3>&);
template std::uint64_t cell_count(const CellRange<4>&);
template class GridCells<2>;
template class GridCells<3>;
template class GridCells<4>;

}  // namespace toccata
