#include "toccata/partitions/measure.hpp"

#include <gtest/gtest.h>

#include "toccata/generate/meshes.hpp"

namespace toccata {
namespace {

const PartitionCost& cost_of(const std::vector<PartitionCost>& costs, PartitionKind kind) {
  return costs.at(static_cast<std::size_t>(kind));
}

TEST(PartitionCosts, CountBothRedundancies) {
  const std::vector<PartitionCost> costs =
      measure_partitions(PartitionItems(generate_mesh("icosphere", {{"subdivisions", 3}})), {50, 1, {}});
  ASSERT_EQ(costs.size(), all_partition_kinds.size());
  for (const PartitionCost& cost : costs) {
    SCOPED_TRACE(name_of(cost.kind));
    EXPECT_EQ(cost.pairs, costs.front().pairs);
    EXPECT_EQ(cost.answers, costs.front().answers);
    EXPECT_GE(cost.candidate_pairs, cost.pairs);
    EXPECT_GE(cost.candidates, cost.answers);
    EXPECT_GT(cost.bytes, 0U);
    if (is_object_centric(cost.kind)) {
      EXPECT_EQ(cost.copies_per_item, 1);
      EXPECT_GT(cost.cells_at_an_item, 1);
    } else {
      EXPECT_GT(cost.copies_per_item, 1);
      EXPECT_NEAR(cost.cells_at_an_item, 1, 0.01);
    }
  }
  EXPECT_GT(cost_of(costs, PartitionKind::inserted_r_tree).cells, cost_of(costs, PartitionKind::r_tree).cells);
}

TEST(PartitionCosts, AreZeroForNothing) {
  for (const PartitionCost& cost : measure_partitions(PartitionItems(std::vector<Aabb>{})))
    EXPECT_EQ(cost.cells + cost.pairs, 0U);
}

TEST(PartitionCosts, CountByHand) {
  // Two boxes a cell apart, and one over both.
  const PartitionItems items(std::vector<Aabb>{{{0, 0, 0}, {1, 1, 1}}, {{4, 0, 0}, {5, 1, 1}}, {{0, 0, 0}, {5, 1, 1}}});
  const std::vector<PartitionCost> costs = measure_partitions(items, {10, 1, {}});
  const PartitionCost& grid = cost_of(costs, PartitionKind::grid);  // of cells twice as wide as the middle box
  EXPECT_EQ(grid.cells, 3U);
  EXPECT_DOUBLE_EQ(grid.copies_per_item, 5.0 / 3);
  EXPECT_EQ(grid.pairs, 2U);
  EXPECT_EQ(cost_of(costs, PartitionKind::r_tree).cells, 1U);
}

}  // namespace
}  // namespace toccata
