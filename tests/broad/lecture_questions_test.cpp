// The questions and worked examples of the lectures about many boxes, each shown (docs/methods/questions.md lists
// them).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "broad/incremental_sweep.hpp"
#include "toccata/broad/bound_pairs.hpp"
#include "toccata/core/random.hpp"
#include "toccata/generate/crowds.hpp"
#include "toccata/partitions/grid_cells.hpp"

namespace toccata {
namespace {

enum Colour : Index { orange, green, red, blue };

/// Boxes that overlap along x and y as the third lecture says of its four ("Dimension reduction"), and lie in the cells
/// of side 1 that it names ("2D spatial hashing"), a key being two bits of y and two of x: one picture for both.
const std::vector<Rectangle> coloured{
    {0.125, 1.25, 0.25, 0.5}, {0.5, 0.5, 0.75, 1.125}, {1.125, 1.375, 0.625, 1.125}, {1.5, 0.25, 1, 0.875}};

std::vector<IndexPair> pairs_along(double Rectangle::*start, double Rectangle::*length) {
  std::vector<LineInterval> intervals;
  for (const Rectangle& box : coloured) intervals.push_back({box.*start, box.*start + box.*length});
  return overlapping_pairs(intervals);
}

TEST(LectureQuestion, OfTheFourColouredBoxesOnePairOverlapsAlongBothAxes) {
  using Pairs = std::vector<IndexPair>;
  EXPECT_EQ(pairs_along(&Rectangle::x, &Rectangle::width), (Pairs{{green, red}, {red, blue}}));
  EXPECT_EQ(pairs_along(&Rectangle::y, &Rectangle::height),
            (Pairs{{orange, green}, {orange, red}, {green, red}, {green, blue}}));
  for (const BroadPhaseMethod method : broad_phase_methods())
    EXPECT_EQ(overlapping_pairs(coloured, {.method = method}), (Pairs{{green, red}})) << name_of(method);
}

GridBox<2> grid_box(const Rectangle& box) { return {{box.x, box.y}, {box.x + box.width, box.y + box.height}}; }

TEST(LectureQuestion, TheKeysOfTheFourColouredBoxesGiveFourCandidatesOneOfThemTwice) {
  const GridCells<2> grid({0, 0}, {1, 1});
  std::map<int, std::vector<Index>> table;
  std::vector<std::set<int>> keys(coloured.size());
  for (Index box = 0; box < coloured.size(); ++box)
    each_cell(*grid.range(grid_box(coloured[box])), [&](const GridCell<2>& cell) {
      const int key = cell[1] << 2 | cell[0];  // the bits, one after the other
      keys[box].insert(key);
      table[key].push_back(box);
    });
  EXPECT_EQ(keys[orange], (std::set<int>{0b0100}));
  EXPECT_EQ(keys[green], (std::set<int>{0b0100, 0b0000, 0b0101, 0b0001}));
  EXPECT_EQ(keys[red], (std::set<int>{0b1001, 0b0101}));
  EXPECT_EQ(keys[blue], (std::set<int>{0b0101, 0b0110, 0b0001, 0b0010}));

  std::map<IndexPair, int> candidates;
  for (const auto& [key, boxes] : table)
    for (std::size_t i = 0; i < boxes.size(); ++i)
      for (std::size_t j = i + 1; j < boxes.size(); ++j) ++candidates[{boxes[i], boxes[j]}];
  const std::map<IndexPair, int> expected{
      {{orange, green}, 1}, {{green, red}, 1}, {{green, blue}, 2}, {{red, blue}, 1}};
  EXPECT_EQ(candidates, expected);
  // "Would clean up with an explicit bounding volume test": one is left.
  std::erase_if(candidates,
                [](const auto& entry) { return !overlap(coloured[entry.first.first], coloured[entry.first.second]); });
  EXPECT_EQ(candidates.size(), 1U);
  EXPECT_TRUE(candidates.contains({green, red}));
}

TEST(LectureQuestion, WhatEndsWhereAnotherStartsTouchesIt) {
  // A sweep that takes ends before starts of the same place would lose both pairs.
  const std::vector<LineInterval> row{{0, 1}, {1, 2}, {2, 2}};
  EXPECT_EQ(overlapping_pairs(row), (std::vector<IndexPair>{{0, 1}, {1, 2}}));
}

TEST(LectureQuestion, OneAxisAndOnePlaneFindFarMoreThanOverlapsInSpace) {
  const Crowd crowd("uniform", 1000);
  std::vector<LineInterval> along_x;
  std::vector<Rectangle> in_xy;
  for (const Aabb& box : crowd.boxes()) {
    const Vec3 size = box.upper - box.lower;
    along_x.push_back({box.lower.x, box.upper.x});
    in_xy.push_back({box.lower.x, box.lower.y, size.x, size.y});
  }
  const std::size_t axis = overlapping_pairs(along_x).size(), plane = overlapping_pairs(in_xy).size();
  const std::size_t space = overlapping_pairs(crowd.boxes()).size();
  EXPECT_GT(axis, 4 * plane);
  EXPECT_GT(plane, 4 * space);
  // "It is essential to avoid considering every pair": of half a million some thousand overlap.
  EXPECT_LT(space, 5U * 1000);
  EXPECT_GT(space, 1U * 1000);
}

/// How many pairs of ends stand in another order along one of the axes.
std::size_t pairs_of_ends_that_changed(const std::vector<Aabb>& before, const std::vector<Aabb>& after) {
  std::size_t count = 0;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> was, is;
    for (std::size_t i = 0; i < before.size(); ++i) {
      was.insert(was.end(), {before[i].lower[axis], before[i].upper[axis]});
      is.insert(is.end(), {after[i].lower[axis], after[i].upper[axis]});
    }
    for (std::size_t i = 0; i < was.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) count += (was[i] < was[j]) != (is[i] < is[j]);
  }
  return count;
}

std::vector<Aabb> random_boxes(Random& random, std::size_t count) {
  std::vector<Aabb> boxes;
  while (boxes.size() < count) {
    const Vec3 lower{random.between(0, 20), random.between(0, 20), random.between(0, 20)};
    boxes.push_back({lower, lower + Vec3{1, 1, 1}});
  }
  return boxes;
}

TEST(LectureQuestion, SortingByInsertionTakesASwapForEveryTwoEndsThatChangeTheirOrder) {
  Random random(20261128);
  std::vector<Aabb> boxes = random_boxes(random, 200);
  std::vector<Index> all(boxes.size());
  for (Index i = 0; i < all.size(); ++i) all[i] = i;
  IncrementalSweep sweep;
  PairList pairs = sweep.find({boxes, all, {}, 1}, {});
  for (const double step : {1e-6, 1e-3, 1e-2}) {
    const std::vector<Aabb> before = boxes;
    for (Aabb& box : boxes) {
      const Vec3 by{random.between(-step, step), random.between(-step, step), random.between(-step, step)};
      box = {box.lower + by, box.upper + by};
    }
    pairs = sweep.find({boxes, all, pairs, 1}, {});
    EXPECT_FALSE(sweep.work().sorted_anew);
    EXPECT_EQ(sweep.work().swaps, pairs_of_ends_that_changed(before, boxes)) << step;
    EXPECT_EQ(pairs, overlapping_pairs_by_brute_force(boxes));
  }
  // Where all goes elsewhere the order has nothing of the one before: coherence has failed, and all is sorted anew.
  boxes = random_boxes(random, boxes.size());
  pairs = sweep.find({boxes, all, pairs, 1}, {});
  EXPECT_TRUE(sweep.work().sorted_anew);
  EXPECT_EQ(pairs, overlapping_pairs_by_brute_force(boxes));
}

/// The cells of side `side` that a box reaches into.
template <std::size_t D>
CellRange<D> cells_of(const GridBox<D>& box, double side) {
  std::array<double, D> origin{}, size{};
  size.fill(side);
  return *GridCells<D>(origin, size).range(box);
}

template <std::size_t D>
GridBox<D> random_box(Random& random, double greatest) {
  GridBox<D> box;
  for (std::size_t axis = 0; axis < D; ++axis) {
    // Quarters too, so that ends often lie in the planes between cells.
    box.lower[axis] = random.below(2) == 0 ? 0.25 * static_cast<double>(random.below(40)) : random.between(0, 10);
    box.upper[axis] = box.lower[axis] + (random.below(2) == 0 ? greatest : random.between(0, greatest));
  }
  return box;
}

template <std::size_t D>
void expect_two_cells_along_an_axis() {
  Random random(D);
  std::uint64_t most = 0;
  for (int i = 0; i < 2000; ++i) {
    const GridBox<D> box = random_box<D>(random, 0.25);
    for (const double side : {0.25, 1.0, 4.0, 16.0})  // its own level, and all coarser ones
      most = std::max(most, cell_count(cells_of(box, side)));
  }
  EXPECT_EQ(most, std::uint64_t{1} << D);
}

TEST(LectureQuestion, ABoxIsInFourCellsOfALevelInThePlaneAndInEightInSpace) {
  expect_two_cells_along_an_axis<2>();
  expect_two_cells_along_an_axis<3>();
}

/// The level of a box: cells of side 4^level are not smaller than it is.
template <std::size_t D>
int level_of(const GridBox<D>& box) {
  double size = 0;
  for (std::size_t axis = 0; axis < D; ++axis) size = std::max(size, box.upper[axis] - box.lower[axis]);
  int level = -4;
  while (std::ldexp(1.0, 2 * level) < size) ++level;
  return level;
}

/// The lecture's tables of many levels, in its own way: a box is entered under every cell that it reaches into at its
/// own level, where it is native, and at coarser ones.
struct LevelTables {
  enum class Entered { at_own_level_only, and_at_all_coarser };
  struct Cell {
    std::vector<Index> natives, visitors;
  };
  static constexpr int coarsest = 3;

