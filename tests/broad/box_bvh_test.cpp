#include "toccata/broad/box_bvh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "bounds/box_bounds.hpp"
#include "broad/box_families.hpp"
#include "math/constants.hpp"
#include "oracle/rational.hpp"
#include "toccata/core/random.hpp"

namespace toccata::test {
namespace {

using oracle::exact;
using oracle::Rational;

bool has_ends(const Aabb& box) { return is_finite(box.lower) && is_finite(box.upper); }

/// How far they are apart along an axis, exactly; negative or 0 where they overlap.
Rational parted(const Aabb& a, const Aabb& b, int axis) {
  const Rational ahead = exact(b.lower[axis]) - exact(a.upper[axis]);
  const Rational behind = exact(a.lower[axis]) - exact(b.upper[axis]);
  return ahead > behind ? ahead : behind;
}

Rational squared_distance(const Aabb& a, const Aabb& b) {
  Rational sum = 0;
  for (int axis = 0; axis < 3; ++axis)
    if (const Rational gap = parted(a, b, axis); gap > 0) sum += gap * gap;
  return sum;
}

/// When a, moving, first meets b; none where it does not on its way.
std::optional<Rational> entry(const Aabb& a, const Vec3& motion, const Aabb& b) {
  Rational first = 0, last = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const Rational ahead = exact(b.lower[axis]) - exact(a.upper[axis]);
    const Rational behind = exact(b.upper[axis]) - exact(a.lower[axis]);
    const Rational speed = exact(motion[axis]);
    if (speed == 0 && (ahead > 0 || behind < 0)) return {};
    if (speed == 0) continue;
    const Rational in = (speed > 0 ? ahead : behind) / speed, out = (speed > 0 ? behind : ahead) / speed;
    if (in > first) first = in;
    if (out < last) last = out;
  }
  if (first > last) return {};
  return first;
}

/// About as long as the family is wide, sometimes along an axis or not at all.
Vec3 motion_in(std::string_view family, Random& random) {
  const Aabb from = test::random_box(family, 0, random), to = test::random_box(family, 0, random);
  Vec3 motion = 0.5 * to.lower - 0.5 * from.lower;
  for (int axis = 0; axis < 3; ++axis)
    if (random.below(3) == 0 || !std::isfinite(motion[axis])) motion[axis] = 0;
  return motion;
}

TEST(BoxBounds, GapIsNeverMoreThanTheDistanceAndNotMuchLess) {
  for (const std::string_view family : test::box_families) {
    Random random(3);
    for (std::size_t i = 0; i < 300; ++i) {
      const Aabb a = test::random_box(family, i, random), b = test::random_box(family, i + 1, random);
      const double gap = box_gap(a, b);
      EXPECT_EQ(gap, box_gap(b, a));
      EXPECT_TRUE(gap == 0 || !overlap(a, b)) << family;
      if (!has_ends(a) || !has_ends(b)) continue;
      const Rational squared = squared_distance(a, b), found = exact(gap),
                     more = found * exact(1 + 0x1p-44) + exact(0x1p-1059);
      EXPECT_LE(found * found, squared) << family;
      EXPECT_TRUE(gap > 1e308 || more * more >= squared) << family;
    }
  }
}

TEST(BoxBounds, EntryIsNeverLateAndNotMuchTooEarly) {
  for (const std::string_view family : test::box_families) {
    Random random(4);
    for (std::size_t i = 0; i < 300; ++i) {
      const Aabb a = test::random_box(family, i, random), b = test::random_box(family, i + 1, random);
      if (!has_ends(a) || !has_ends(b)) continue;
      const Vec3 motion = motion_in(family, random);
      const std::optional<Rational> truth = entry(a, motion, b);
      const double found = box_entry(a, motion, b);
      if (!truth) continue;  // it may be met in passing by a hair
      ASSERT_LE(found, 1) << family;
      EXPECT_LE(exact(found), *truth) << family;
      EXPECT_GE(exact(found) + exact(0x1p-49), *truth) << family;
    }
  }
}

TEST(BoxBounds, WhatIsPassedByIsNotMet) {
  const Aabb box{{2, 0, 0}, {3, 1, 1}};
  EXPECT_EQ(box_entry({{0, 0, 0}, {1, 1, 1}}, {1 - 1e-9, 0, 0}, box), infinity);
  EXPECT_EQ(box_entry({{0, 2, 0}, {1, 3, 1}}, {5, 0, 0}, box), infinity);
  EXPECT_EQ(box_entry({{0, 2, 0}, {1, 3, 1}}, {5, -0.9, 0}, box), infinity);
  EXPECT_EQ(box_entry({{0, 0, 0}, {0, 0, 0}}, {5, 0, 0}, Aabb{}), infinity);
  EXPECT_EQ(box_gap(box, Aabb{}), infinity);
  const Aabb everything{{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}};
  EXPECT_EQ(box_entry(everything, {5, 0, 0}, Aabb{}), infinity);
  EXPECT_EQ(box_gap(everything, Aabb{}), infinity);
  EXPECT_EQ(box_entry(everything, {5, 0, 0}, everything), 0);
}

/// Some boxes, a few of them empty.
std::vector<Aabb> boxes_of(std::string_view family, std::size_t count, Random& random) {
  std::vector<Aabb> boxes = test::random_boxes(family, count, random);
  for (std::size_t i = 0; i < count; ++i)
    if (random.below(9) == 0) boxes[i] = {};
  return boxes;
}

/// What is seen of boxes in the order of `bound`, with limits that shrink as if the item were a little farther; by
/// going through all.
template <class Bound>
std::vector<Index> seen_by_brute_force(const std::vector<Aabb>& boxes, double limit, const Bound& bound) {
  std::vector<Index> order, seen;
  for (Index i = 0; i < boxes.size(); ++i)
    if (bound(boxes[i]) < infinity) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](Index i, Index j) { return bound(boxes[i]) < bound(boxes[j]); });
  for (const Index i : order) {
    if (bound(boxes[i]) > limit) break;
    seen.push_back(i);
    limit = std::min(limit, bound(boxes[i]) * (1 + i % 5) + static_cast<double>(i % 3) * 0.125);
  }
  std::sort(seen.begin(), seen.end());
  return seen;
}

