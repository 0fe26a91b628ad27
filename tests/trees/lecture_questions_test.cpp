// The questions and worked examples of the lectures about hierarchies, each shown (docs/methods/questions.md lists
// them).
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "toccata/bounds/all_volumes.hpp"
#include "toccata/core/random.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/narrow/primitives.hpp"
#include "toccata/narrow/triangle_triangle.hpp"
#include "toccata/trees/builders.hpp"
#include "toccata/trees/walk.hpp"

namespace toccata {
namespace {

constexpr double nothing_inside = std::numeric_limits<double>::infinity();

std::vector<Triangle> triangles_of(const TriangleMesh& mesh, const Vec3& moved = {}) {
  std::vector<Triangle> triangles;
  for (const std::array<Index, 3>& corner : mesh.triangles()) {
    const auto at = [&](std::size_t i) { return mesh.vertices()[corner[i]] + moved; };
    triangles.push_back({{at(0), at(1), at(2)}});
  }
  return triangles;
}

/// Which triangles meet a ball, asked of the hierarchy as the slides tell: nothing is said of a node's inside but by
/// its volume, and true comes from triangles alone.
struct MeetsBall {
  const std::vector<Triangle>* triangles;
  PosedSphere ball;
  std::vector<Index> found{};
  template <class Volume>
  double bound(const Volume& volume) const {
    return overlap(volume, fit<Volume>(box_corners())) ? 0 : nothing_inside;
  }
  double limit() const { return 0; }
  void visit(std::span<const Index> items) {
    for (const Index item : items)
      if (overlap(ball, (*triangles)[item])) found.push_back(item);
  }

