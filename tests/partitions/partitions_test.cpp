#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "partitions/partition_families.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/partitions/kd_tree.hpp"
#include "toccata/partitions/measure.hpp"
#include "toccata/partitions/octree.hpp"
#include "toccata/partitions/r_tree.hpp"
#include "toccata/partitions/uniform_grid.hpp"

namespace toccata {
namespace {

template <class P>
class EveryPartition : public testing::Test {};
using Partitions = testing::Types<UniformGrid<2>, UniformGrid<3>, Octree, KdTree, RTree>;
TYPED_TEST_SUITE(EveryPartition, Partitions);

template <class P>
std::string complaint(const PartitionItems& items, Random& random) {
  return test::complaint_about_partition(P(items), items, random);
}

TYPED_TEST(EveryPartition, AnswersAsBruteForceForBoxes) {
  for (const std::string_view family : test::partition_families) {
    Random random(family.size());
    const PartitionItems items(test::random_finite_boxes(family, 200, random));
    EXPECT_EQ(complaint<TypeParam>(items, random), "") << family;
  }
}

TYPED_TEST(EveryPartition, AnswersAsBruteForceForTriangles) {
  for (const std::string_view family : test::partition_families) {
    Random random(family.size());
    const PartitionItems items(test::random_triangles(family, 100, random));
    EXPECT_EQ(complaint<TypeParam>(items, random), "") << family;
  }
}

TYPED_TEST(EveryPartition, HoldsNoneAndOneAndTheGreatestDoubles) {
  constexpr double most = std::numeric_limits<double>::max();
  Random random(1);
  EXPECT_EQ(complaint<TypeParam>(PartitionItems(std::vector<Aabb>{}), random), "");
  EXPECT_EQ(complaint<TypeParam>(PartitionItems(std::vector<Aabb>{{{1, 2, 3}, {1, 2, 3}}}), random), "");
  std::vector<Aabb> boxes{{{-most, -most, -most}, {most, most, most}}};
  for (const double size : {1e-300, 1.0, 1e300, most})
    for (const double at : {-most, 0.0, most})
      boxes.push_back({{std::min(at, at - size), 0, -size}, {std::max(at, at), size, 0}});
  for (Aabb& box : boxes) box.lower.x = std::max(box.lower.x, -most);
  EXPECT_EQ(complaint<TypeParam>(PartitionItems(boxes), random), "");
}

TYPED_TEST(EveryPartition, HoldsAMeshAndItsMemoryIsBounded) {
  const PartitionItems sphere(generate_mesh("icosphere", {{"subdivisions", 2}}));
  Random random(4);
  EXPECT_EQ(complaint<TypeParam>(sphere, random), "");
  EXPECT_LT(TypeParam(sphere).bytes(), 1'000 * sphere.size());
  const PartitionItems heap(std::vector<Aabb>(3'000, Aabb{{0, 0, 0}, {1, 1, 1}}));
  EXPECT_LT(TypeParam(heap).bytes(), 1'000 * heap.size());
  std::vector<Aabb> rods;  // across everything, each along another axis
  for (int i = 0; i < 999; ++i) {
    Aabb rod{{0.001 * i, 0.001 * i, 0.001 * i}, {0.001 * i, 0.001 * i, 0.001 * i}};
    rod.lower[i % 3] = 0;
    rod.upper[i % 3] = 1;
    rods.push_back(rod);
  }
  EXPECT_LT(TypeParam(PartitionItems(rods)).bytes(), 2'000 * rods.size());
}

TEST(Octree, PartsWhatCanBePartedAndLeavesTheRestWhole) {
  Random random(9);
  const PartitionItems items(test::random_finite_boxes("giant", 500, random));
  const Octree tree(items);
  EXPECT_GE(tree.greatest_depth(), 2U);
  EXPECT_EQ(Octree(PartitionItems(std::vector<Aabb>(100, Aabb{{0, 0, 0}, {1, 1, 1}}))).greatest_depth(), 0U);
  EXPECT_EQ(Octree(items, {8, 0, 8}).cells().size(), 1U);
}

/// The items of all cells, each once.
std::vector<Index> items_of(const std::vector<PartitionCell>& cells) {
  std::vector<Index> items;
  for (const PartitionCell& cell : cells) items.insert(items.end(), cell.items.begin(), cell.items.end());
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
  return items;
}

bool are_same(const std::vector<PartitionCell>& a, const std::vector<PartitionCell>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const PartitionCell& one, const PartitionCell& other) {
    return one.box == other.box && one.items == other.items;
  });
}

TEST(PartitionLevels, HoldAllItemsAtEveryDepth) {
  const PartitionItems items(generate_mesh("icosphere", {{"subdivisions", 3}}));
  for (const PartitionKind kind : all_partition_kinds) {
    const std::vector<PartitionLevel> levels = partition_levels(kind, items);
    ASSERT_FALSE(levels.empty());
    const bool is_grid = kind == PartitionKind::grid || kind == PartitionKind::grid_2d;
    EXPECT_EQ(levels.size() == 1, is_grid) << name_of(kind);
    std::size_t before = 0;
    for (const PartitionLevel& level : levels) {
      EXPECT_EQ(items_of(level.cells).size(), items.size()) << name_of(kind) << " at " << level.depth;
      EXPECT_GE(level.cells.size(), before) << name_of(kind) << " at " << level.depth;
      before = level.cells.size();
      for (const PartitionCell& cell : level.cells)
        for (const Index item : cell.items) ASSERT_TRUE(overlap(cell.box, items.boxes()[item])) << name_of(kind);
    }
    EXPECT_EQ(partition_levels(kind, items, 1).size(), is_grid ? 1U : 2U) << name_of(kind);
  }
}

TEST(PartitionLevels, AreTreesThatWereCutNoDeeper) {
  const PartitionItems items(generate_mesh("torus-knot"));
  const Octree octree(items);
  const KdTree kd_tree(items);
  ASSERT_GT(octree.greatest_depth(), 2U);
  for (Index depth = 0; depth <= octree.greatest_depth() + 1; ++depth)
    EXPECT_TRUE(are_same(octree.cells_at(depth), Octree(items, {.most_depth = depth}).cells())) << depth;
  for (const Index depth : {0U, 3U, 6U})
    EXPECT_TRUE(are_same(kd_tree.cells_at(depth), KdTree(items, {.most_depth = depth}).cells())) << depth;
  EXPECT_TRUE(RTree().cells_at(0).empty());
  EXPECT_EQ(RTree().greatest_depth(), 0U);
}

}  // namespace
}  // namespace toccata