/// The same by the tree; boxes come in the order of `bound`.
template <class Visit, class Bound>
std::vector<Index> seen_by(const Visit& visit, const BoxBvh& tree, const Bound& bound) {
  std::vector<Index> seen;
  double last = 0;
  visit([&](Index i) {
    const double here = bound(tree.box(i));
    EXPECT_GE(here, last);
    last = here;
    seen.push_back(i);
    return here * (1 + i % 5) + static_cast<double>(i % 3) * 0.125;
  });
  std::sort(seen.begin(), seen.end());
  return seen;
}

/// Every question about one box, compared with going through all.
void expect_as_brute_force(const BoxBvh& tree, const std::vector<Aabb>& boxes, const Aabb& asked, const Vec3& motion) {
  std::vector<Index> overlapping;
  for (Index i = 0; i < boxes.size(); ++i)
    if (!is_empty(boxes[i]) && overlap(boxes[i], asked)) overlapping.push_back(i);
  EXPECT_EQ(tree.overlapping(asked), overlapping);
  const auto gap = [&](const Aabb& box) { return box_gap(asked, box); };
  const auto time = [&](const Aabb& box) { return box_entry(asked, motion, box); };
  for (const double limit : {infinity, 1.0, 0.0}) {
    EXPECT_EQ(seen_by([&](const auto& see) { tree.visit_nearest(asked, limit, see); }, tree, gap),
              seen_by_brute_force(boxes, limit, gap));
    EXPECT_EQ(seen_by([&](const auto& see) { tree.visit_along(asked, motion, limit, see); }, tree, time),
              seen_by_brute_force(boxes, limit, time));
  }
}

TEST(BoxBvh, AnswersAsBruteForce) {
  for (const std::string_view family : test::box_families) {
    SCOPED_TRACE(family);
    Random random(5);
    const std::vector<Aabb> boxes = boxes_of(family, 200, random);
    const BoxBvh tree(boxes);
    for (std::size_t i = 0; i < 30; ++i) {
      Aabb asked = test::random_box(family, i, random);
      if (i % 3 == 0) asked.upper = asked.lower;
      if (i % 10 == 1) asked = {{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}};
      expect_as_brute_force(tree, boxes, asked, motion_in(family, random));
    }
  }
}

