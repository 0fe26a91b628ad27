#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "toccata/core/index.hpp"
#include "toccata/partitions/grid_cells.hpp"

namespace toccata {

/// Cells of a grid by number, found by hashing with linear probing. The numbers of those taken out are given out again.
template <std::size_t D>
class CellTable {
 public:
  static constexpr Index none = std::numeric_limits<Index>::max();

  /// All numbers are less.
  [[nodiscard]] std::size_t size() const { return cells_.size(); }
  [[nodiscard]] const GridCell<D>& cell(Index number) const { return cells_[number]; }

  [[nodiscard]] Index find(const GridCell<D>& cell) const { return slots_.empty() ? none : slots_[slot_of(cell)]; }
  /// The cell's number, a new one where it has none.
  Index put_in(const GridCell<D>& cell) {
    if (2 * (used_ + 1) > slots_.size()) grow();
    Index& number = slots_[slot_of(cell)];
    if (number != none) return number;
    ++used_;
    return number = new_number(cell);
  }
  /// The cell is in the table.
  void take_out(const GridCell<D>& cell) {
    std::size_t hole = slot_of(cell);
    free_.push_back(slots_[hole]);
    slots_[hole] = none;
    --used_;
    // What was put behind because the hole was taken moves up.
    for (std::size_t at = next(hole); slots_[at] != none; at = next(at)) {
      const std::size_t home = home_of(cells_[slots_[at]]);
      if (((at - home) & (slots_.size() - 1)) < ((at - hole) & (slots_.size() - 1))) continue;
      slots_[hole] = slots_[at];
      slots_[at] = none;
      hole = at;
    }
  }

  [[nodiscard]] std::size_t bytes() const {
    return cells_.capacity() * sizeof(GridCell<D>) + (slots_.capacity() + free_.capacity()) * sizeof(Index);
  }

 private:
  [[nodiscard]] std::size_t next(std::size_t slot) const { return (slot + 1) & (slots_.size() - 1); }
  [[nodiscard]] std::size_t home_of(const GridCell<D>& cell) const {
    std::uint64_t hash = 0;
    for (const std::int32_t i : cell) {
      hash = (hash ^ static_cast<std::uint32_t>(i)) * 0x9e3779b97f4a7c15ULL;
      hash ^= hash >> 32;
    }
    return static_cast<std::size_t>(hash) & (slots_.size() - 1);
  }
  /// Where the cell is, or would be.
  [[nodiscard]] std::size_t slot_of(const GridCell<D>& cell) const {
    std::size_t slot = home_of(cell);
    while (slots_[slot] != none && cells_[slots_[slot]] != cell) slot = next(slot);
    return slot;
  }

  void grow() {
    const std::vector<Index> old = std::move(slots_);
    slots_.assign(std::max<std::size_t>(16, 2 * old.size()), none);
    for (const Index number : old)
      if (number != none) slots_[slot_of(cells_[number])] = number;
  }
  Index new_number(const GridCell<D>& cell) {
    if (free_.empty()) {
      cells_.push_back(cell);
      return static_cast<Index>(cells_.size() - 1);
    }
    const Index number = free_.back();
    free_.pop_back();
    cells_[number] = cell;
    return number;
  }

  std::vector<GridCell<D>> cells_;  ///< by number
  std::vector<Index> slots_;        ///< a power of two of them, at most half of them in use
  std::vector<Index> free_;
  std::size_t used_ = 0;
};

}  // namespace toccata
