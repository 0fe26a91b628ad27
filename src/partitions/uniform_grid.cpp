#include "toccata/partitions/uniform_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/empty_list.hpp"
#include "partitions/cell_table.hpp"
#include "partitions/shared_cells.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

template <std::size_t D>
bool overlap(const GridBox<D>& a, const GridBox<D>& b) {
  for (std::size_t axis = 0; axis < D; ++axis)
    if (!(a.lower[axis] <= b.upper[axis] && b.lower[axis] <= a.upper[axis])) return false;
  return true;
}

template <std::size_t D>
GridBox<D> without_other_axes(const Aabb& box) {
  GridBox<D> result;
  for (std::size_t axis = 0; axis < D; ++axis) {
    result.lower[axis] = box.lower[static_cast<int>(axis)];
    result.upper[axis] = box.upper[static_cast<int>(axis)];
  }
  return result;
}

/// With D = 2 the cell is as high as `all`. It ends where doubles do.
template <std::size_t D>
Aabb box_in_space(const GridBox<D>& cell, const Aabb& all) {
  constexpr double greatest = std::numeric_limits<double>::max();
  Aabb box = all;
  for (std::size_t axis = 0; axis < D; ++axis) {
    box.lower[static_cast<int>(axis)] = std::max(cell.lower[axis], -greatest);
    box.upper[static_cast<int>(axis)] = std::min(cell.upper[axis], greatest);
  }
  return box;
}

/// Clang 14 makes it for D = 4 too, where nobody calls it.
template <std::size_t D>
GridCells<D> cells_for(const PartitionItems& items) {
  const GridCells<3> grid = grid_for(items.boxes());
  std::array<double, D> origin, size;
  for (std::size_t axis = 0; axis < D; ++axis) {
    origin[axis] = grid.origin()[axis % 3];
    size[axis] = grid.size()[axis % 3];
  }
  return GridCells<D>(origin, size);
}

template <std::size_t D>
void require_box(const GridBox<D>& box, std::size_t number) {
  for (std::size_t axis = 0; axis < D; ++axis) {
    if (!std::isfinite(box.lower[axis]) || !std::isfinite(box.upper[axis]))
      throw Error(fmt::format("box {}: its {} is not finite", number, "xyzt"[axis]));
    if (box.lower[axis] > box.upper[axis])
      throw Error(fmt::format("box {}: its lower {} is above its upper one", number, "xyzt"[axis]));
  }
}

template <std::size_t D>
struct ItemInRanges {
  GridBox<D> box;
  std::vector<CellRange<D>> ranges;  ///< without a cell in common; none: no cells
};

/// From one plane of time to the next, and so on.
std::vector<CellRange<4>> cells_visited(const GridCells<4>& grid, const MovingBox& motion, std::uint64_t most_cells) {
  const auto first = grid.index(3, motion.from), last = grid.index(3, motion.until);
  if (!first || !last) return {};
  std::vector<CellRange<4>> ranges;
  for (std::int32_t slab = *first; slab <= *last; ++slab) {
    const double from = std::max(motion.from, grid.plane(3, slab));
    const double until = std::min(motion.until, grid.plane(3, slab + 1));
    auto range = from <= until ? grid.range(swept(motion, from, until)) : std::nullopt;
    if (!range) return {};
    range->first[3] = range->last[3] = slab;
    const std::uint64_t count = cell_count(*range);
    if (count > most_cells) return {};
    most_cells -= count;
    ranges.push_back(*range);
  }
  return ranges;
}

ItemInRanges<4> placed_motion(const GridCells<4>& grid, std::span<const MovingBox> motions, Index number,
                              std::uint64_t most_cells) {
  const MovingBox& motion = motions[number];
  try {
    require_motion(motion);
  } catch (const Error& error) {
    throw Error(fmt::format("motion {}: {}", number, error.what()));
  }
  return {swept(motion, motion.from, motion.until), cells_visited(grid, motion, most_cells)};
}

}  // namespace

template <std::size_t D>
class UniformGrid<D>::State {
 public:
  State(const GridCells<D>& cells, const UniformGridOptions& given) : grid(cells), options(given) {}

