#include "toccata/partitions/cell_tracker.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/empty_list.hpp"
#include "partitions/cell_table.hpp"
#include "partitions/shared_cells.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

/// Calls `found` with each cell of `range` that is not in `other`: slab by slab, each cell that is passed is told.
template <std::size_t D, class Found>
void each_cell_outside(CellRange<D> range, const CellRange<D>& other, const Found& found) {
  for (std::size_t axis = 0; axis < D; ++axis) {
    CellRange<D> below = range, above = range;
    below.last[axis] = std::min(range.last[axis], other.first[axis] - 1);
    each_cell(below, found);
    above.first[axis] = std::max({range.first[axis], other.last[axis] + 1, below.last[axis] + 1});
    each_cell(above, found);
    // What is left lies between.
    range.first[axis] = std::max(range.first[axis], other.first[axis]);
    range.last[axis] = std::min(range.last[axis], other.last[axis]);
    if (range.last[axis] < range.first[axis]) return;
  }
}

}  // namespace

template <std::size_t D>
class CellTracker<D>::State {
 public:
  State(const GridCells<D>& cells, std::uint64_t most) : grid(cells), most_cells_(most) {}

  const CellChanges<D>& move(Index number, const GridBox<D>& box) {
    require_box(number, box);
    if (objects_.size() <= number) objects_.resize(number + std::size_t{1});
    std::optional<CellRange<D>> range = grid.range(box);
    if (range && cell_count(*range) > most_cells_) range.reset();
    change(number, range);
    if (!range && !is_loose(number)) loose_.insert(place_in_loose(number), number);
    if (range && is_loose(number)) loose_.erase(place_in_loose(number));
    objects_[number].there = true;
    return changes_;
  }

  const CellChanges<D>& remove(Index number) {
    require_object(number);
    change(number, std::nullopt);
    if (is_loose(number)) loose_.erase(place_in_loose(number));
    objects_[number] = {};
    return changes_;
  }

  [[nodiscard]] bool contains(Index number) const { return number < objects_.size() && objects_[number].there; }
  [[nodiscard]] std::optional<CellRange<D>> cells_of(Index number) const {
    require_object(number);
    return objects_[number].cells;
  }

  [[nodiscard]] std::vector<Index> objects_in(const GridCell<D>& cell) const {
    const Index i = table_.find(cell);
    if (i == CellTable<D>::none) return {};
    std::vector<Index> objects = occupants_[i];
    std::sort(objects.begin(), objects.end());
    return objects;
  }

  [[nodiscard]] std::vector<Index> neighbours(Index number) const {
    const std::optional<CellRange<D>> range = cells_of(number);
    std::vector<Index> found = loose_;
    if (range)
      each_cell(*range, [&](const GridCell<D>& cell) {
        const std::vector<Index>& there = occupants_[table_.find(cell)];
        found.insert(found.end(), there.begin(), there.end());
      });
    else
      for (Index other = 0; other < objects_.size(); ++other)
        if (objects_[other].there) found.push_back(other);
    sort_unique(found);
    std::erase(found, number);
    return found;
  }

  [[nodiscard]] const std::vector<Index>& without_cells() const { return loose_; }
  [[nodiscard]] std::size_t cells_in_use() const { return in_use_; }
  [[nodiscard]] std::size_t bytes() const {
    std::size_t sum = table_.bytes() + objects_.capacity() * sizeof(Object) + loose_.capacity() * sizeof(Index) +
                      occupants_.capacity() * sizeof(std::vector<Index>) +
                      (changes_.entered.capacity() + changes_.left.capacity()) * sizeof(GridCell<D>);
    for (const std::vector<Index>& objects : occupants_) sum += objects.capacity() * sizeof(Index);
    return sum;
  }

  GridCells<D> grid;

 private:
  struct Object {
    std::optional<CellRange<D>> cells;
    bool there = false;
  };

  static void require_box(Index number, const GridBox<D>& box) {
    for (std::size_t axis = 0; axis < D; ++axis) {
      if (!std::isfinite(box.lower[axis]) || !std::isfinite(box.upper[axis]))
        throw Error(fmt::format("object {}: its {} is not finite", number, "xyzt"[axis]));
      if (box.lower[axis] > box.upper[axis])
        throw Error(fmt::format("object {}: its lower {} is above its upper one", number, "xyzt"[axis]));
    }
  }
  void require_object(Index number) const {
    if (!contains(number)) throw Error(fmt::format("there is no object {}: it was removed, or never placed", number));
  }

