#include "toccata/trees/walk.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "toccata/core/random.hpp"
#include "toccata/trees/builders.hpp"

namespace toccata {
namespace {

constexpr double disjoint = std::numeric_limits<double>::infinity();

std::vector<Aabb> random_boxes(Random& random, std::size_t count, double size) {
  std::vector<Aabb> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 lower{random.unit(), random.unit(), random.unit()};
    boxes.push_back({lower, lower + Vec3{size * random.unit(), size * random.unit(), size * random.unit()}});
  }
  return boxes;
}

/// The same hierarchy with grandchildren in place of children: a tree of another arity.
Bvh<Aabb, 4> widened(const Bvh<Aabb>& tree) {
  Bvh<Aabb, 4> wide;
  wide.items = tree.items;
  if (tree.nodes.empty()) return wide;
  std::vector<Index> source{0};
  wide.nodes.push_back(tree.nodes[0]);
  for (Index i = 0; i < wide.nodes.size(); ++i) {
    const BvhNode<Aabb>& node = tree.nodes[source[i]];
    if (node.is_leaf()) continue;
    wide.nodes[i].first = static_cast<Index>(wide.nodes.size());
    wide.nodes[i].child_count = 0;
    for (Index child = node.first; child < node.first + node.child_count; ++child) {
      const bool leaf = tree.nodes[child].is_leaf();
      const Index first = leaf ? child : tree.nodes[child].first;
      const Index count = leaf ? 1 : tree.nodes[child].child_count;
      for (Index j = first; j < first + count; ++j) {
        source.push_back(j);
        wide.nodes.push_back(tree.nodes[j]);
        ++wide.nodes[i].child_count;
      }
    }
  }
  return wide;
}

struct BoxesIntersecting {
  const std::vector<Aabb>& a;
  const std::vector<Aabb>& b;
  std::vector<ItemPair> found{};

  double bound(const Aabb& x, const Aabb& y) const { return overlap(x, y) ? 0 : disjoint; }
  double limit() const { return 0; }
  void visit(std::span<const ItemPair> pairs) {
    for (const ItemPair& pair : pairs)
      if (overlap(a[pair.first], b[pair.second])) found.push_back(pair);
  }
  std::vector<ItemPair> sorted() {
    std::sort(found.begin(), found.end());
    return found;
  }
};

std::vector<ItemPair> pairs_by_brute_force(const std::vector<Aabb>& a, const std::vector<Aabb>& b) {
  std::vector<ItemPair> pairs;
  for (Index i = 0; i < a.size(); ++i)
    for (Index j = 0; j < b.size(); ++j)
      if (overlap(a[i], b[j])) pairs.push_back({i, j});
  return pairs;
}

TEST(Walk, PairsAreThoseOfBruteForce) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const auto a = random_boxes(random, random.below(200), 0.2);
    const auto b = random_boxes(random, random.below(200), 0.1);
    const BuildOptions leaves{static_cast<Index>(1 + seed % 5)};
    BoxesIntersecting question{a, b};
    const WalkCounts counts = walk_pair(build_bvh(a, leaves), build_bvh(b), question);
    EXPECT_EQ(question.sorted(), pairs_by_brute_force(a, b));
    EXPECT_GE(counts.items, question.found.size());
    EXPECT_EQ(counts.volumes_updated, 0U);

    BoxesIntersecting mixed{a, b};
    walk_pair(widened(build_bvh(a, leaves)), build_bvh(b), mixed);
    EXPECT_EQ(mixed.sorted(), question.found) << "another arity";
  }
}

TEST(Walk, LeavesWithMorePairsThanABatchHolds) {
  for (const Index leaf_size : {15U, 16U, 17U, 40U, 300U}) {
    SCOPED_TRACE(leaf_size);
    Random random(leaf_size);
    const auto boxes = random_boxes(random, 700, 0.3);
    const auto tree = build_bvh(boxes, {leaf_size});
    BoxesIntersecting pairs{boxes, boxes}, self{boxes, boxes};
    walk_pair(tree, tree, pairs);
    walk_self(tree, self);
    EXPECT_EQ(pairs.sorted(), pairs_by_brute_force(boxes, boxes));
    EXPECT_EQ(2 * self.found.size() + boxes.size(), pairs.found.size());
  }
}

TEST(Walk, ATreePairedWithItselfKeepsTheOrderOfItsSides) {
  Random random(3);
  const auto boxes = random_boxes(random, 50, 0.3);
  const auto tree = build_bvh(boxes);
  BoxesIntersecting question{boxes, boxes};
  walk_pair(tree, tree, question);
  EXPECT_EQ(question.sorted(), pairs_by_brute_force(boxes, boxes));
}

TEST(Walk, SelfPairsComeOnceAndNeverWithThemselves) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const auto boxes = random_boxes(random, random.below(300), 0.15);
    std::vector<ItemPair> expected;
    for (const ItemPair& pair : pairs_by_brute_force(boxes, boxes))
      if (pair.first < pair.second) expected.push_back(pair);
    const auto tree = build_bvh(boxes, {static_cast<Index>(1 + seed % 7)});
    BoxesIntersecting question{boxes, boxes};
    walk_self(tree, question);
    EXPECT_EQ(question.sorted(), expected);

    BoxesIntersecting wide{boxes, boxes};
    walk_self(widened(tree), wide);
    EXPECT_EQ(wide.sorted(), expected) << "another arity";
  }
}