  void add_boxes(std::span<const GridBox<D>> all) {
    boxes.assign(all.begin(), all.end());
    for (Index item = 0; item < boxes.size(); ++item) {
      require_box(boxes[item], item);
      if (const auto range = cells_of(boxes[item]))
        each_cell(*range, [&](const GridCell<D>& cell) { put(item, cell); });
      else
        loose.push_back(item);
    }
    finish();
  }

  void add_items(const PartitionItems& all) {
    in_space = all;
    for (const Aabb& box : all.boxes()) boxes.push_back(without_other_axes<D>(box));
    for (Index item = 0; item < boxes.size(); ++item) {
      const auto range = cells_of(boxes[item]);
      if (!range) {
        loose.push_back(item);
        continue;
      }
      const bool itself = !all.triangles().empty() && range->first != range->last;
      each_cell(*range, [&](const GridCell<D>& cell) {
        if (!itself || all.meets(item, box_in_space(grid.box(cell), all.bounds()))) put(item, cell);
      });
    }
    finish();
  }

  /// Items that are each in several ranges of cells; in none where they would be in too many.
  template <class InRanges>
  void add_in_ranges(std::size_t count, const InRanges& in_ranges) {
    for (Index item = 0; item < count; ++item) {
      const ItemInRanges<D> placed = in_ranges(item);
      boxes.push_back(placed.box);
      if (placed.ranges.empty()) loose.push_back(item);
      for (const CellRange<D>& range : placed.ranges)
        each_cell(range, [&](const GridCell<D>& cell) { put(item, cell); });
    }
    finish();
  }

  /// Whatever its size, no more cells are looked at than there are.
  template <class Found>
  void each_stored_cell(const CellRange<D>& range, const Found& found) const {
    if (toccata::cell_count(range) <= table.size())
      return each_cell(range, [&](const GridCell<D>& cell) {
        if (const Index i = table.find(cell); i != CellTable<D>::none) found(i);
      });
    for (Index i = 0; i < table.size(); ++i) {
      bool inside = true;
      for (std::size_t axis = 0; axis < D; ++axis)
        inside &= range.first[axis] <= table.cell(i)[axis] && table.cell(i)[axis] <= range.last[axis];
      if (inside) found(i);
    }
  }

  /// The part of the range of the grid that the box reaches.
  [[nodiscard]] std::optional<CellRange<D>> clipped_range(const GridBox<D>& box) const {
    GridBox<D> clipped = box;
    for (std::size_t axis = 0; axis < D; ++axis) {
      const double lowest = grid.plane(axis, -grid.farthest), highest = grid.plane(axis, grid.farthest);
      if (!(box.lower[axis] < highest && box.upper[axis] >= lowest)) return std::nullopt;
      clipped.lower[axis] = std::max(box.lower[axis], lowest);
      clipped.upper[axis] = std::min(box.upper[axis], std::nextafter(highest, lowest));
    }
    return grid.range(clipped);
  }

  [[nodiscard]] std::vector<Index> near(const GridBox<D>& box) const {
    std::vector<Index> found = loose;
    if (const auto range = clipped_range(box))
      each_stored_cell(*range, [&](Index cell) {
        const std::span<const Index> items = lists[cell];
        found.insert(found.end(), items.begin(), items.end());
      });
    sort_unique(found);
    std::erase_if(found, [&](Index item) { return !overlap(boxes[item], box); });
    return found;
  }

  GridCells<D> grid;
  UniformGridOptions options;
  std::vector<GridBox<D>> boxes;
  std::optional<PartitionItems> in_space;
  CellTable<D> table;
  ItemLists lists;
  std::vector<Index> loose;

 private:
  [[nodiscard]] std::optional<CellRange<D>> cells_of(const GridBox<D>& box) const {
    const std::optional<CellRange<D>> range = grid.range(box);
    return range && toccata::cell_count(*range) <= options.most_cells ? range : std::nullopt;
  }

  void put(Index item, const GridCell<D>& cell) { entries.push_back({table.put_in(cell), item}); }

  void finish() {
    lists = item_lists(entries, table.size());
    free_list(entries);
  }

  std::vector<ItemInList> entries;
};

template <std::size_t D>
UniformGrid<D>::UniformGrid(const GridCells<D>& grid, std::span<const GridBox<D>> boxes,
                            const UniformGridOptions& options) {
  auto state = std::make_unique<State>(grid, options);
  state->add_boxes(boxes);
  state_ = std::move(state);
}