 private:
  /// The ball's own bound: corners of a box around it.
  std::vector<Vec3> box_corners() const {
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i)
      corners.push_back(ball.centre + ball.radius * Vec3{i & 1 ? 1. : -1., i & 2 ? 1. : -1., i & 4 ? 1. : -1.});
    return corners;
  }
};

template <class Volume>
void expect_hierarchy_finds_what_a_ball_meets(const std::vector<Triangle>& triangles) {
  const auto tree = build_bvh<Volume>(triangles);
  std::size_t hits = 0;
  for (const PosedSphere& ball : {PosedSphere({1, 0, 0}, 0.125), PosedSphere({0, 0, 0}, 0.5), PosedSphere({9, 9, 9}, 1),
                                  PosedSphere({-0.6, 0.5, 0.6}, 0.25)}) {
    MeetsBall question{&triangles, ball};
    const WalkCounts counts = walk(tree, question);
    std::vector<Index> expected;
    for (Index i = 0; i < triangles.size(); ++i)
      if (overlap(ball, triangles[i])) expected.push_back(i);
    std::sort(question.found.begin(), question.found.end());
    EXPECT_EQ(question.found, expected);
    EXPECT_LT(counts.items, triangles.size() / 4);
    const bool is_far = ball.centre.x == 9;
    EXPECT_EQ(counts == (WalkCounts{0, 1, 0}), is_far);  // where the roots are disjoint one test is all
    hits += expected.size();
  }
  EXPECT_GT(hits, 10U);
}

TEST(LectureQuestion, AHierarchyAgainstASphereFindsTheTrianglesThatItMeets) {
  const std::vector<Triangle> ball = triangles_of(icosphere_mesh(1, 3));
  expect_hierarchy_finds_what_a_ball_meets<Obb>(ball);
  expect_hierarchy_finds_what_a_ball_meets<Ball>(ball);
  expect_hierarchy_finds_what_a_ball_meets<Aabb>(ball);
}

/// Pairs of triangles that meet.
struct MeetingPairs {
  const std::vector<Triangle>* a;
  const std::vector<Triangle>* b;
  std::vector<ItemPair> found{};
  template <class Volume>
  double bound(const Volume& x, const Volume& y) const {
    return overlap(x, y) ? 0 : nothing_inside;
  }
  double limit() const { return 0; }
  void visit(std::span<const ItemPair> pairs) {
    for (const ItemPair& pair : pairs)
      if (overlap((*a)[pair.first], (*b)[pair.second])) found.push_back(pair);
  }
};

/// Items below each node, in the order of the tree.
template <class Volume>
std::vector<std::vector<Index>> items_below(const Bvh<Volume>& tree) {
  std::vector<std::vector<Index>> below(tree.nodes.size());
  for (std::size_t i = tree.nodes.size(); i-- > 0;) {
    const BvhNode<Volume>& node = tree.nodes[i];
    for (Index k = 0; k < node.count; ++k) below[i].push_back(tree.items[node.first + k]);
    for (Index k = 0; k < node.child_count; ++k)
      below[i].insert(below[i].end(), below[node.first + k].begin(), below[node.first + k].end());
  }
  return below;
}

TEST(LectureQuestion, AVolumeNeedNotContainThatOfAChildAndNothingIsLost) {
  const std::vector<Triangle> a = triangles_of(icosphere_mesh(1, 2));
  const std::vector<Triangle> b = triangles_of(icosphere_mesh(1, 2), {1.5, 0.25, 0.125});
  const auto tree = build_bvh<Ball>(a, {.method = BvhMethod::median});
  std::size_t reach_out = 0;
  for (const BvhNode<Ball>& node : tree.nodes)
    for (Index k = 0; k < node.child_count; ++k) {
      const Ball& child = tree.nodes[node.first + k].volume;
      // By more than rounding: there are points of the child's ball outside of the parent's.
      if (length(child.centre - node.volume.centre) + child.radius > 1.001 * node.volume.radius) ++reach_out;
    }
  EXPECT_GT(reach_out, 10U);
  MeetingPairs question{&a, &b};
  walk_pair(tree, build_bvh<Ball>(b), question);
  std::sort(question.found.begin(), question.found.end());
  std::vector<ItemPair> expected;
  for (Index i = 0; i < a.size(); ++i)
    for (Index j = 0; j < b.size(); ++j)
      if (overlap(a[i], b[j])) expected.push_back({i, j});
  EXPECT_GT(expected.size(), 20U);
  EXPECT_EQ(question.found, expected);
}

TEST(LectureQuestion, SiblingsOverlapAndNoTriangleIsInBothOrCut) {
  const std::vector<Triangle> knot = triangles_of(generate_mesh("torus-knot", {{"around", 80}}));
  for (const BvhMethod method : {BvhMethod::mean, BvhMethod::median, BvhMethod::heuristic}) {
    const auto tree = build_bvh<Aabb>(knot, {.method = method});
    const auto below = items_below(tree);
    std::size_t overlapping = 0;
    for (const BvhNode<Aabb>& node : tree.nodes)
      if (!node.is_leaf()) overlapping += overlap(tree.nodes[node.first].volume, tree.nodes[node.first + 1].volume);
    EXPECT_GT(overlapping, tree.nodes.size() / 4);
    // The triangles of an inner node are those of its children, each in one.
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
      std::vector<Index> items = below[i];
      std::sort(items.begin(), items.end());
      EXPECT_EQ(std::adjacent_find(items.begin(), items.end()), items.end());
    }
    EXPECT_EQ(below[0].size(), knot.size());
  }
}

TEST(LectureQuestion, ALeafAgainstAnInnerNodeOpensTheInnerNode) {
  // One triangle against a row of eight, of which it meets the last: at every node the two children are compared with
  // the leaf, however large that is.
  std::vector<Triangle> row;
  for (int i = 0; i < 8; ++i) row.push_back({{Vec3{4. * i, 0, 0}, Vec3{4. * i + 1, 0, 0}, Vec3{4. * i, 1, 0}}});
  const std::vector<Triangle> one{{{Vec3{28.25, 0.25, -1}, Vec3{28.25, 0.25, 1}, Vec3{28.25, 100, 0}}}};
  const auto tree = build_bvh<Aabb>(row, {.method = BvhMethod::median});
  const auto leaf = build_bvh<Aabb>(one);
  MeetingPairs question{&row, &one};
  EXPECT_EQ(walk_pair(tree, leaf, question), (WalkCounts{0, 1 + 2 * 3, 1}));
  EXPECT_EQ(question.found, (std::vector<ItemPair>{{7, 0}}));
  MeetingPairs flipped{&one, &row};
  EXPECT_EQ(walk_pair(leaf, tree, flipped), (WalkCounts{0, 1 + 2 * 3, 1}));
  EXPECT_EQ(flipped.found, (std::vector<ItemPair>{{0, 7}}));
}

/// Pairs of triangles left by the volumes, and pairs that meet, of two balls that overlap.
struct Enumerated {
  std::size_t of_each, tested, meeting;
};

