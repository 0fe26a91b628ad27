#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "toccata/partitions/grid_cells.hpp"
#include "toccata/partitions/partition.hpp"

namespace toccata {

struct UniformGridOptions {
  /// An item whose box reaches over more cells, or out of the grid, is in none, and is compared with everything: memory
  /// stays within so many copies of each item.
  std::uint64_t most_cells = 4096;
};

/// Space cut into cells of one size, each with the list of items that reach into it: items are rasterised as lines of a
/// picture are. Only cells that hold something are stored. Space-centric: an item is in every cell it meets.
///
/// With D = 2 the axes are x and y (cells are columns along z), with 3 they are x, y and z, and with 4 time is the
/// fourth.
template <std::size_t D>
class UniformGrid {
 public:
  /// A grid of boxes, which are items by their number. Throws Error naming one that is not finite or has lower > upper.
  UniformGrid(const GridCells<D>& grid, std::span<const GridBox<D>> boxes, const UniformGridOptions& options = {});
  /// A triangle is in the cells that it meets itself, exactly, not all that its box meets.
  UniformGrid(const PartitionItems& items, const GridCells<D>& grid,
              const UniformGridOptions& options = {}) requires(D <= 3);
  /// The same with the cells of `grid_for`.
  explicit UniformGrid(const PartitionItems& items, const UniformGridOptions& options = {}) requires(D <= 3);
  /// Boxes that move, each in the cells of space and time that it visits: none is missing, and there may be
  /// some that it comes up to by a rounding error, or reaches when their time ends. Throws Error naming one that is no
  /// motion.
  UniformGrid(const GridCells<D>& grid, std::span<const MovingBox> motions,
              const UniformGridOptions& options = {}) requires(D == 4);

  UniformGrid(UniformGrid&&) noexcept;
  UniformGrid& operator=(UniformGrid&&) noexcept;
  ~UniformGrid();

  [[nodiscard]] const GridCells<D>& grid() const;
  /// The number of cells that hold an item.
  [[nodiscard]] std::size_t cell_count() const;
  [[nodiscard]] const GridCell<D>& cell(std::size_t i) const;
  [[nodiscard]] std::span<const Index> items_in(std::size_t i) const;
  /// The items in no cell, ascending: too large, or outside of the grid.
  [[nodiscard]] std::span<const Index> without_cells() const;

  /// Items whose box overlaps and that share a cell with it, and those without cells, ascending, each once.
  [[nodiscard]] std::vector<Index> candidates(const GridBox<D>& box) const;
  [[nodiscard]] std::vector<Index> candidates(const Aabb& box) const requires(D <= 3);
  [[nodiscard]] std::vector<IndexPair> candidate_pairs() const;
  /// An item without cells is a cell of its own here. Columns are as high as all items are.
  [[nodiscard]] std::vector<PartitionCell> cells() const requires(D <= 3);
  [[nodiscard]] std::size_t bytes() const;

 private:
  class State;
  std::unique_ptr<const State> state_;
};

extern template class UniformGrid<2>;
extern template class UniformGrid<3>;
extern template class UniformGrid<4>;

}  // namespace toccata
