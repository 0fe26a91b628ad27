#include "broad/box_sample.hpp"

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "toccata/core/random.hpp"

namespace toccata {
namespace {

std::vector<Aabb> shuffled(std::vector<Aabb> boxes) {
  Random random(1);
  for (std::size_t i = boxes.size(); i > 1; --i) std::swap(boxes[i - 1], boxes[random.below(i)]);
  return boxes;
}

/// Heaps of a hundred boxes far apart, heap by heap.
std::vector<Aabb> heaps_of_boxes(int heaps) {
  Random random(2);
  const auto place = [&](double reach) {
    return Vec3{random.between(0, reach), random.between(0, reach), random.between(0, reach)};
  };
  std::vector<Aabb> boxes;
  for (int heap = 0; heap < heaps; ++heap) {
    const Vec3 at = place(1000);
    for (int i = 0; i < 100; ++i) {
      const Vec3 lower = at + place(4);
      boxes.push_back({lower, lower + Vec3{1, 1, 1}});
    }
  }
  return boxes;
}

/// Each in another heap than the one before.
std::vector<Aabb> by_turns(const std::vector<Aabb>& boxes) {
  std::vector<Aabb> turned;
  for (std::size_t in_heap = 0; in_heap < 100; ++in_heap)
    for (std::size_t i = in_heap; i < boxes.size(); i += 100) turned.push_back(boxes[i]);
  return turned;
}

BoxDensity density_of(const std::vector<Aabb>& boxes) { return {BoxSample(boxes), boxes}; }

/// Where heaps are filled by turns, of every so many boxes each may lie in another heap. Then none seems to be near
/// another, and a grid is chosen that compares all boxes of a heap: two million boxes took ten times as long.
TEST(BoxDensity, DoesNotDependOnHowBoxesAreNumbered) {
  for (const int heaps : {200, 300, 1000}) {
    SCOPED_TRACE(heaps);
    const std::vector<Aabb> heap_by_heap = heaps_of_boxes(heaps);
    const BoxDensity meant = density_of(shuffled(heap_by_heap));
    for (const std::vector<Aabb>& boxes : {heap_by_heap, by_turns(heap_by_heap)}) {
      const BoxDensity density = density_of(boxes);
      EXPECT_GT(density.near, 0.5 * meant.near);
      EXPECT_LT(density.near, 2 * meant.near);
      EXPECT_GT(density.swept, 0.5 * meant.swept);
      EXPECT_LT(density.swept, 2 * meant.swept);
      EXPECT_TRUE(density.heaped);
    }
  }
}

TEST(BoxSample, SeesAllKindsOfBoxesThatTakeTurns) {
  std::vector<Aabb> boxes;
  for (int i = 0; i < 16'384; ++i) {
    const double size = i % 16 == 0 ? 100 : 1, at = 2 * i;
    boxes.push_back({{at, 0, 0}, {at + size, size, size}});
  }
  const BoxSample sample(boxes);
  EXPECT_EQ(sample.sizes(0).median, 0.25);
  EXPECT_EQ(sample.sizes(0).most, 25);
}

TEST(VisitSample, VisitsNumbersInOrderTheSameEachTime) {
  for (const std::size_t count : {0U, 1U, 63U, 64U, 127U, 128U, 1000U, 99'999U}) {
    std::vector<std::size_t> once, again;
    visit_sample(count, 64, [&](std::size_t i) { once.push_back(i); });
    visit_sample(count, 64, [&](std::size_t i) { again.push_back(i); });
    EXPECT_EQ(once, again);
    EXPECT_TRUE(std::adjacent_find(once.begin(), once.end(), std::greater_equal<>()) == once.end());
    EXPECT_GE(once.size(), std::min<std::size_t>(count, 64));
    EXPECT_LE(once.size(), 128U);
    EXPECT_TRUE(once.empty() || once.back() < count);
  }
}

}  // namespace
}  // namespace toccata
