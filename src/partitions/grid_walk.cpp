#include "toccata/partitions/grid_cells.hpp"

#include <cmath>

#include <fmt/format.h>

#include "math/constants.hpp"
#include "toccata/core/error.hpp"
#include "toccata/math/predicates.hpp"

namespace toccata {
namespace {

template <std::size_t D>
class GridWalk {
 public:
  GridWalk(const GridCells<D>& cells, const std::array<double, D>& from, const std::array<double, D>& to)
      : cells_(cells), from_(from), to_(to), cell_(cell_of(from)), end_(cell_of(to)) {}

  void run(FunctionRef<bool(const GridCell<D>&)> found) {
    while (found(cell_) && cell_ != end_) step();
  }

 private:
  [[nodiscard]] GridCell<D> cell_of(const std::array<double, D>& point) const {
    GridCell<D> cell;
    for (std::size_t axis = 0; axis < D; ++axis) {
      const std::optional<std::int32_t> index = cells_.index(axis, point[axis]);
      if (!index) throw Error(fmt::format("the point's {} {} is outside of the grid", "xyzt"[axis], point[axis]));
      cell[axis] = *index;
    }
    return cell;
  }

  [[nodiscard]] bool rises(std::size_t axis) const { return from_[axis] < to_[axis]; }
  /// The next plane across an axis along which the end is not reached yet.
  [[nodiscard]] double next_plane(std::size_t axis) const {
    return cells_.plane(axis, rises(axis) ? cell_[axis] + 1 : cell_[axis]);
  }

  /// Whether the next plane of `a` is passed before that of `b`: negative. From the line's side on which the corner of
  /// the two planes lies.
  [[nodiscard]] Sign order(std::size_t a, std::size_t b) const {
    const Sign side = orient2d(Vec2{from_[a], from_[b]}, Vec2{to_[a], to_[b]}, Vec2{next_plane(a), next_plane(b)});
    return rises(a) == rises(b) ? -side : side;
  }
  /// A cell holds its lower planes: at the same moment, upward steps come before downward ones.
  [[nodiscard]] bool comes_before(std::size_t a, std::size_t b) const {
    const Sign sign = order(a, b);
    return sign == Sign::negative || (sign == Sign::zero && rises(a) && !rises(b));
  }

  /// All axes whose planes come next at once.
  void step() {
    std::size_t next = D;
    for (std::size_t axis = 0; axis < D; ++axis)
      if (cell_[axis] != end_[axis] && (next == D || comes_before(axis, next))) next = axis;
    GridCell<D> to = cell_;
    for (std::size_t axis = 0; axis < D; ++axis)
      if (cell_[axis] != end_[axis] && !comes_before(next, axis)) to[axis] = next_cell(axis);
    cell_ = to;
  }
  /// Where planes coincide, the cells between them hold nothing.
  [[nodiscard]] std::int32_t next_cell(std::size_t axis) const {
    const double plane = next_plane(axis);
    return *cells_.index(axis, rises(axis) ? plane : std::nextafter(plane, -infinity));
  }

  const GridCells<D>& cells_;
  std::array<double, D> from_, to_;
  GridCell<D> cell_, end_;
};

}  // namespace

template <std::size_t D>
void walk_cells(const GridCells<D>& cells, const std::array<double, D>& from, const std::array<double, D>& to,
                FunctionRef<bool(const GridCell<D>&)> found) {
  GridWalk<D>(cells, from, to).run(found);
}

template void walk_cells(const GridCells<2>&, const std::array<double, 2>&, const std::array<double, 2>&,
                         FunctionRef<bool(const GridCell<2>&)>);
template void walk_cells(const GridCells<3>&, const std::array<double, 3>&, const std::array<double, 3>&,
                         FunctionRef<bool(const GridCell<3>&)>);
template void walk_cells(const GridCells<4>&, const std::array<double, 4>&, const std::array<double, 4>&,
                         FunctionRef<bool(const GridCell<4>&)>);

}  // namespace toccata
