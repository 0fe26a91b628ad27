#include <string>

#include <fmt/format.h>

#include "partitions/partition_families.hpp"
#include "partitions/r_tree_life.hpp"
#include "support/sweep.hpp"
#include "toccata/partitions/kd_tree.hpp"
#include "toccata/partitions/octree.hpp"
#include "toccata/partitions/uniform_grid.hpp"

namespace toccata::test {
namespace {

std::string complaint_about_all(const PartitionItems& items, Random& random) {
  std::string wrong = complaint_about_partition(UniformGrid<2>(items), items, random);
  if (wrong.empty()) wrong = complaint_about_partition(UniformGrid<3>(items), items, random);
  if (wrong.empty()) wrong = complaint_about_partition(Octree(items), items, random);
  if (wrong.empty()) wrong = complaint_about_partition(KdTree(items), items, random);
  return wrong.empty() ? complaint_about_partition(RTree(items), items, random) : wrong;
}

std::string wrong_with_partitions(const std::string& family, std::uint64_t seed) {
  Random random(seed);
  const std::size_t count = 1 + random.below(150);
  std::string wrong = complaint_about_all(PartitionItems(random_finite_boxes(family, count, random)), random);
  if (wrong.empty()) wrong = complaint_about_all(PartitionItems(random_triangles(family, count / 2, random)), random);
  if (wrong.empty()) wrong = complaint_about_r_tree_life(family, seed, 200);
  return wrong.empty() ? wrong : fmt::format("{} with seed {}: {}", family, seed, wrong);
}

SweepResult run_partitions(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  SweepResult result;
  for (; result.cases < cases; ++result.cases) {
    const std::string wrong = wrong_with_partitions(family, 1'000'003 * seed + result.cases);
    if (wrong.empty()) continue;
    if (result.wrong++ == 0) result.first_failure = wrong;
  }
  return result;
}

const bool partitions_known = register_sweep(
    {"partitions", {partition_families.begin(), partition_families.end()}, 3000, 1, run_partitions, 250, 1});

}  // namespace
}  // namespace toccata::test
