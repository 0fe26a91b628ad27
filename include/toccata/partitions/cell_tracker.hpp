#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "toccata/core/index.hpp"
#include "toccata/partitions/grid_cells.hpp"

namespace toccata {

/// What a move has changed; ascending along the first axis, then the next.
template <std::size_t D>
struct CellChanges {
  std::vector<GridCell<D>> entered;
  std::vector<GridCell<D>> left;
};

/// Which cells of a grid objects are in as they move, and who is in a cell. A move costs what it changes: the cells
/// entered and left, and the objects in these; not all that the object is in. Memory is that of the cells in use.
///
/// Objects are known by numbers of the caller's choice; they are dense: memory is kept for all below the greatest.
template <std::size_t D>
class CellTracker {
 public:
  /// An object whose box has points outside of the grid, or in more than `most_cells` cells, is in none of them, and is
  /// among `without_cells`.
  explicit CellTracker(const GridCells<D>& grid, std::uint64_t most_cells = 4096);
  CellTracker(CellTracker&&) noexcept;
  CellTracker& operator=(CellTracker&&) noexcept;
  ~CellTracker();

  [[nodiscard]] const GridCells<D>& grid() const;
  /// Puts the object where its box is, also for the first time. The answer is valid until the next call. Throws Error
  /// where a coordinate is not finite or lower > upper: then nothing has changed.
  const CellChanges<D>& move(Index number, const GridBox<D>& box);
  /// Throws Error when there is no such object.
  const CellChanges<D>& remove(Index number);

  [[nodiscard]] bool contains(Index number) const;
  /// The cells that the object is in. None where it has no cells; throws Error when there is no such object.
  [[nodiscard]] std::optional<CellRange<D>> cells_of(Index number) const;
  /// The objects that are in the cell, ascending, each once; without those that have no cells.
  [[nodiscard]] std::vector<Index> objects_in(const GridCell<D>& cell) const;
  /// Who else is in the cells of the object, and all that have no cells, ascending, each once; of an object without
  /// cells all others. Throws Error when there is no such object.
  [[nodiscard]] std::vector<Index> neighbours(Index number) const;
  /// Ascending.
  [[nodiscard]] std::vector<Index> without_cells() const;
  /// Cells that somebody is in.
  [[nodiscard]] std::size_t cells_in_use() const;
  [[nodiscard]] std::size_t bytes() const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

extern template class CellTracker<2>;
extern template class CellTracker<3>;
extern template class CellTracker<4>;

}  // namespace toccata
