#include "toccata/broad/bound_pairs.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"

namespace toccata {
namespace {

using Pairs = std::vector<IndexPair>;

template <class Bound, class Overlap>
Pairs by_brute_force(const std::vector<Bound>& bounds, const Overlap& overlap) {
  Pairs pairs;
  for (Index i = 0; i < bounds.size(); ++i)
    for (Index j = i + 1; j < bounds.size(); ++j)
      if (overlap(bounds[i], bounds[j])) pairs.push_back({i, j});
  return pairs;
}

template <class Bound>
void expect_of_every_method(const std::vector<Bound>& bounds, const Pairs& expected) {
  for (const BroadPhaseMethod method : broad_phase_methods())
    EXPECT_EQ(overlapping_pairs(std::span<const Bound>(bounds), {method, 1}), expected) << name_of(method);
}

TEST(BoundPairs, OfIntervals) {
  Random random(1);
  std::vector<LineInterval> intervals;
  for (int i = 0; i < 200; ++i) {
    const double lower = static_cast<double>(random.below(300));
    intervals.push_back({lower, lower + static_cast<double>(random.below(6))});
  }
  expect_of_every_method(intervals, by_brute_force(intervals, [](const LineInterval& a, const LineInterval& b) {
                           return a.lower <= b.upper && b.lower <= a.upper;
                         }));
  intervals[7] = {2, 1};
  EXPECT_THROW(static_cast<void>(overlapping_pairs(std::span<const LineInterval>(intervals))), Error);
}

TEST(BoundPairs, OfRectanglesByCornerWidthAndHeight) {
  Random random(2);
  std::vector<Rectangle> rectangles;
  for (int i = 0; i < 200; ++i) {
    const auto step = [&](std::uint64_t count) { return 0.1 * static_cast<double>(random.below(count)); };
    const double x = step(150), y = step(150), width = step(12), height = step(12);
    rectangles.push_back({x, y, width, height});
  }
  // The far corner rounds to 1, but does not reach it.
  rectangles.push_back({-0x1p-55, 100, 1, 1});
  rectangles.push_back({1, 100, 1, 1});
  expect_of_every_method(
      rectangles, by_brute_force(rectangles, [](const Rectangle& a, const Rectangle& b) { return overlap(a, b); }));
  rectangles[3].width = -1;
  EXPECT_THROW(static_cast<void>(overlapping_pairs(std::span<const Rectangle>(rectangles))), Error);
}

TEST(BoundPairs, OfBalls) {
  Random random(3);
  std::vector<Ball> balls;
  for (int i = 0; i < 300; ++i)
    balls.push_back({{random.between(0, 9), random.between(0, 9), random.between(0, 9)}, random.between(-0.1, 0.8)});
  const Pairs expected = by_brute_force(balls, [](const Ball& a, const Ball& b) { return overlap(a, b); });
  EXPECT_GT(expected.size(), 50U);
  expect_of_every_method(balls, expected);
}

TEST(BoundPairs, OfOrientedBoxes) {
  Random random(4);
  std::vector<Obb> boxes;
  for (int i = 0; i < 300; ++i) {
    Obb box;
    box.centre = {random.between(0, 9), random.between(0, 9), random.between(0, 9)};
    const double angle = random.between(0, 6), c = std::cos(angle), s = std::sin(angle);
    box.axes[0] = {c, s, 0};
    box.axes[1] = {-s, c, 0};
    box.half = {random.between(0, 1), random.between(0, 0.2), random.between(0, 0.5)};
    boxes.push_back(box);
  }
  const Pairs expected = by_brute_force(boxes, [](const Obb& a, const Obb& b) { return overlap(a, b); });
  EXPECT_GT(expected.size(), 50U);
  expect_of_every_method(boxes, expected);
}

}  // namespace
}  // namespace toccata
