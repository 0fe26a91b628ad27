#include "toccata/partitions/grid_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"

namespace toccata {
namespace {

TEST(GridCells, HoldEveryCoordinateBetweenItsPlanes) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (std::uint64_t seed = 0; seed < 2'000; ++seed) {
    Random random(seed);
    const double origin = (random.unit() - 0.5) * std::pow(10, random.between(-20, 20));
    const double size = std::pow(10, random.between(-12, 12));
    const GridCells<2> grid({origin, 0}, {size, 1});
    double at = grid.plane(0, static_cast<std::int32_t>(random.between(-1e9, 1e9)));
    for (int i = 0; i < 3; ++i, at = std::nextafter(at, i % 2 == 0 ? infinity : -infinity)) {
      const auto index = grid.index(0, at);
      // Where cells are too small for the doubles there, the grid may end with the next one.
      ASSERT_EQ(index.has_value(), grid.plane(0, -grid.farthest) <= at && at < grid.plane(0, grid.farthest));
      if (!index) continue;
      ASSERT_LE(grid.plane(0, *index), at) << "seed " << seed;
      ASSERT_GT(grid.plane(0, *index + 1), at) << "seed " << seed;
    }
  }
}

TEST(GridCells, EndAndDoNotWrap) {
  const GridCells<3> grid({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(grid.index(0, 0x1p30 - 1), GridCells<3>::farthest - 1);
  EXPECT_EQ(grid.index(0, -0x1p30), -GridCells<3>::farthest);
  for (const double beyond : {0x1p30, -0x1p30 - 1, 1e300, -1e300, std::numeric_limits<double>::infinity()})
    EXPECT_FALSE(grid.index(0, beyond)) << beyond;
  EXPECT_FALSE(grid.index(0, std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(grid.range({{0, 0, 0}, {1, 1e12, 1}}));
  const auto range = grid.range({{-0x1p30, -0x1p30, -0x1p30}, {0x1p30 - 1, 0x1p30 - 1, 0x1p30 - 1}});
  ASSERT_TRUE(range);
  EXPECT_EQ(cell_count(*range), std::numeric_limits<std::uint64_t>::max());
  const GridCells<2> greatest({1e308, -1e308}, {1e308, 1e308});
  EXPECT_EQ(greatest.index(0, -1e308), -2);
  EXPECT_EQ(greatest.index(1, 1.5e308), 1);  // plane 2 is rounded to infinity
}

std::string message_of_grid(const std::array<double, 2>& origin, const std::array<double, 2>& size) {
  try {
    const GridCells<2> grid(origin, size);
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST(GridCells, NameWhatIsWrong) {
  EXPECT_EQ(message_of_grid({0, std::nan("")}, {1, 1}), "the grid's origin y is not finite");
  EXPECT_EQ(message_of_grid({0, 0}, {1, 0}), "cells of size 0 along y: it must be above 0, and finite");
}

TEST(EachCell, PassesEachOnceInOrder) {
  std::vector<GridCell<3>> cells;
  each_cell(CellRange<3>{{-1, 2, 5}, {0, 4, 6}}, [&](const GridCell<3>& cell) { cells.push_back(cell); });
  EXPECT_EQ(cells.size(), 12U);
  EXPECT_TRUE(std::is_sorted(cells.begin(), cells.end()));
  EXPECT_EQ(std::adjacent_find(cells.begin(), cells.end()), cells.end());
  each_cell(CellRange<3>{{0, 0, 0}, {5, -1, 5}}, [&](const GridCell<3>& cell) { cells.push_back(cell); });
  EXPECT_EQ(cells.size(), 12U);
}

/// A part of the way from 0 to 1, as a fraction of whole numbers.
struct Part {
  std::int64_t over, under;
  friend bool operator<(const Part& a, const Part& b) { return a.over * b.under < b.over * a.under; }
};

template <std::size_t D>
using WholePoint = std::array<std::int64_t, D>;

/// Cells of size 2 around the whole numbers: the cells at and between all moments at which a plane is passed.
template <std::size_t D>
std::vector<GridCell<D>> cells_passed(const WholePoint<D>& from, const WholePoint<D>& to) {
  std::vector<Part> moments{{0, 1}, {1, 1}};
  for (std::size_t axis = 0; axis < D; ++axis)
    for (std::int64_t plane = -40; plane <= 40; plane += 2) {
      const std::int64_t way = to[axis] - from[axis], passed = plane - from[axis];
      if (way != 0 && passed * way >= 0 && std::abs(passed) <= std::abs(way))
        moments.push_back({std::abs(passed), std::abs(way)});
    }
  std::sort(moments.begin(), moments.end());
  const std::size_t count = moments.size();
  for (std::size_t i = 0; i + 1 < count; ++i)  // between two: a fraction between theirs
    moments.push_back({moments[i].over + moments[i + 1].over, moments[i].under + moments[i + 1].under});
  std::sort(moments.begin(), moments.end());
  std::vector<GridCell<D>> cells;
  for (const auto& [over, under] : moments) {
    GridCell<D> cell;
    for (std::size_t axis = 0; axis < D; ++axis) {
      const std::int64_t at = from[axis] * under + (to[axis] - from[axis]) * over, size = 2 * under;
      cell[axis] = static_cast<std::int32_t>(at >= 0 ? at / size : -((-at + size - 1) / size));
    }
    if (cells.empty() || cells.back() != cell) cells.push_back(cell);
  }
  return cells;
}

template <std::size_t D>
std::vector<GridCell<D>> cells_walked(const GridCells<D>& grid, const std::array<double, D>& from,
                                      const std::array<double, D>& to) {
  std::vector<GridCell<D>> cells;
  walk_cells<D>(grid, from, to, [&](const GridCell<D>& cell) {
    cells.push_back(cell);
    return cells.size() < 1'000;
  });
  return cells;
}

template <std::size_t D>
void expect_exact_walks() {
  std::array<double, D> zero{}, two;
  two.fill(2);
  const GridCells<D> grid(zero, two);
  for (std::uint64_t seed = 0; seed < 2'000; ++seed) {
    Random random(seed);
    WholePoint<D> from, to;
    std::array<double, D> begin, end;
    const std::uint64_t reach = seed % 2 == 0 ? 9 : 33;
    for (std::size_t axis = 0; axis < D; ++axis) {
      from[axis] = static_cast<std::int64_t>(random.below(reach)) - static_cast<std::int64_t>(reach / 2);
      to[axis] = static_cast<std::int64_t>(random.below(reach)) - static_cast<std::int64_t>(reach / 2);
      begin[axis] = static_cast<double>(from[axis]);
      end[axis] = static_cast<double>(to[axis]);
    }
    ASSERT_EQ(cells_walked(grid, begin, end), cells_passed<D>(from, to)) << "seed " << seed;
  }
}

TEST(WalkCells, PassesExactlyTheCellsOnTheWayIn2D) { expect_exact_walks<2>(); }
TEST(WalkCells, PassesExactlyTheCellsOnTheWayIn3D) { expect_exact_walks<3>(); }
TEST(WalkCells, PassesExactlyTheCellsOnTheWayIn4D) { expect_exact_walks<4>(); }

TEST(WalkCells, GoThroughCornersAndNotAroundThem) {
  const GridCells<2> grid({0, 0}, {1, 1});
  using Cells = std::vector<GridCell<2>>;
  EXPECT_EQ(cells_walked<2>(grid, {0.5, 0.5}, {2.5, 2.5}), (Cells{{0, 0}, {1, 1}, {2, 2}}));
  EXPECT_EQ(cells_walked<2>(grid, {2.5, 2.5}, {0.5, 0.5}), (Cells{{2, 2}, {1, 1}, {0, 0}}));
  // The corner itself belongs to the cell of which it is the lower one.
  EXPECT_EQ(cells_walked<2>(grid, {0.5, 1.5}, {1.5, 0.5}), (Cells{{0, 1}, {1, 1}, {1, 0}}));
  EXPECT_EQ(cells_walked<2>(grid, {0.5, 0.5}, {1, 1}), (Cells{{0, 0}, {1, 1}}));
  EXPECT_EQ(cells_walked<2>(grid, {1, 1}, {0.5, 0.5}), (Cells{{1, 1}, {0, 0}}));
  EXPECT_EQ(cells_walked<2>(grid, {1, 1}, {1, 1}), (Cells{{1, 1}}));
}

TEST(WalkCells, ADoubleBesideTheCornerDecides) {
  const GridCells<2> grid({0, 0}, {1, 1});
  const double above = std::nextafter(0.25, 1);
  EXPECT_EQ(cells_walked<2>(grid, {0.25, above}, {1.75, 1.75}).at(1), (GridCell<2>{0, 1}));
  EXPECT_EQ(cells_walked<2>(grid, {above, 0.25}, {1.75, 1.75}).at(1), (GridCell<2>{1, 0}));
}

TEST(WalkCells, SkipCellsThatRoundingHasEmptied) {
  const GridCells<2> grid({1e15, 0}, {0.01, 1});  // doubles are an eighth apart there
  for (const auto& [from, to] : {std::pair(1e15, 1e15 + 3), std::pair(1e15 + 3, 1e15)}) {
    const auto cells = cells_walked<2>(grid, {from, 0.5}, {to, 0.5});
    EXPECT_EQ(cells.size(), 25U);
    for (const GridCell<2>& cell : cells) EXPECT_LT(grid.plane(0, cell[0]), grid.plane(0, cell[0] + 1));
  }
}

TEST(WalkCells, EndWhenTheyAreToldToAndOutsideOfTheGridDoNotBegin) {
  const GridCells<2> grid({0, 0}, {1, 1});
  EXPECT_EQ(cells_walked<2>(grid, {0, 0}, {1e9, 1}).size(), 1'000U);
  EXPECT_THROW(cells_walked<2>(grid, {0, 0}, {1e10, 1}), Error);
}

}  // namespace
}  // namespace toccata