template <std::size_t D>
UniformGrid<D>::UniformGrid(const PartitionItems& items, const GridCells<D>& grid,
                            const UniformGridOptions& options) requires(D <= 3) {
  auto state = std::make_unique<State>(grid, options);
  state->add_items(items);
  state_ = std::move(state);
}

template <std::size_t D>
UniformGrid<D>::UniformGrid(const PartitionItems& items, const UniformGridOptions& options) requires(D <= 3) {
  auto state = std::make_unique<State>(cells_for<D>(items), options);
  state->add_items(items);
  state_ = std::move(state);
}

template <std::size_t D>
UniformGrid<D>::UniformGrid(const GridCells<D>& grid, std::span<const MovingBox> motions,
                            const UniformGridOptions& options) requires(D == 4) {
  auto state = std::make_unique<State>(grid, options);
  if constexpr (D == 4)
    state->add_in_ranges(motions.size(),
                         [&](Index number) { return placed_motion(grid, motions, number, options.most_cells); });
  state_ = std::move(state);
}

template <std::size_t D>
UniformGrid<D>::UniformGrid(UniformGrid&&) noexcept = default;
template <std::size_t D>
UniformGrid<D>& UniformGrid<D>::operator=(UniformGrid&&) noexcept = default;
template <std::size_t D>
UniformGrid<D>::~UniformGrid() = default;

template <std::size_t D>
const GridCells<D>& UniformGrid<D>::grid() const {
  return state_->grid;
}
template <std::size_t D>
std::size_t UniformGrid<D>::cell_count() const {
  return state_->table.size();
}
template <std::size_t D>
const GridCell<D>& UniformGrid<D>::cell(std::size_t i) const {
  return state_->table.cell(static_cast<Index>(i));
}
template <std::size_t D>
std::span<const Index> UniformGrid<D>::items_in(std::size_t i) const {
  return state_->lists[i];
}
template <std::size_t D>
std::span<const Index> UniformGrid<D>::without_cells() const {
  return state_->loose;
}

template <std::size_t D>
std::vector<Index> UniformGrid<D>::candidates(const GridBox<D>& box) const {
  return state_->near(box);
}

template <std::size_t D>
std::vector<Index> UniformGrid<D>::candidates(const Aabb& box) const requires(D <= 3) {
  std::vector<Index> found = state_->near(without_other_axes<D>(box));
  if (D == 2 && state_->in_space)
    std::erase_if(found, [&](Index item) { return !toccata::overlap(state_->in_space->boxes()[item], box); });
  return found;
}

template <std::size_t D>
std::vector<IndexPair> UniformGrid<D>::candidate_pairs() const {
  const auto may_meet = [&](Index a, Index b) {
    return D == 2 && state_->in_space ? toccata::overlap(state_->in_space->boxes()[a], state_->in_space->boxes()[b])
                                      : overlap(state_->boxes[a], state_->boxes[b]);
  };
  return pairs_sharing_lists(state_->lists, state_->boxes.size(), state_->loose, may_meet);
}

template <std::size_t D>
std::vector<PartitionCell> UniformGrid<D>::cells() const requires(D <= 3) {
  const Aabb all = state_->in_space ? state_->in_space->bounds() : Aabb{{0, 0, 0}, {0, 0, 0}};
  std::vector<PartitionCell> cells;
  cells.reserve(cell_count() + state_->loose.size());
  for (std::size_t i = 0; i < cell_count(); ++i)
    cells.push_back({box_in_space(grid().box(cell(i)), all), {items_in(i).begin(), items_in(i).end()}});
  for (const Index item : state_->loose) cells.push_back({box_in_space(state_->boxes[item], all), {item}});
  return cells;
}

template <std::size_t D>
std::size_t UniformGrid<D>::bytes() const {
  return state_->table.bytes() + state_->lists.bytes() + state_->boxes.capacity() * sizeof(GridBox<D>) +
         state_->loose.capacity() * sizeof(Index);
}

template class UniformGrid<2>;
template class UniformGrid<3>;
template class UniformGrid<4>;

}  // namespace toccata