  LevelTables(const std::vector<GridBox<3>>& boxes, Entered entered) {
    for (Index i = 0; i < boxes.size(); ++i) {
      const int own = level_of(boxes[i]), last = entered == Entered::at_own_level_only ? own : coarsest;
      std::size_t keys = 0;
      for (int level = own; level <= last; ++level)
        each_cell(cells_of(boxes[i], std::ldexp(1.0, 2 * level)), [&](const GridCell<3>& cell) {
          Cell& entry = table[{level, cell}];
          (level == own ? entry.natives : entry.visitors).push_back(i);
          ++keys;
        });
      EXPECT_LE(keys, 8U * static_cast<std::size_t>(last - own + 1));
    }
  }

  /// Natives with all, visitors not with each other.
  [[nodiscard]] std::set<IndexPair> candidates() const {
    std::set<IndexPair> pairs;
    for (const auto& [key, cell] : table)
      for (std::size_t i = 0; i < cell.natives.size(); ++i) {
        const auto add = [&](Index a, Index b) { pairs.insert({std::min(a, b), std::max(a, b)}); };
        for (std::size_t j = 0; j < i; ++j) add(cell.natives[i], cell.natives[j]);
        for (const Index visitor : cell.visitors) add(cell.natives[i], visitor);
      }
    return pairs;
  }

