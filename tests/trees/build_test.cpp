#include "toccata/trees/builders.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "toccata/core/random.hpp"

namespace toccata {
namespace {

Aabb point_box(double x, double y, double z) { return {{x, y, z}, {x, y, z}}; }

/// Every item is below exactly one leaf, every volume fits exactly what is below it, children come after parents.
/// Returns the depth.
int check_node(const Bvh<Aabb>& tree, std::span<const Aabb> boxes, Index number, Index leaf_size,
               std::vector<int>& seen, Aabb& around) {
  const BvhNode<Aabb>& node = tree.nodes[number];
  int depth = 0;
  if (node.is_leaf()) {
    EXPECT_LE(node.count, leaf_size);
    for (Index i = node.first; i < node.first + node.count; ++i) {
      ++seen[tree.items[i]];
      around = merge(around, boxes[tree.items[i]]);
    }
  } else {
    EXPECT_EQ(node.child_count, 2U);
    for (Index child = node.first; child < node.first + node.child_count; ++child) {
      EXPECT_GT(child, number);
      Aabb below;
      depth = std::max(depth, check_node(tree, boxes, child, leaf_size, seen, below));
      around = merge(around, below);
    }
  }
  EXPECT_EQ(node.volume, around);
  return depth + 1;
}

int check(const std::vector<Aabb>& boxes, Index leaf_size) {
  const Bvh<Aabb> tree = build_bvh(boxes, {leaf_size});
  std::vector<int> seen(boxes.size(), 0);
  Aabb around;
  const int depth = check_node(tree, boxes, 0, leaf_size, seen, around);
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<std::ptrdiff_t>(boxes.size()));
  return depth;
}

TEST(BuildTree, NoItemsNoNodes) {
  EXPECT_TRUE(build_bvh({}).nodes.empty());
  EXPECT_TRUE(build_bvh({}).items.empty());
}

TEST(BuildTree, OneItemIsALeaf) { EXPECT_EQ(check({point_box(1, 2, 3)}, 1), 1); }

TEST(BuildTree, FitsRandomBoxes) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    std::vector<Aabb> boxes;
    for (std::uint64_t i = 0, count = 1 + random.below(500); i < count; ++i) {
      const Vec3 lower{random.unit(), random.unit(), static_cast<double>(random.below(3))};
      boxes.push_back({lower, lower + Vec3{0.1 * random.unit(), 0, 0.1 * random.unit()}});
    }
    check(boxes, static_cast<Index>(1 + seed % 6));
  }
}

TEST(BuildTree, CoincidentItemsAreHalved) {
  EXPECT_LE(check(std::vector<Aabb>(1 << 12, point_box(1, 2, 3)), 1), 13);
  EXPECT_LE(check(std::vector<Aabb>(1 << 12, Aabb{{0, 0, 0}, {1, 1, 1}}), 1), 13);
}

TEST(BuildTree, ItemsOverManyOrdersOfMagnitudeStayShallow) {
  std::vector<Aabb> boxes;
  for (int exponent = -1074; exponent < 1023; ++exponent)
    for (int copy = 0; copy < 4; ++copy) boxes.push_back(point_box(std::ldexp(1.0, exponent), 0, 0));
  EXPECT_LE(check(boxes, 1), 64 + 14);
}

/// Areas of 0 must not make the heuristic compare what is not a number.
TEST(BuildTree, BoxesWithoutAreaAreSplitLikeOthers) {
  for (const Vec3& along : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{1, -2, 3}}) {
    std::vector<Aabb> points, segments;
    for (int i = 0; i < 1 << 10; ++i) {
      const Vec3 p = static_cast<double>((i * 37) % (1 << 10)) * along;
      points.push_back({p, p});
      const Vec3 q = static_cast<double>(i) * Vec3{1, 0, 0};
      segments.push_back({q, q + Vec3{0.5, 0, 0}});
    }
    EXPECT_LE(check(points, 1), 14);
    EXPECT_LE(check(segments, 1), 14);
  }
}

TEST(BuildTree, TheLargestAndSmallestDoubles) {
  const double huge = std::numeric_limits<double>::max(), tiny = std::numeric_limits<double>::denorm_min();
  std::vector<Aabb> boxes;
  for (int i = 0; i < 50; ++i) {
    boxes.push_back({{-huge, -huge, -huge}, {huge, huge, huge}});
    boxes.push_back(point_box(i % 2 == 0 ? huge : -huge, 0, 0));
    boxes.push_back(point_box(0, i * tiny, 0));
  }
  check(boxes, 2);
  boxes.clear();
  for (int i = 0; i < 50; ++i) boxes.push_back(point_box(0, i * tiny, 0));
  check(boxes, 2);
}

TEST(BuildTree, TheSameBoxesGiveTheSameTree) {
  Random random(5);
  std::vector<Aabb> boxes;
  for (int i = 0; i < 300; ++i) {
    const double x = random.unit(), y = random.unit(), z = random.unit();
    boxes.push_back(point_box(x, y, z));
  }
  EXPECT_EQ(build_bvh(boxes).items, build_bvh(boxes).items);
}

}  // namespace
}  // namespace toccata