TEST(BoxBvh, KeptThroughALifeAnswersAsANewOne) {
  for (const std::string_view family : test::box_families) {
    SCOPED_TRACE(family);
    Random random(6);
    std::vector<Aabb> boxes;
    BoxBvh tree;
    for (int frame = 0; frame < 40; ++frame) {
      const std::uint64_t change = random.below(4);
      if (change == 0) boxes.resize(random.below(120));
      if (change == 1)
        for (std::uint64_t i = random.below(40); i > 0; --i) boxes.push_back(test::random_box(family, i, random));
      for (Aabb& box : boxes)
        if (random.below(change == 2 ? 2 : 20) == 0)
          box = random.below(4) == 0 ? Aabb{} : test::random_box(family, random.below(100), random);
      tree.update(boxes);
      ASSERT_EQ(tree.size(), boxes.size());
      for (std::size_t i = 0; i < 4; ++i)
        expect_as_brute_force(tree, boxes, test::random_box(family, i, random), motion_in(family, random));
    }
  }
}

/// In the order in which the tree comes by.
std::vector<Index> order_of(const BoxBvh& tree) {
  std::vector<Index> order;
  tree.visit_overlapping({{-1e9, -1e9, -1e9}, {1e9, 1e9, 1e9}}, [&](Index number) {
    order.push_back(number);
    return true;
  });
  return order;
}

TEST(BoxBvh, IsBuiltAnewWhereAllMoveUponOneThatStays) {
  Random random(7);
  const auto some_box = [&] {
    const double x = random.between(0, 100), y = random.between(0, 100), z = random.between(0, 100);
    return Aabb{{x, y, z}, {x + 1, y + 1, z + 1}};
  };
  std::vector<Aabb> boxes{{{-1e6, -1e6, -1e6}, {1e6, 1e6, 0}}};  // by far the largest node is the one around it
  for (int i = 0; i < 500; ++i) boxes.push_back(some_box());
  BoxBvh tree(boxes);
  const std::vector<Index> first = order_of(tree);
  for (Aabb& box : boxes)
    if (&box != boxes.data()) box = {box.lower + Vec3{0.125, 0, 0}, box.upper + Vec3{0.125, 0, 0}};
  tree.update(boxes);
  EXPECT_EQ(order_of(tree), first);  // kept
  std::generate(boxes.begin() + 1, boxes.end(), some_box);
  tree.update(boxes);
  EXPECT_NE(order_of(tree), first);
  EXPECT_EQ(order_of(tree), order_of(BoxBvh(boxes)));
}

TEST(BoxBvh, FindsNoEmptyBoxInOneWithoutEnd) {
  const Aabb everything{{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}};
  EXPECT_TRUE(overlap(Aabb{}, everything));  // its comparisons do
  EXPECT_FALSE(overlap(Aabb{}, Aabb{{-1e308, -1e308, -1e308}, {1e308, 1e308, 1e308}}));
  const std::vector<Aabb> boxes{{}, everything, {{0, 0, 0}, {1, 1, 1}}};
  EXPECT_EQ(BoxBvh(boxes).overlapping(everything), (std::vector<Index>{1, 2}));
  EXPECT_TRUE(BoxBvh(boxes).overlapping({}).empty());
}

TEST(BoxBvh, EndsWhenToldTo) {
  const std::vector<Aabb> boxes(50, Aabb{{0, 0, 0}, {1, 1, 1}});
  const BoxBvh tree(boxes);
  int seen = 0;
  tree.visit_overlapping(boxes[0], [&](Index) { return ++seen < 3; });
  EXPECT_EQ(seen, 3);
  seen = 0;
  tree.visit_nearest(boxes[0], 9, [&](Index) { return ++seen < 5 ? 9.0 : -1.0; });
  EXPECT_EQ(seen, 5);
  BoxBvh().visit_overlapping(boxes[0], [&](Index) { return ++seen > 0; });
  EXPECT_EQ(seen, 5);
}

}  // namespace
}  // namespace toccata::test