  std::map<std::pair<int, GridCell<3>>, Cell> table;
};

TEST(LectureQuestion, HierarchicalHashingLosesNoPairAsBothAreEnteredAtTheCoarserLevel) {
  Random random(61);
  std::vector<GridBox<3>> boxes;
  std::vector<Aabb> same;
  for (int i = 0; i < 300; ++i) {
    const GridBox<3> box = random_box<3>(random, std::ldexp(1.0, static_cast<int>(random.below(8)) - 5));
    boxes.push_back(box);
    same.push_back({{box.lower[0], box.lower[1], box.lower[2]}, {box.upper[0], box.upper[1], box.upper[2]}});
  }
  const std::vector<IndexPair> truth = overlapping_pairs_by_brute_force(same);
  const auto lost_by = [&](const std::set<IndexPair>& candidates) {
    return std::count_if(truth.begin(), truth.end(), [&](const IndexPair& pair) { return !candidates.contains(pair); });
  };
  EXPECT_GT(truth.size(), 200U);
  const auto found = LevelTables(boxes, LevelTables::Entered::and_at_all_coarser).candidates();
  EXPECT_EQ(lost_by(found), 0);
  EXPECT_LT(found.size(), boxes.size() * boxes.size() / 4);
  // A small box that is not entered where the large ones are native does not meet them.
  EXPECT_GT(lost_by(LevelTables(boxes, LevelTables::Entered::at_own_level_only).candidates()), 20);
}

TEST(LectureQuestion, TheHierarchicalHashEntersABoxIntoEightCellsOfItsLevelAtMost) {
  Random random(4);
  for (int i = 0; i < 500; ++i) {
    const Vec3 lower{random.between(-9, 9), random.between(-9, 9), random.between(-9, 9)};
    const double side = std::ldexp(random.between(0.5, 1), static_cast<int>(random.below(20)) - 10);
    BroadPhase phase({.method = BroadPhaseMethod::hierarchical_hash});
    phase.add(std::vector<Aabb>{{lower, lower + Vec3{side, side, side}}});
    phase.update();
    const BroadPhaseCells cells = phase.cells();
    EXPECT_LE(cells.cells.size(), 8U);
    ASSERT_GE(cells.cells.size(), 1U);
    const double cell = cells.cells[0].box.upper.x - cells.cells[0].box.lower.x;
    EXPECT_GE(cell, side * (1 - 1e-12));
    EXPECT_LE(cell, 4 * side * (1 + 1e-12));
  }
}

}  // namespace
}  // namespace toccata
