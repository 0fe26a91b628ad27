#include <limits>

#include <gtest/gtest.h>

#include "partitions/partition_families.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/partitions/uniform_grid.hpp"

namespace toccata {
namespace {

template <class P>
class EveryPartition : public testing::Test {};
using Partitions = testing::Types<UniformGrid<2>, UniformGrid<3>>;
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

}  // namespace
}  // namespace toccata
