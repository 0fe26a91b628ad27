#include "toccata/broad/broad_phase.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "toccata/core/random.hpp"

namespace toccata {
namespace {

Aabb box_at(double x, double y, double z, double size) { return {{x, y, z}, {x + size, y + size, z + size}}; }

void expect_as_brute_force(const std::vector<Aabb>& boxes) {
  EXPECT_EQ(overlapping_pairs(boxes), overlapping_pairs_by_brute_force(boxes));
}

TEST(BoxPairs, NoneAmongNoneAndOne) {
  EXPECT_TRUE(overlapping_pairs(std::vector<Aabb>{}).empty());
  EXPECT_TRUE(overlapping_pairs(std::vector<Aabb>{box_at(0, 0, 0, 1)}).empty());
}

TEST(BoxPairs, TouchingFacesEdgesAndCornersCount) {
  const std::vector<Aabb> boxes{box_at(1, 1, 1, 1), box_at(0, 0, 0, 1), box_at(2, 1, 0, 1), box_at(2.5, 5, 5, 1)};
  EXPECT_EQ(overlapping_pairs(boxes), (std::vector<IndexPair>{{0, 1}, {0, 2}}));
}

TEST(BoxPairs, NestedBoxesOverlap) {
  const std::vector<Aabb> boxes{box_at(1, 1, 1, 1), box_at(0, 0, 0, 3)};
  EXPECT_EQ(overlapping_pairs(boxes), (std::vector<IndexPair>{{0, 1}}));
}

TEST(BoxPairs, EmptyBoxesOverlapNothing) {
  const std::vector<Aabb> boxes{Aabb{}, box_at(0, 0, 0, 1), Aabb{}, box_at(0.5, 0, 0, 1)};
  EXPECT_EQ(overlapping_pairs(boxes), (std::vector<IndexPair>{{1, 3}}));
}

TEST(BoxPairs, FlatBoxesAndPoints) {
  const std::vector<Aabb> boxes{
      box_at(0, 0, 0, 0), {{-1, 0, -1}, {1, 0, 1}}, {{0, -1, 0}, {0, 1, 0}}, box_at(2, 0, 0, 0)};
  EXPECT_EQ(overlapping_pairs(boxes), (std::vector<IndexPair>{{0, 1}, {0, 2}, {1, 2}}));
}

TEST(BoxPairs, ZerosOfBothSignsAreEqual) {
  const std::vector<Aabb> boxes{{{-1, -1, -1}, {-0.0, 1, 1}}, {{0.0, -1, -1}, {1, 1, 1}}};
  EXPECT_EQ(overlapping_pairs(boxes).size(), 1U);
}

TEST(BoxPairs, AllEqual) {
  const std::vector<Aabb> boxes(40, box_at(1, 2, 3, 4));
  EXPECT_EQ(overlapping_pairs(boxes).size(), 40U * 39U / 2U);
  expect_as_brute_force(boxes);
}

TEST(BoxPairs, HugeCoordinatesWhoseSpreadOverflows) {
  std::vector<Aabb> boxes;
  for (int i = 0; i < 20; ++i) boxes.push_back(box_at(i % 2 == 0 ? 1e308 : -1e308, i % 3, i % 5, 1));
  expect_as_brute_force(boxes);
}

/// Coordinates from a coarse grid, so that many are equal; one box in `giants` spans everything.
std::vector<Aabb> grid_boxes(Random& random, std::size_t count, std::uint64_t cells, std::size_t giants) {
  std::vector<Aabb> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const auto coordinate = [&] { return static_cast<double>(random.below(cells)); };
    const Vec3 lower{coordinate(), coordinate(), coordinate()};
    const Vec3 size{static_cast<double>(random.below(3)), static_cast<double>(random.below(3)),
                    static_cast<double>(random.below(3))};
    boxes.push_back(i < giants ? Aabb{{-9, -9, -9}, {99, 99, 99}} : Aabb{lower, lower + size});
  }
  return boxes;
}

TEST(BoxPairs, AsBruteForceOnRandomBoxes) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const std::size_t count = random.below(120);
    expect_as_brute_force(grid_boxes(random, count, 1 + random.below(40), seed % 3));
  }
}

TEST(BoxPairs, OrderOfTheBoxesDoesNotMatter) {
  Random random(7);
  std::vector<Aabb> boxes = grid_boxes(random, 60, 9, 1);
  const std::size_t count = overlapping_pairs(boxes).size();
  std::reverse(boxes.begin(), boxes.end());
  EXPECT_EQ(overlapping_pairs(boxes).size(), count);
}

}  // namespace
}  // namespace toccata