  [[nodiscard]] auto place_in_loose(Index number) { return std::lower_bound(loose_.begin(), loose_.end(), number); }
  [[nodiscard]] bool is_loose(Index number) const { return std::binary_search(loose_.begin(), loose_.end(), number); }

  void change(Index number, const std::optional<CellRange<D>>& to) {
    changes_.entered.clear();
    changes_.left.clear();
    const std::optional<CellRange<D>> from = objects_[number].cells;
    if (from == to) return;
    const CellRange<D> nothing{GridCell<D>{}, less_than_first()};
    if (to)
      each_cell_outside(*to, from.value_or(nothing), [&](const GridCell<D>& c) { changes_.entered.push_back(c); });
    if (from) each_cell_outside(*from, to.value_or(nothing), [&](const GridCell<D>& c) { changes_.left.push_back(c); });
    std::sort(changes_.entered.begin(), changes_.entered.end());
    std::sort(changes_.left.begin(), changes_.left.end());
    for (const GridCell<D>& cell : changes_.left) leave(number, cell);
    for (const GridCell<D>& cell : changes_.entered) enter(number, cell);
    objects_[number].cells = to;
  }
  static GridCell<D> less_than_first() {
    GridCell<D> cell;
    cell.fill(-1);
    return cell;
  }

  void enter(Index number, const GridCell<D>& cell) {
    const Index i = table_.put_in(cell);
    if (occupants_.size() <= i) occupants_.resize(i + std::size_t{1});
    if (occupants_[i].empty()) ++in_use_;
    occupants_[i].push_back(number);
  }
  void leave(Index number, const GridCell<D>& cell) {
    const Index i = table_.find(cell);
    std::vector<Index>& there = occupants_[i];
    *std::find(there.begin(), there.end(), number) = there.back();
    there.pop_back();
    if (!there.empty()) return;
    free_list(there);
    table_.take_out(cell);
    --in_use_;
  }

  std::uint64_t most_cells_;
  std::vector<Object> objects_;  ///< by number
  CellTable<D> table_;
  std::vector<std::vector<Index>> occupants_;  ///< by number of the cell, in no order
  std::vector<Index> loose_;                   ///< ascending
  std::size_t in_use_ = 0;
  CellChanges<D> changes_;
};

template <std::size_t D>
CellTracker<D>::CellTracker(const GridCells<D>& grid, std::uint64_t most_cells)
    : state_(std::make_unique<State>(grid, most_cells)) {}
template <std::size_t D>
CellTracker<D>::CellTracker(CellTracker&&) noexcept = default;
template <std::size_t D>
CellTracker<D>& CellTracker<D>::operator=(CellTracker&&) noexcept = default;
template <std::size_t D>
CellTracker<D>::~CellTracker() = default;

template <std::size_t D>
const GridCells<D>& CellTracker<D>::grid() const {
  return state_->grid;
}
template <std::size_t D>
const CellChanges<D>& CellTracker<D>::move(Index number, const GridBox<D>& box) {
  return state_->move(number, box);
}
template <std::size_t D>
const CellChanges<D>& CellTracker<D>::remove(Index number) {
  return state_->remove(number);
}
template <std::size_t D>
bool CellTracker<D>::contains(Index number) const {
  return state_->contains(number);
}
template <std::size_t D>
std::optional<CellRange<D>> CellTracker<D>::cells_of(Index number) const {
  return state_->cells_of(number);
}
template <std::size_t D>
std::vector<Index> CellTracker<D>::objects_in(const GridCell<D>& cell) const {
  return state_->objects_in(cell);
}
template <std::size_t D>
std::vector<Index> CellTracker<D>::neighbours(Index number) const {
  return state_->neighbours(number);
}
template <std::size_t D>
std::vector<Index> CellTracker<D>::without_cells() const {
  return state_->without_cells();
}
template <std::size_t D>
std::size_t CellTracker<D>::cells_in_use() const {
  return state_->cells_in_use();
}
template <std::size_t D>
std::size_t CellTracker<D>::bytes() const {
  return state_->bytes();
}

template class CellTracker<2>;
template class CellTracker<3>;
template class CellTracker<4>;

}  // namespace toccata