Enumerated enumerate(int subdivisions) {
  const std::vector<Triangle> a = triangles_of(icosphere_mesh(1, subdivisions));
  const std::vector<Triangle> b = triangles_of(icosphere_mesh(1, subdivisions), {1.25, 0.375, 0.1875});
  MeetingPairs question{&a, &b};
  const WalkCounts counts = walk_pair(build_bvh<Aabb>(a), build_bvh<Aabb>(b), question);
  return {a.size(), counts.items, question.found.size()};
}

TEST(LectureQuestion, OfModelsOfManyTrianglesFewPairsMeetAndAHierarchyNamesThem) {
  const Enumerated coarse = enumerate(3), fine = enumerate(5);
  EXPECT_EQ(fine.of_each, 20'480U);
  ASSERT_EQ(fine.of_each, 16 * coarse.of_each);
  // Pairs of triangles are 256 times as many; those that meet lie along a curve, which is cut four times as finely.
  const double growth = static_cast<double>(fine.meeting) / static_cast<double>(coarse.meeting);
  EXPECT_GT(growth, 3);
  EXPECT_LT(growth, 5);
  // And those that are looked at are some for each of them, not some for each triangle.
  EXPECT_LT(fine.tested, 10 * fine.meeting);
  EXPECT_LT(coarse.tested, 10 * coarse.meeting);
}

TEST(LectureQuestion, WhereAllPairsMeetAllOfThemAreEnumerated) {
  std::vector<Triangle> fan;
  for (int i = 0; i < 40; ++i) fan.push_back({{Vec3{0, 0, 0}, Vec3{1, 0.1 * i, 0}, Vec3{1, 0.1 * i, 1}}});
  MeetingPairs question{&fan, &fan};
  EXPECT_EQ(walk_pair(build_bvh<Aabb>(fan), build_bvh<Aabb>(fan), question).items, fan.size() * fan.size());
  EXPECT_EQ(question.found.size(), fan.size() * fan.size());
}

TEST(LectureQuestion, ALimitOnTheNumberEndsWhereOneOnTheSizeDoesNot) {
  // A large triangle, and many small ones below it: the box of all is that of the one, so that a recursion which stops
  // at the size of a triangle stops at the root. It stops there as well for triangles that coincide, however many.
  std::vector<Triangle> covered{{{Vec3{0, 0, 0}, Vec3{9, 0, 0}, Vec3{0, 9, 9}}}};
  for (int i = 0; i < 50; ++i) covered.push_back({{Vec3{1, 1, 1}, Vec3{2, 1, 1}, Vec3{1, 2, 1}}});
  const std::vector<Triangle> same(covered.begin() + 1, covered.end());
  EXPECT_EQ(fit<Aabb>(covered), fit<Aabb>(std::vector<Triangle>{covered[0]}));
  EXPECT_EQ(fit<Aabb>(same), fit<Aabb>(std::vector<Triangle>{same[0]}));
  for (const std::vector<Triangle>& triangles : {covered, same}) {
    const auto tree = build_bvh<Aabb>(triangles, {.leaf_size = 1});
    EXPECT_EQ(balance_of(tree).leaves, triangles.size());
    // A stop below the size of every triangle would never come: all boxes are as large, down to the leaves.
    for (const BvhNode<Aabb>& node : tree.nodes) EXPECT_TRUE(contains(node.volume, fit<Aabb>(std::vector{same[0]})));
  }
}

TEST(LectureQuestion, RegionsOfOneSizeHaveBoxesOfSeveral) {
  // Four quarters of the box of a knot; each triangle belongs to that of its centroid, and each box is fitted to them.
  const std::vector<Triangle> knot = triangles_of(generate_mesh("torus-knot", {{"around", 80}}), {0.125, 0.0625, 0});
  const Aabb all = fit<Aabb>(knot);
  const Vec3 centre = 0.5 * (all.lower + all.upper);
  std::array<std::vector<Triangle>, 4> quarter;
  for (const Triangle& t : knot) {
    const Vec3 centroid = (1.0 / 3) * ((t.vertex[0] + t.vertex[1]) + t.vertex[2]);
    quarter[(centroid.x < centre.x ? 0U : 1U) + (centroid.y < centre.y ? 0U : 2U)].push_back(t);
  }
  std::size_t reach_out = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    ASSERT_FALSE(quarter[i].empty());
    const Aabb box = fit<Aabb>(quarter[i]);
    EXPECT_TRUE(contains(all, box));
    EXPECT_NE(half_area(box), half_area(fit<Aabb>(quarter[(i + 1) % 4])));
    // A triangle across the cut is in one set, and the box of that set reaches into the next region.
    if ((i & 1) == 0 ? box.upper.x > centre.x : box.lower.x < centre.x) ++reach_out;
  }
  EXPECT_GT(reach_out, 0U);
}

