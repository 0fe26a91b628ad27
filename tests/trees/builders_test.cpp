#include "toccata/trees/builders.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "toccata/bounds/ball.hpp"
#include "toccata/bounds/kdop.hpp"
#include "toccata/bounds/obb.hpp"
#include "toccata/bounds/swept_sphere.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"
#include "toccata/trees/walk.hpp"

namespace toccata {
namespace {

constexpr std::array all_methods{BvhMethod::mean,          BvhMethod::median,    BvhMethod::heuristic,
                                 BvhMethod::agglomeration, BvhMethod::insertion, BvhMethod::morton,
                                 BvhMethod::equal_regions};

const std::vector<std::string> regimes = {"random", "same", "line", "grid", "graded", "huge"};

/// same: all triangles coincide; grid: many equal distances; graded: sizes from 1 to 1e-300.
std::vector<Triangle> triangles_of(const std::string& regime, Random& random, std::size_t count) {
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < count; ++i) {
    const auto number = [&] { return random.between(-1, 1); };
    const double x = number(), y = number(), z = number();
    Vec3 place = 10 * Vec3{x, y, z};
    double size = 1;
    if (regime == "same") place = {};
    if (regime == "line") place = {place.x, 0, 0};
    if (regime == "grid") place = {std::floor(place.x), std::floor(place.y), 0};
    if (regime == "graded") size = std::ldexp(1.0, -static_cast<int>(random.below(990)));
    if (regime == "huge") size = 0x1p990;
    const Vec3 p = size * place;
    triangles.push_back({{p, p + Vec3{size, 0, 0}, p + Vec3{0, size, size}}});
  }
  return triangles;
}

std::string text_of(BvhMethod method, const std::string& regime) {
  return "method " + std::to_string(static_cast<int>(method)) + ", " + regime;
}

/// Every item once, children after their parents, arity and leaf size kept, every volume around its items.
template <class Volume, int Arity>
void expect_valid(const Bvh<Volume, Arity>& tree, const std::vector<Triangle>& triangles, Index leaf_size) {
  std::vector<Index> items = tree.items;
  std::sort(items.begin(), items.end());
  ASSERT_EQ(items.size(), triangles.size());
  for (Index i = 0; i < items.size(); ++i) ASSERT_EQ(items[i], i);
  std::vector<int> parents(tree.nodes.size(), 0);
  std::vector<std::vector<Index>> below(tree.nodes.size());
  for (std::size_t i = tree.nodes.size(); i-- > 0;) {
    const BvhNode<Volume>& node = tree.nodes[i];
    if (node.is_leaf()) {
      ASSERT_LE(node.count, leaf_size);
      below[i].assign(tree.items.begin() + node.first, tree.items.begin() + node.first + node.count);
    } else {
      ASSERT_GE(node.child_count, 2U);
      ASSERT_LE(node.child_count, static_cast<Index>(Arity));
      for (Index k = 0; k < node.child_count; ++k) {
        ASSERT_GT(node.first + k, i);
        ++parents[node.first + k];
        below[i].insert(below[i].end(), below[node.first + k].begin(), below[node.first + k].end());
      }
    }
    for (const Index item : below[i])
      for (const Vec3& corner : triangles[item].vertex) ASSERT_TRUE(contains(node.volume, corner));
  }
  EXPECT_EQ(std::count(parents.begin(), parents.end(), 1), static_cast<std::ptrdiff_t>(tree.nodes.size()) - 1);
}

template <class Volume, int Arity>
void expect_all_methods_valid() {
  for (const std::string& regime : regimes)
    for (const BvhMethod method : all_methods) {
      SCOPED_TRACE(text_of(method, regime));
      Random random(11);
      for (const std::size_t count : {1U, 2U, 3U, 40U}) {
        const std::vector<Triangle> triangles = triangles_of(regime, random, count);
        for (const Index leaf_size : {1U, 3U})
          expect_valid(build_bvh<Volume, Arity>(triangles, {.method = method, .leaf_size = leaf_size}), triangles,
                       leaf_size);
      }
    }
}

TEST(Builders, MakeValidTreesOfAnyArityAndVolume) {
  expect_all_methods_valid<Aabb, 2>();
  expect_all_methods_valid<Obb, 2>();
  expect_all_methods_valid<Rss, 4>();
  expect_all_methods_valid<Kdop<18>, 8>();
  expect_all_methods_valid<Ball, 3>();
}

struct OverlapCount {
  const std::vector<Triangle>* a;
  const std::vector<Triangle>* b;
  std::vector<ItemPair> found{};
  template <class V>
  double bound(const V& x, const V& y) const {
    return overlap(x, y) ? 0 : std::numeric_limits<double>::infinity();
  }
  double limit() const { return 0; }
  void visit(std::span<const ItemPair> pairs) {
    for (const ItemPair& pair : pairs)
      if (overlap(fit<Kdop<14>>((*a)[pair.first].vertex), fit<Kdop<14>>((*b)[pair.second].vertex)))
        found.push_back(pair);
  }
};

TEST(Builders, WalksFindTheSamePairsInAllOfThem) {
  Random random(3);
  const std::vector<Triangle> a = triangles_of("random", random, 300), b = triangles_of("random", random, 300);
  OverlapCount brute{&a, &b};
  std::vector<ItemPair> all;
  for (Index i = 0; i < a.size(); ++i)
    for (Index j = 0; j < b.size(); ++j) all.push_back({i, j});
  brute.visit(all);
  ASSERT_GT(brute.found.size(), 20U);
  for (const BvhMethod method : all_methods) {
    SCOPED_TRACE(text_of(method, "random"));
    OverlapCount walked{&a, &b};
    const WalkCounts counts = walk_pair(build_bvh<Kdop<14>, 4>(a, {.method = method, .leaf_size = 2}),
                                        build_bvh<Kdop<14>, 2>(b, {.method = method}), walked);
    std::sort(walked.found.begin(), walked.found.end());
    EXPECT_EQ(walked.found, brute.found);
    EXPECT_LT(counts.items, all.size() / 2);
  }
}

TEST(Builders, TheRecursiveAndTheIterativeDriverMakeTheSameTree) {
  for (const std::string& regime : regimes)
    for (const BvhMethod method : {BvhMethod::mean, BvhMethod::median, BvhMethod::equal_regions}) {
      SCOPED_TRACE(text_of(method, regime));
      Random random(5);
      const std::vector<Triangle> triangles = triangles_of(regime, random, 200);
      const auto one = build_bvh<Aabb>(triangles, {.method = method, .driver = BvhDriver::iterative});
      const auto other = build_bvh<Aabb>(triangles, {.method = method, .driver = BvhDriver::recursive});
      EXPECT_EQ(one.items, other.items);
      ASSERT_EQ(one.nodes.size(), other.nodes.size());
      for (std::size_t i = 0; i < one.nodes.size(); ++i) {
        EXPECT_EQ(one.nodes[i].volume, other.nodes[i].volume);
        EXPECT_EQ(one.nodes[i].first, other.nodes[i].first);
      }
    }
}

/// Larger than what one thread takes on at once.
TEST(Builders, MakeTheSameTreeOnAnyNumberOfThreads) {
  for (const std::string& regime : {std::string("random"), std::string("grid")})
    for (const BvhMethod method : all_methods) {
      SCOPED_TRACE(text_of(method, regime));
      Random random(12);
      const std::vector<Triangle> triangles = triangles_of(regime, random, 5000);
      const auto one = build_bvh<Aabb, 4>(triangles, {.method = method, .threads = 1});
      for (const int threads : {2, 3}) {
        const auto other = build_bvh<Aabb, 4>(triangles, {.method = method, .threads = threads});
        EXPECT_EQ(one.items, other.items);
        EXPECT_EQ(one.built_size, other.built_size);
        ASSERT_EQ(one.nodes.size(), other.nodes.size());
        for (std::size_t i = 0; i < one.nodes.size(); ++i) {
          ASSERT_EQ(one.nodes[i].volume, other.nodes[i].volume);
          ASSERT_EQ(one.nodes[i].first, other.nodes[i].first);
          ASSERT_EQ(one.nodes[i].count, other.nodes[i].count);
          ASSERT_EQ(one.nodes[i].child_count, other.nodes[i].child_count);
        }
      }
    }
}

/// The lecture's four: parts of one size, and boxes of any.
TEST(Builders, EqualRegionsAreEqualAndTheBoxesInThemNot) {
  std::vector<Triangle> triangles;
  const auto add = [&](double x, double y, double size) {
    const Vec3 p{x, y, 0};
    triangles.push_back({{p - Vec3{size, size, 0}, p + Vec3{2 * size, -size, 0}, p + Vec3{-size, 2 * size, 0}}});
  };
  // Centroids from (0, 0) to (9, 8): in x cut at 4.5, and each half in y, the longer axis then, at 4.
  for (const auto& [x, y] :
       std::vector<std::pair<double, double>>{{0, 0}, {3, 2}, {3.9, 3.9}, {5, 1}, {9, 0}, {0, 8}, {7, 8}, {4.6, 4.1}})
    add(x, y, 0.125);
  const auto tree = build_bvh<Aabb, 4>(triangles, {.method = BvhMethod::equal_regions, .leaf_size = 3});
  ASSERT_EQ(tree.nodes.size(), 5U);
  std::vector<std::vector<Index>> groups;
  for (Index k = 0; k < 4; ++k) {
    const auto& node = tree.nodes[tree.nodes[0].first + k];
    const auto first = tree.items.begin() + node.first;
    groups.emplace_back(first, first + node.count);
    std::sort(groups.back().begin(), groups.back().end());
  }
  EXPECT_EQ(groups, (std::vector<std::vector<Index>>{{0, 1, 2}, {5}, {3, 4}, {6, 7}}));
  EXPECT_LT(half_area(tree.nodes[2].volume), 0.1 * half_area(tree.nodes[1].volume));
}

/// For every number of children a node may have, by the definition: the parts of one box have one volume, each child
/// holds the centroids of one of them, and all of them.
TEST(Builders, EqualRegionsAreAsManyAsANodeMayHaveChildren) {
  Random random(21);
  const std::vector<Triangle> triangles = triangles_of("random", random, 2000);
  for (int arity = 2; arity <= 8; ++arity) {
    SCOPED_TRACE(arity);
    const BvhShape shape = build_bvh_shape(triangles, arity, {.method = BvhMethod::equal_regions});
    const std::vector<ItemRun> runs = item_runs(shape);
    ASSERT_EQ(shape.nodes[0].child_count, static_cast<Index>(arity));
    // So many centroids, evenly spread, are shared about evenly by parts of one volume.
    for (Index k = 0; k < shape.nodes[0].child_count; ++k)
      EXPECT_NEAR(runs[shape.nodes[0].first + k].count, 2000.0 / arity, 5 * std::sqrt(2000.0 / arity));
  }
}

TEST(Builders, ReportBalance) {
  Random random(6);
  const std::vector<Triangle> triangles = triangles_of("random", random, 64);
  const BvhBalance even = balance_of(build_bvh<Aabb>(triangles, {.method = BvhMethod::median}));
  EXPECT_EQ(even.leaves, 64U);
  EXPECT_EQ(even.nodes, 127U);
  EXPECT_EQ(even.least_depth, 6);
  EXPECT_EQ(even.greatest_depth, 6);
  EXPECT_EQ(even.best_depth, 6);
  EXPECT_EQ(balance_of(build_bvh<Aabb, 8>(triangles, {.method = BvhMethod::median})).greatest_depth, 2);
  // Nothing makes a list from the top down or along the curve, and from the bottom up only sizes over hundreds of
  // orders of magnitude do.
  for (const BvhMethod method : all_methods)
    for (const char* regime : {"graded", "same", "line"}) {
      const bool upwards = method == BvhMethod::agglomeration || method == BvhMethod::insertion;
      if (upwards && regime == std::string("graded")) continue;
      SCOPED_TRACE(text_of(method, regime));
      const std::vector<Triangle> many = triangles_of(regime, random, 500);
      EXPECT_LT(balance_of(build_bvh<Aabb>(many, {.method = method})).greatest_depth, 120);
    }
}

TEST(Builders, ANothingIsAnEmptyTreeAndAnUnknownArityAnError) {
  const std::vector<Triangle> none;
  EXPECT_TRUE((build_bvh<Obb, 4>(none).nodes.empty()));
  EXPECT_EQ(balance_of(build_bvh<Aabb>(none)).leaves, 0U);
  EXPECT_THROW(static_cast<void>(build_bvh_shape(none, 1, {})), Error);
  EXPECT_THROW(static_cast<void>(build_bvh_shape(none, 9, {})), Error);
}

TEST(Refit, HoldsWhatHasMovedAndTellsWhenToRebuild) {
  Random random(7);
  const std::vector<Triangle> before = triangles_of("random", random, 200);
  auto tree = build_bvh<Aabb, 4>(before, {.leaf_size = 2});
  const auto built = tree;
  const Refit still = refit(tree, before);
  EXPECT_EQ(still.volumes_updated, tree.nodes.size());
  EXPECT_NEAR(still.growth, 1, 1e-12);  // another order of the sum
  EXPECT_FALSE(still.should_rebuild());
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) EXPECT_EQ(tree.nodes[i].volume, built.nodes[i].volume);
  // Every triangle goes where another was: nothing of the order is left.
  std::vector<Triangle> shuffled = before;
  for (std::size_t i = shuffled.size(); i > 1; --i) std::swap(shuffled[i - 1], shuffled[random.below(i)]);
  EXPECT_TRUE(refit(tree, shuffled).should_rebuild());
  expect_valid(tree, shuffled, 2);
  auto oriented = build_bvh<Obb>(before);
  refit(oriented, shuffled);
  expect_valid(oriented, shuffled, 1);
}

