// What is drawn of a method is what it used: boxes lie in the cells that they were put into.
#include "toccata/broad/broad_phase.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "toccata/core/error.hpp"
#include "toccata/generate/crowds.hpp"

namespace toccata {
namespace {

using Method = BroadPhaseMethod;

struct Divided {
  std::vector<Aabb> boxes;
  BroadPhaseCells space;
};

Divided divided(Method method, std::string_view scene, std::size_t count, int frames = 1) {
  Crowd crowd(scene, count);
  BroadPhase phase({method, 1});
  phase.add(crowd.boxes());
  phase.update();
  for (int frame = 1; frame < frames; ++frame) {
    const std::span<const Index> moved = crowd.step();
    std::vector<Aabb> to;
    for (const Index number : moved) to.push_back(crowd.boxes()[number]);
    phase.move(moved, to);
    phase.update();
  }
  return {crowd.boxes(), phase.cells()};
}

std::vector<Aabb> of_group(const BroadPhaseCells& space, Index group) {
  std::vector<Aabb> boxes;
  for (const BroadPhaseCell& cell : space.cells)
    if (cell.group == group) boxes.push_back(cell.box);
  return boxes;
}

bool holds(const Aabb& cell, const Vec3& point, double slack) {
  const Vec3 room{slack, slack, slack};
  return contains({cell.lower - room, cell.upper + room}, {point, point});
}

std::size_t holding(const std::vector<Aabb>& cells, const Vec3& point, double slack) {
  return static_cast<std::size_t>(
      std::count_if(cells.begin(), cells.end(), [&](const Aabb& cell) { return holds(cell, point, slack); }));
}

Aabb common(const Aabb& a, const Aabb& b) {
  return {{std::max(a.lower.x, b.lower.x), std::max(a.lower.y, b.lower.y), std::max(a.lower.z, b.lower.z)},
          {std::min(a.upper.x, b.upper.x), std::min(a.upper.y, b.upper.y), std::min(a.upper.z, b.upper.z)}};
}

double volume(const Aabb& box) {
  const Vec3 size = box.upper - box.lower;
  return size.x > 0 && size.y > 0 && size.z > 0 ? size.x * size.y * size.z : 0;
}

double longest(const Aabb& box) {
  const Vec3 size = box.upper - box.lower;
  return std::max({size.x, size.y, size.z});
}

TEST(BroadPhaseCells, OfTheGridHoldTheLowerCorners) {
  const Divided grid = divided(Method::uniform_grid, "uniform", 2000);
  const std::vector<Aabb> cells = of_group(grid.space, 0);
  ASSERT_GT(cells.size(), 200U);
  ASSERT_LE(cells.size(), 2000U);
  std::size_t held = 0;
  for (const Aabb& box : grid.boxes) {
    const std::size_t in = holding(cells, box.lower, 1e-9);
    EXPECT_LE(in, 1U);
    held += in;
  }
  EXPECT_GT(held, 1900U);  // the rest is larger than cells
  for (const Aabb& cell : cells)
    EXPECT_TRUE(std::any_of(grid.boxes.begin(), grid.boxes.end(),
                            [&](const Aabb& box) { return holds(cell, box.lower, 1e-9); }));
}

TEST(BroadPhaseCells, AreTilesThatShareNoSpaceAndHoldEveryLowerCorner) {
  for (const char* scene : {"uniform", "clustered", "sizes"}) {
    const Divided tiles = divided(Method::kd_tiles, scene, 5000);
    const std::vector<Aabb> cells = of_group(tiles.space, 0);
    ASSERT_GT(cells.size(), 10U) << scene;
    for (std::size_t i = 0; i < cells.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) EXPECT_EQ(volume(common(cells[i], cells[j])), 0) << scene;
    for (const Aabb& box : tiles.boxes) EXPECT_GE(holding(cells, box.lower, 1e-4), 1U) << scene;
  }
}

TEST(BroadPhaseCells, OfHashesFillTheBoxesThatAreNative) {
  for (const Method method : {Method::spatial_hash, Method::hierarchical_hash}) {
    // Among boxes of many sizes, most would be too large for the cells of one size.
    const Divided hash = divided(method, method == Method::spatial_hash ? "uniform" : "sizes", 600);
    EXPECT_EQ(hash.space.groups.size() > 2, method == Method::hierarchical_hash);
    for (const Aabb& box : hash.boxes) {
      double most = 0;
      for (Index group = 0; group < hash.space.groups.size(); ++group) {
        double filled = 0;
        for (const Aabb& cell : of_group(hash.space, group)) {
          if (method == Method::hierarchical_hash) {
            EXPECT_EQ(std::exp2(std::round(std::log2(longest(cell)))), longest(cell));
          }
          filled += volume(common(cell, box));
        }
        most = std::max(most, filled);
      }
      EXPECT_NEAR(most / volume(box), 1, 1e-6);
    }
  }
}

TEST(BroadPhaseCells, OfALooseOctreeHoldTheMiddlesOfBoxesOfTheirSize) {
  const Divided octree = divided(Method::loose_octree, "sizes", 1000);
  EXPECT_GT(octree.space.groups.size(), 3U);
  std::map<double, std::vector<Aabb>> of_side;
  for (const BroadPhaseCell& cell : octree.space.cells) of_side[longest(cell.box)].push_back(cell.box);
  for (const Aabb& box : octree.boxes) {
    const double side = std::exp2(std::floor(std::log2(longest(box))) + 1);
    const bool is_least = of_side.begin()->first >= side;
    const std::vector<Aabb>& cells = is_least ? of_side.begin()->second : of_side[side];
    EXPECT_GE(holding(cells, 0.5 * (box.lower + box.upper), 1e-9), 1U) << side;
  }
}

/// Every box is in a cell of each level, and the cells of a level are in those above.
void expect_levels(const BroadPhaseCells& space, const std::vector<Aabb>& boxes, const std::string& tree) {
  std::vector<Aabb> above;
  std::size_t levels = 0;
  for (Index group = 0; group < space.groups.size(); ++group) {
    if (!space.groups[group].name.starts_with("tree, level")) continue;
    ++levels;
    const std::vector<Aabb> cells = of_group(space, group);
    for (const Aabb& cell : cells)
      EXPECT_TRUE(above.empty() ||
                  std::any_of(above.begin(), above.end(), [&](const Aabb& one) { return contains(one, cell); }))
          << tree;
    above = cells;
  }
  EXPECT_GT(levels, 1U) << tree;
  const std::vector<Aabb> root = of_group(space, 0);
  for (const Aabb& box : boxes)
    EXPECT_TRUE(holding(root, box.lower, 1e-3) > 0 && holding(root, box.upper, 1e-3) > 0) << tree;
}

TEST(BroadPhaseCells, OfTreesLieInThoseAbove) {
  for (const Method method : {Method::morton_tree, Method::packed_r_tree, Method::dynamic_tree}) {
    const Divided tree = divided(method, "uniform", 1500);
    expect_levels(tree.space, tree.boxes, std::string(name_of(method)));
  }
  const Divided dynamic = divided(Method::dynamic_tree, "static", 500, 4);
  ASSERT_EQ(dynamic.space.groups.back().name, "enlarged boxes");
  const std::vector<Aabb> enlarged = of_group(dynamic.space, static_cast<Index>(dynamic.space.groups.size() - 1));
  EXPECT_EQ(enlarged.size(), dynamic.boxes.size());
  for (const Aabb& box : dynamic.boxes)
    EXPECT_TRUE(std::any_of(enlarged.begin(), enlarged.end(), [&](const Aabb& one) { return contains(one, box); }));
}

TEST(BroadPhaseCells, OfLayersAreATreeOfWhatRestsAndIntervalsOfWhatMoves) {
  const Divided layers = divided(Method::layers, "static", 2000, 3);
  ASSERT_EQ(layers.space.groups.back().dimensions, 1);
  const auto movers = of_group(layers.space, static_cast<Index>(layers.space.groups.size() - 1));
  EXPECT_GT(movers.size(), 50U);
  EXPECT_LT(movers.size(), 300U);
  expect_levels(layers.space, {}, "layers");
}

TEST(BroadPhaseCells, OfSweepsAreTheShadowsOfTheBoxes) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::map<Method, std::pair<std::size_t, int>> expected{{Method::sort_and_sweep, {1, 1}},
                                                               {Method::incremental_sweep, {3, 1}},
                                                               {Method::interval_sweeps, {3, 1}},
                                                               {Method::rectangle_sweeps, {2, 2}}};
  for (const auto& [method, groups] : expected) {
    const Divided sweep = divided(method, "uniform", 300, 3);
    ASSERT_EQ(sweep.space.groups.size(), groups.first) << name_of(method);
    EXPECT_EQ(sweep.space.cells.size(), 300 * groups.first);
    EXPECT_EQ(sweep.space.groups[0].dimensions, groups.second);
  }
  const Divided planes = divided(Method::rectangle_sweeps, "uniform", 300);
  const Aabb& box = planes.boxes[7];
  EXPECT_EQ(planes.space.cells[7].box,
            (Aabb{{box.lower.x, box.lower.y, -infinity}, {box.upper.x, box.upper.y, infinity}}));
}

TEST(BroadPhaseCells, OfTheLargestBoxesAreBoxes) {
  BroadPhase phase({.method = BroadPhaseMethod::hierarchical_hash});
  phase.add(std::vector<Aabb>{{{-0x1p1022, 0, 0}, {0x1p1022, 1, 1}}, {{0, 0, 0}, {1, 1, 1}}});
  phase.update();
  for (const BroadPhaseCell& cell : phase.cells().cells) EXPECT_LE(cell.box.lower.x, cell.box.upper.x);
}

TEST(BroadPhaseCells, OfNothingAreNone) {
  for (const Method method : broad_phase_methods()) {
    BroadPhase phase({method, 1});
    EXPECT_TRUE(phase.cells().cells.empty()) << name_of(method);
    const std::vector<Index> numbers = phase.add(std::vector<Aabb>{{{0, 0, 0}, {1, 1, 1}}, {{0, 0, 0}, {2, 1, 1}}});
    EXPECT_THROW((void)phase.cells(), Error);
    phase.update();
    (void)phase.cells();
    EXPECT_TRUE(BroadPhase(phase).cells().cells.empty()) << name_of(method);
    phase.remove(numbers);
    EXPECT_THROW((void)phase.cells(), Error);
    phase.update();
    (void)phase.cells();
  }
  EXPECT_TRUE(divided(Method::brute_force, "uniform", 50).space.groups.empty());
}

TEST(BroadPhaseCells, OfAutoAreThoseOfTheMethodThatItChose) {
  const Divided chosen = divided(Method::automatic, "sizes", 5000);
  EXPECT_GT(chosen.space.cells.size(), 5U);
}

}  // namespace
}  // namespace toccata
