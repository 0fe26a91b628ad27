#include "toccata/partitions/cell_tracker.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"

namespace toccata {
namespace {

template <std::size_t D>
using CellSet = std::set<GridCell<D>>;

template <std::size_t D>
CellSet<D> rasterised(const GridCells<D>& grid, const GridBox<D>& box, std::uint64_t most) {
  CellSet<D> cells;
  const auto range = grid.range(box);
  if (range && cell_count(*range) <= most) each_cell(*range, [&](const GridCell<D>& cell) { cells.insert(cell); });
  return cells;
}

template <std::size_t D>
GridBox<D> random_grid_box(Random& random, double reach) {
  GridBox<D> box;
  for (std::size_t axis = 0; axis < D; ++axis) {
    box.lower[axis] = random.between(-reach, reach);
    box.upper[axis] = box.lower[axis] + random.between(0, random.below(20) == 0 ? 9 : 2.5);
  }
  return box;
}

/// Objects come, creep, jump and go; what the tracker says is compared with rasterising everything anew.
template <std::size_t D>
void expect_tracked(std::uint64_t seed) {
  Random random(seed);
  std::array<double, D> origin{}, size;
  size.fill(1);
  const std::uint64_t most = 100;
  CellTracker<D> tracker(GridCells<D>(origin, size), most);
  std::map<Index, GridBox<D>> boxes;
  for (int step = 0; step < 250; ++step) {
    const auto number = static_cast<Index>(random.below(25));
    const CellSet<D> before = boxes.count(number) != 0 ? rasterised(tracker.grid(), boxes[number], most) : CellSet<D>{};
    const CellChanges<D>* changes = nullptr;
    if (boxes.count(number) != 0 && random.below(6) == 0) {
      boxes.erase(number);
      changes = &tracker.remove(number);
    } else {
      GridBox<D> box = random_grid_box<D>(random, step % 50 == 49 ? 1e12 : 4);
      if (boxes.count(number) != 0 && random.below(3) != 0) {
        box = boxes[number];
        for (std::size_t axis = 0; axis < D; ++axis) {
          const double by = random.between(-0.7, 0.7);
          box.lower[axis] += by;
          box.upper[axis] += by;
        }
      }
      boxes[number] = box;
      changes = &tracker.move(number, box);
    }
    const CellSet<D> after = boxes.count(number) != 0 ? rasterised(tracker.grid(), boxes[number], most) : CellSet<D>{};
    std::vector<GridCell<D>> entered, left;
    std::set_difference(after.begin(), after.end(), before.begin(), before.end(), std::back_inserter(entered));
    std::set_difference(before.begin(), before.end(), after.begin(), after.end(), std::back_inserter(left));
    ASSERT_EQ(changes->entered, entered) << "seed " << seed << " step " << step;
    ASSERT_EQ(changes->left, left) << "seed " << seed << " step " << step;

    std::map<GridCell<D>, std::vector<Index>> all;
    std::vector<Index> loose;
    for (const auto& [object, box] : boxes) {
      const CellSet<D> cells = rasterised(tracker.grid(), box, most);
      for (const GridCell<D>& cell : cells) all[cell].push_back(object);
      if (cells.empty()) loose.push_back(object);
    }
    ASSERT_EQ(tracker.cells_in_use(), all.size());
    ASSERT_EQ(tracker.without_cells(), loose);
    for (const auto& [cell, objects] : all) ASSERT_EQ(tracker.objects_in(cell), objects) << "seed " << seed;
    for (const GridCell<D>& cell : left)
      if (all.count(cell) == 0) {
        ASSERT_TRUE(tracker.objects_in(cell).empty());
      }
    for (const auto& [object, box] : boxes) {
      std::set<Index> expected(loose.begin(), loose.end());
      for (const auto& [other, its] : boxes) {
        const CellSet<D> mine = rasterised(tracker.grid(), box, most), theirs = rasterised(tracker.grid(), its, most);
        bool shared = mine.empty();
        for (const GridCell<D>& cell : mine) shared |= theirs.count(cell) != 0;
        if (shared) expected.insert(other);
      }
      expected.erase(object);
      if (step % 10 == 0) {
        ASSERT_EQ(tracker.neighbours(object), std::vector<Index>(expected.begin(), expected.end()));
      }
      if (step % 10 != 0) break;
    }
  }
}

TEST(CellTracker, TellsWhatRasterisingAnewWouldIn2D) { expect_tracked<2>(1); }
TEST(CellTracker, TellsWhatRasterisingAnewWouldIn3D) { expect_tracked<3>(2); }
TEST(CellTracker, TellsWhatRasterisingAnewWouldIn4D) { expect_tracked<4>(3); }

TEST(CellTracker, ASmallStepOfALargeObjectChangesFewCells) {
  CellTracker<3> tracker(GridCells<3>({0, 0, 0}, {1, 1, 1}), 100'000);
  EXPECT_EQ(tracker.move(0, {{0, 0, 0}, {39.5, 39.5, 39.5}}).entered.size(), 64'000U);
  const CellChanges<3>& changes = tracker.move(0, {{1, 0, 0}, {40.5, 39.5, 39.5}});
  EXPECT_EQ(changes.entered.size(), 1'600U);
  EXPECT_EQ(changes.left.size(), 1'600U);
  EXPECT_TRUE(tracker.move(0, {{1.2, 0, 0}, {40.7, 39.5, 39.5}}).entered.empty());
}

TEST(CellTracker, DoesNotGrowWhereObjectsWander) {
  CellTracker<3> tracker(GridCells<3>({0, 0, 0}, {1, 1, 1}));
  std::size_t early = 0;
  for (int step = 0; step < 3'000; ++step) {
    for (Index number = 0; number < 10; ++number) {
      const double at = 0.37 * step + number;
      tracker.move(number, {{at, 0, at}, {at + 1, 1, at + 1}});
    }
    if (step == 300) early = tracker.bytes();
  }
  EXPECT_LE(tracker.bytes(), early);
}

TEST(CellTracker, RefusesWhatIsNoBoxAndChangesNothing) {
  CellTracker<2> tracker(GridCells<2>({0, 0}, {1, 1}));
  tracker.move(3, {{0.5, 0.5}, {0.6, 0.6}});
  EXPECT_THROW(tracker.move(3, {{0, std::nan("")}, {1, 1}}), Error);
  EXPECT_THROW(tracker.move(4, {{2, 0}, {1, 1}}), Error);
  EXPECT_THROW(tracker.remove(4), Error);
  EXPECT_THROW(static_cast<void>(tracker.cells_of(0)), Error);
  EXPECT_EQ(tracker.objects_in({0, 0}), (std::vector<Index>{3}));
  EXPECT_FALSE(tracker.contains(4));
  EXPECT_EQ(tracker.remove(3).left, (std::vector<GridCell<2>>{{0, 0}}));
  EXPECT_EQ(tracker.cells_in_use(), 0U);
}

}  // namespace
}  // namespace toccata