TEST(Refit, WhatGrowsFromNothingOrOutOfRangeIsRebuilt) {
  const std::vector<Triangle> points(10, Triangle{{Vec3{1, 2, 3}, Vec3{1, 2, 3}, Vec3{1, 2, 3}}});
  auto tree = build_bvh<Aabb>(points);
  EXPECT_FALSE(refit(tree, points).should_rebuild());
  Random random(9);
  const std::vector<Triangle> grown = triangles_of("random", random, 10);
  EXPECT_TRUE(refit(tree, grown).should_rebuild());
  std::vector<Triangle> huge = grown;
  huge[0].vertex[0] = {1e200, 1e200, 1e200};
  for (int frame = 0; frame < 2; ++frame) EXPECT_TRUE(refit(tree, huge).should_rebuild());
}

TEST(Refit, GrowthIsCountedFromTheBuildHoweverSlowItIs) {
  Random random(8);
  std::vector<Triangle> moving = triangles_of("random", random, 100);
  auto tree = build_bvh<Aabb>(moving);
  int frames = 0;
  for (Refit last; !last.should_rebuild() && frames < 1000; ++frames) {
    for (std::size_t i = 0; i < moving.size(); ++i)
      for (Vec3& corner : moving[i].vertex) corner.x += i % 2 == 0 ? 0.01 : -0.01;
    last = refit(tree, moving);
  }
  EXPECT_GT(frames, 5);
  EXPECT_LT(frames, 1000);
}

}  // namespace
}  // namespace toccata