TEST(LectureQuestion, TheCutIsThroughTheMeanAcrossTheDirectionOfGreatestVariance) {
  const std::vector<Triangle> knot = triangles_of(generate_mesh("torus-knot", {{"around", 80}}));
  const auto tree = build_bvh<Obb>(knot, {.method = BvhMethod::mean});
  const auto below = items_below(tree);
  // "Add them up": the means of both sides, each by its area, are that of the whole.
  const PrincipalAxes axes = principal_axes(knot);
  EXPECT_GE(axes.spread.x, axes.spread.y);
  std::size_t on_the_same_side = 0;
  const auto side = [&](Index item) {
    const Triangle& t = knot[item];
    return dot(axes.axes[0], (1.0 / 3) * ((t.vertex[0] + t.vertex[1]) + t.vertex[2]) - axes.mean) < 0;
  };
  const std::vector<Index>&first = below[tree.nodes[0].first], &second = below[tree.nodes[0].first + 1];
  const bool first_is_below = side(first[0]);
  for (const Index item : first) on_the_same_side += side(item) == first_is_below;
  for (const Index item : second) on_the_same_side += side(item) != first_is_below;
  EXPECT_EQ(on_the_same_side, knot.size());
}

template <class Volume>
WalkCounts counts_of(const std::vector<Triangle>& a, const std::vector<Triangle>& b) {
  MeetingPairs question{&a, &b};
  const WalkCounts counts = walk_pair(build_bvh<Volume>(a, {.method = BvhMethod::median}),
                                      build_bvh<Volume>(b, {.method = BvhMethod::median}), question);
  EXPECT_GT(question.found.size(), 10U);
  return counts;
}

TEST(LectureQuestion, TighterVolumesNeedFewerTestsAndLeaveFewerTriangles) {
  const TriangleMesh knot = generate_mesh("torus-knot", {{"around", 60}, {"sides", 6}});
  const std::vector<Triangle> a = triangles_of(knot);
  std::vector<Triangle> b = a;
  for (Triangle& t : b)
    for (Vec3& vertex : t.vertex) vertex = transform(Pose{rotation_about({0, 1, 0}, 30), {0.3, 0, 0}}, vertex);
  const std::array counts{counts_of<Cube>(a, b), counts_of<Aabb>(a, b), counts_of<Kdop<26>>(a, b),
                          counts_of<HullBound>(a, b)};
  for (std::size_t i = 1; i < counts.size(); ++i) {
    EXPECT_LT(counts[i].volume_tests, counts[i - 1].volume_tests) << i;
    EXPECT_LT(counts[i].items, counts[i - 1].items) << i;
  }
}

TEST(LectureQuestion, TheNearerTwoSurfacesTheMorePairsAreLookedAt) {
  // Shells around each other: nothing meets at any gap, and the answer is dearer the smaller it is.
  const std::vector<Triangle> inner = triangles_of(icosphere_mesh(1, 3));
  const auto tree = build_bvh<Aabb>(inner);
  std::size_t before = 0;
  std::vector<std::size_t> tests;
  for (const double gap : {0.5, 0.25, 0.1, 0.03, 0.01}) {
    const std::vector<Triangle> outer = triangles_of(icosphere_mesh(1 + gap, 3));
    MeetingPairs question{&inner, &outer};
    const WalkCounts counts = walk_pair(tree, build_bvh<Aabb>(outer), question);
    EXPECT_TRUE(question.found.empty());
    EXPECT_GT(counts.volume_tests, before);
    before = counts.volume_tests;
    tests.push_back(counts.volume_tests);
  }
  EXPECT_GT(tests.back(), inner.size());  // linear in the triangles: every leaf's box meets another
  EXPECT_GT(tests.back(), 5 * tests.front());
}

}  // namespace
}  // namespace toccata