TEST(Walk, SelfPairsOfCoincidentItemsAreAll) {
  const std::vector<Aabb> boxes(30, Aabb{{0, 0, 0}, {1, 1, 1}});
  BoxesIntersecting question{boxes, boxes};
  const WalkCounts counts = walk_self(build_bvh(boxes), question);
  EXPECT_EQ(question.found.size(), 30U * 29U / 2U);
  EXPECT_EQ(counts.items, 30U * 29U / 2U);
}

/// A tree that is a list, deeper than any stack of fixed size: every inner node has a leaf and the rest as children.
Bvh<Aabb> list_of(const std::vector<Aabb>& boxes) {
  Bvh<Aabb> tree;
  Aabb around;
  for (const Aabb& box : boxes) around = merge(around, box);
  tree.nodes.push_back({around});
  for (Index i = 0; i < boxes.size(); ++i) {
    tree.items.push_back(i);
    const auto rest = static_cast<Index>(tree.nodes.size() - 1);
    if (i + 1 == boxes.size()) {
      tree.nodes[rest].first = i;
      tree.nodes[rest].count = 1;
    } else {
      tree.nodes[rest].first = rest + 1;
      tree.nodes[rest].child_count = 2;
      tree.nodes.push_back({boxes[i], i, 1, 0});
      tree.nodes.push_back({around});
    }
  }
  return tree;
}

TEST(Walk, ATreeDeeperThanAnyStackLosesNothing) {
  constexpr std::size_t count = 1500;
  const std::vector<Aabb> boxes(count, Aabb{{0, 0, 0}, {1, 1, 1}});
  const Bvh<Aabb> list = list_of(boxes);
  BoxesIntersecting pairs{boxes, boxes}, self{boxes, boxes};
  walk_pair(list, build_bvh(boxes), pairs);
  EXPECT_EQ(pairs.found.size(), count * count);
  walk_self(list, self);
  EXPECT_EQ(self.found.size(), count * (count - 1) / 2);
}

struct NearestBox {
  const std::vector<Aabb>& boxes;
  Vec3 point;
  double best = 1e300;

  double bound(const Aabb& box) const {
    double squared = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double gap = std::max({box.lower[axis] - point[axis], point[axis] - box.upper[axis], 0.0});
      squared += gap * gap;
    }
    return squared;
  }
  double limit() const { return best; }
  void visit(std::span<const Index> items) {
    for (const Index item : items) best = std::min(best, bound(boxes[item]));
  }
};

TEST(Walk, AShrinkingLimitFindsTheLeast) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const auto boxes = random_boxes(random, 1 + random.below(400), 0.05);
    NearestBox question{boxes, {2 * random.unit(), 2 * random.unit(), 2 * random.unit()}};
    double expected = question.best;
    for (const Aabb& box : boxes) expected = std::min(expected, question.bound(box));
    const WalkCounts counts = walk(build_bvh(boxes), question);
    EXPECT_EQ(question.best, expected);
    EXPECT_LE(counts.items, boxes.size());
  }
}

struct First {
  std::size_t visited = 0;
  bool ended = false;
  double bound(const Aabb&, const Aabb&) const { return 0; }
  double limit() const { return ended ? -1 : 0; }
  void visit(std::span<const ItemPair> pairs) {
    EXPECT_FALSE(ended) << "visited after the end";
    visited += pairs.size();
    ended = true;
  }
};

TEST(Walk, ALimitOfMinusOneEndsAfterTheFirstSmallBatch) {
  Random random(1);
  const auto boxes = random_boxes(random, 1000, 0.1);
  const auto tree = build_bvh(boxes);
  First question;
  walk_pair(tree, tree, question);
  EXPECT_GE(question.visited, 16U);
  EXPECT_LT(question.visited, 16U + 4 * 4);  // the pairs of two leaves are not torn apart
}

struct NotANumber {
  std::size_t visited = 0;
  double bound(const Aabb&) const { return std::numeric_limits<double>::quiet_NaN(); }
  double limit() const { return 0; }
  void visit(std::span<const Index> items) { visited += items.size(); }
};

TEST(Walk, ABoundThatIsNotANumberLosesNothing) {
  Random random(1);
  const auto boxes = random_boxes(random, 100, 0.1);
  NotANumber question;
  EXPECT_EQ(walk(build_bvh(boxes), question).items, 100U);
  EXPECT_EQ(question.visited, 100U);
}

TEST(Walk, EmptyTreesHaveNoItems) {
  const std::vector<Aabb> none, one{Aabb{{0, 0, 0}, {1, 1, 1}}};
  BoxesIntersecting question{none, one};
  EXPECT_EQ(walk_pair(build_bvh(none), build_bvh(one), question), WalkCounts{});
  EXPECT_EQ(walk_self(build_bvh(none), question), WalkCounts{});
  NotANumber single;
  EXPECT_EQ(walk(build_bvh(none), single), WalkCounts{});
}

}  // namespace
}  // namespace toccata
