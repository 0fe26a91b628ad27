// Witnesses as in proof_constants_test.cpp, for walks over trees and what they compare boxes with.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "oracle/rational.hpp"
#include "trees/gap_planes.hpp"
#include "trees/leaf_triangles.hpp"
#include "trees/near_front.hpp"
#include "trees/near_walk.hpp"
#include "trees/rays_into_tree.hpp"
#include "trees/swept_walk.hpp"
#include "trees/wide_boxes.hpp"
#include "trees/wide_point.hpp"
#include "trees/wide_ray.hpp"

namespace toccata::test {
namespace {

using oracle::exact;
using oracle::Rational;

WideBvh tree_of_one_box(const std::array<float, 3>& centre, const std::array<float, 3>& extent) {
  WideBvh tree = build_wide_bvh(std::vector<Aabb>(1, {{-1, -1, -1}, {1, 1, 1}}));
  for (std::size_t i = 0; i < 3; ++i) {
    tree.blocks.at(0).centre[i][0] = centre[i];
    tree.blocks.at(0).extent[i][0] = extent[i];
  }
  return tree;
}

// The point is within the box. As a float every coordinate is 2^-24 less, and seems to be outside.
TEST(ProofConstants, TheWalkFromAPointCoversTheRoundingOfTheGaps) {
  const double at = 1.5 + 0x1p-24 - 0x1p-40;
  const float extent = 0.25F - 0x1p-24F + 0x1p-26F;
  ASSERT_LT(exact(1.75) - exact(double{extent}), exact(at));
  const WideBvh tree = tree_of_one_box({1.75F, 1.75F, 1.75F}, {extent, extent, extent});
  std::size_t count = 0;
  walk_point(tree, {{at, at, at}, 0}, 0, [&](std::span<const Index> places) {
    count += places.size();
    return 0.0;
  });
  EXPECT_EQ(count, 1);
}

constexpr double greatest_float_below_one = 1 - 0x1p-24;

/// What is told to be no nearer than the nearest of triangles that are single points, one at the given place, in a tree
/// of units of 1 from the origin.
float upper_end_of_points(double x, const WidePoint& point) {
  constexpr double most = greatest_float_below_one;
  const std::vector<Vec3> points{{x, x, x}, {most, most, most}, {-most, -most, -most}};
  const TriangleMesh mesh(points, {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}});
  const WideBvh tree =
      build_wide_bvh(std::vector<Aabb>{{points[0], points[0]}, {points[1], points[1]}, {points[2], points[2]}});
  EXPECT_EQ(tree.unit, 1);
  NearTriangles::Memory memory;
  NearTriangles near(1, HUGE_VALF, memory);
  find_near(tree, leaf_triangles(tree, mesh), point, near);
  return near.limit();
}

// As a float the point is at 1, half as far from the corner.
TEST(ProofConstants, DistancesInFloatsCoverTheRoundingOfThePoint) {
  const double corner = greatest_float_below_one, at = 1 + 0x1p-24 - 0x1p-40;
  const Rational upper = exact(double{upper_end_of_points(corner, {{at, at, at}, 0})});
  const Rational apart = exact(at) - exact(corner);
  EXPECT_GE(upper * upper, 3 * apart * apart);
}

// The corner may be as far from the point as all that is off, which lies between 1 and the middle to the next float.
TEST(ProofConstants, WhatDistancesInFloatsAreOffByIsRoundedUp) {
  const double of_leaves = 2 * double{0x1.00001p-25F}, pad = (1 + 0x1p-25) - 0x1p-30 - of_leaves;
  EXPECT_GE(exact(double{upper_end_of_points(0, {{0, 0, 0}, pad})}), exact(pad) + exact(0.875 * of_leaves));
}

// A corner given as floats, of which the length is rounded down.
TEST(ProofConstants, DistancesInFloatsCoverTheRoundingOfALength) {
  const Vec3 corner{-0x1.998d6p-2, -0x1.6921b4p-1, -0x1.d37772p-4};
  const double most = greatest_float_below_one;
  const std::vector<Vec3> points{corner, {most, most, most}, {-most, -most, -most}};
  const WideBvh tree =
      build_wide_bvh(std::vector<Aabb>{{points[0], points[0]}, {points[1], points[1]}, {points[2], points[2]}});
  LeafTriangles leaves = leaf_triangles(tree, TriangleMesh(points, {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}));
  leaves.off = 0;
  NearTriangles::Memory memory;
  NearTriangles near(1, HUGE_VALF, memory);
  find_near(tree, leaves, {{0, 0, 0}, 0}, near);
  const Rational upper = exact(double{near.limit()});
  EXPECT_GE(upper * upper, oracle::dot(exact(corner), exact(corner)));
}

/// A box of a tree of its own, as one of two that are compared.
struct OneNearBox {
  explicit OneNearBox(const OrientedBox& box) {
    block.count = 1;
    for (std::size_t lane = 0; lane < OrientedBlock::width; ++lane)
      set_lane(block, lane, lane == 0 ? box : OrientedBox{});
    block.child.fill(~0);
  }
  [[nodiscard]] NearBvh tree() const { return {{&block, 1}, {&item, 1}}; }
  OrientedBlock block{};
  Index item = 0;
};

NearView moved_by(const Vec3& offset) {
  NearView view;
  view.offset = offset;
  return view;
}

NearWalk walk_of(const OneNearBox& a, const OneNearBox& b, const Vec3& b_from_a) {
  return {a.tree(), b.tree(), moved_by(b_from_a), moved_by(-b_from_a)};
}

Rational square_of(const Vec3& v) { return oracle::dot(exact(v), exact(v)); }

// A direction, and floats that are longer than 1 by 0.8 · 2^-24 in it.
const Vec3 along{0x1.8c22c2p+0, 0x1.f11caep+0, 0x1.bdbf5ep+0};
constexpr std::array<float, 3> longer_than_one{0x1.053f2cp-1F, 0x1.47d6e2p-1F, 0x1.25f712p-1F};

// Two points, of which the first is taken for a box along axes of which one is too long.
TEST(ProofConstants, BoundsOfTurnedBoxesCoverThatAxesAreNotOfLengthOne) {
  const float length = std::hypot(longer_than_one[0], longer_than_one[1]);
  const OneNearBox a({{}, {longer_than_one, {-longer_than_one[1] / length, longer_than_one[0] / length, 0}}, {}}),
      b({});
  const Rational least = exact(walk_of(a, b, along).bounds(0, 0, 0).least[0]);
  EXPECT_LE(least * least, square_of(along));
}

/// Counts what it is shown.
class ShownPairs final : public FrontQuestion {
 public:
  explicit ShownPairs(double limit) : limit_(limit) {}
  [[nodiscard]] double limit() const override { return limit_; }
  void visit(std::span<const ItemPair> pairs, std::span<FrontGap> /*gaps*/) override { count += pairs.size(); }
  std::size_t count = 0;

 private:
  double limit_;
};

// Two points that are as far apart as the limit. Along the direction as floats they seem to be farther.
TEST(ProofConstants, TheLimitOfAFrontCoversThatDirectionsAreNotOfLengthOne) {
  const OneNearBox a({}), b({});
  const double distance = std::nextafter(std::sqrt(dot(along, along)), HUGE_VAL);
  ASSERT_GE(exact(distance) * exact(distance), square_of(along));
  ShownPairs shown(distance);
  NearFront front;
  front.make(walk_of(a, b, along), shown);
  EXPECT_EQ(shown.count, 1);
}

// The first box reaches to 1 + 2^-25, which the nearest float is less than.
TEST(ProofConstants, APlaneBetweenBoxesIsRoundedUp) {
  const OneNearBox a({{1, 0, 0}, {{{1, 0, 0}, {0, 1, 0}}}, {0x1p-25F, 0, 0}}), b({});
  GapPlaneLanes planes{};
  part_boxes(walk_of(a, b, {10, 0, 0}), std::vector<BoxPair>{{0, 0}}, planes);
  ASSERT_EQ(planes.normal[0][0], 1);
  EXPECT_GE(exact(double{planes.reach[0]}), exact(1) + exact(0x1p-25));
}

// The offset is rounded up as a float.
TEST(ProofConstants, TheBoundOfAPlaneCoversTheRoundingOfItsView) {
  GapPlanes planes;
  planes.set(planes.add(), {{1, 0, 0}, {1, 0, 0}, {0, 0, 0}, 0, 0});
  const double offset = 0x1p20 * (1 + 0x1p-24 + 0x1p-40);
  std::vector<GapPlanes::Near> near;
  planes.find_near(moved_by({offset, 0, 0}), 2 * offset, near);
  ASSERT_EQ(near.size(), 1);
  EXPECT_LE(exact(double{near[0].least}), exact(offset));
}

/// Three points at 1/16, 1/2 and 1/8 from another; the last one makes the limit 1/2.
class LoweredLimit final : public NearQuestion {
 public:
  [[nodiscard]] double limit() const override { return limit_; }
  void visit(std::span<const ItemPair> pairs) override {
    for (const ItemPair& pair : pairs) {
      seen.push_back(pair.first);
      if (pair.first == 2) limit_ = 0.5;
    }
  }
  std::vector<Index> seen;

 private:
  double limit_ = 3;
};

// The bound of the second point is kept as a part of the first limit, 3, and 1/6 is rounded up as a float.
TEST(ProofConstants, TheLimitOfANearWalkCoversTheRoundingOfBounds) {
  OneNearBox a({}), b({});
  const std::vector<Index> items{0, 1, 2};
  a.block.count = 3;
  for (const auto& [lane, distance] : {std::pair{0, 0.0625F}, {1, 0.5F}, {2, 0.125F}}) {
    set_lane(a.block, static_cast<std::size_t>(lane), {{1 - distance, 0, 0}});
    a.block.child[static_cast<std::size_t>(lane)] = ~lane;
  }
  const NearWalk walk({{&a.block, 1}, items}, b.tree(), moved_by({1, 0, 0}), moved_by({-1, 0, 0}));
  NearFrontier frontier;
  LoweredLimit question;
  walk.run(frontier, question);
  EXPECT_NE(std::find(question.seen.begin(), question.seen.end(), 1), question.seen.end());
}

// A point at the height 11/16 that one which rises by 91/16 reaches at 11/91, by a product with a rounded reciprocal.
TEST(ProofConstants, TimesOfASweptWalkCoverTheRoundingOfAQuotient) {
  const WideBvh tree = tree_of_one_box({0.6875F, 0, 0}, {0, 0, 0});
  SweptDirection direction;
  direction.form[1] = {1, 0, 0};
  direction.per_speed = 16.0 / 91;
  double limit = 11.0 / 91;
  if (exact(limit) * 91 < 11) limit = std::nextafter(limit, 1);
  std::size_t count = 0;
  SweptFrontier frontier;
  SweptWalk({nullptr, &tree}, {&direction, 1}).run(frontier, limit, [&](ItemPair) {
    ++count;
    return limit;
  });
  EXPECT_EQ(count, 1);
}

// Along the upper side of a box, which it must not seem to leave.
TEST(ProofConstants, ARayThatStandsStillAlongAnAxisHardlyMovesInTheWalk) {
  const WideBvh tree = tree_of_one_box({0.5F, -0.0625F, 0}, {0.125F, 0.0625F, 0.125F});
  const WideRay ray{.origin = {0, 0, 0}, .motion = {1, 0, 0}, .pad = 0x1p-20F};
  std::size_t count = 0;
  walk_rays(tree, nullptr, {&ray, 1}, [&](std::size_t, std::span<const RayCandidate> candidates, bool) {
    count += candidates.size();
    return 1.0F;
  });
  EXPECT_EQ(count, 1);
}

/// The frame of a pose that changes nothing, and a tree within ±2.
RayFrame frame_of_nothing() { return {.back = Mat3{}, .offset = {}, .origin = {}, .box = {{-2, -2, -2}, {2, 2, 2}}}; }

/// By itself, and as one of many.
std::array<RayInTree, 2> brought(const RayFrame& frame, const Vec3& from, const Vec3& motion) {
  const PreparedRay ray(from, motion);
  std::array<RayInTree, 2> ways{ray_into_tree(frame, ray), {}};
  rays_into_tree(frame, {&ray, 1}, {&ways[1], 1});
  return ways;
}

// It enters at 3/20, by a product with a rounded reciprocal.
TEST(ProofConstants, TheTimeAtWhichARayEntersATreeIsNotTooLate) {
  for (const RayInTree& way : brought(frame_of_nothing(), {-2 - 0x3p16, 0, 0}, {0x5p18, 0, 0}))
    EXPECT_LE(exact(way.from) * 20, 3);
}

// The side of the box less what a point is off by is rounded to the side, a last place before which the ray begins.
TEST(ProofConstants, TheSideOfATreeThatARayEntersIsFarEnoughOut) {
  const double side = 0.75, off = 0.4375 * 0x1p-53;
  RayFrame frame = frame_of_nothing();
  frame.box.lower.x = side;
  frame.off = off;
  for (const RayInTree& way : brought(frame, {std::nextafter(side, 0), 0, 0}, {1, 0, 0}))
    EXPECT_LE(exact(way.from), (exact(side) - exact(off)) - exact(std::nextafter(side, 0)));
}

TEST(ProofConstants, TheLeanOfARayIsRoundedUp) {
  RayFrame frame = frame_of_nothing();
  frame.off_by_size = 0x1p-12 * (1 + 0x1p-25);
  for (const RayInTree& way : brought(frame, {0, 0, 0}, {1, 0, 0}))
    EXPECT_GE(exact(double{way.ray.lean}), exact(frame.off_by_size));
}

// Origin and motion are rounded the same way.
TEST(ProofConstants, ThePadOfARayCoversThatItsNumbersAreFloats) {
  const double from = -(1 + 0x1p-24 - 0x1p-50), motion = 2 + 0x1p-22 - 0x1p-23 + 0x1p-50;
  for (const RayInTree& way : brought(frame_of_nothing(), {from, 0, 0}, {motion, 0, 0})) {
    ASSERT_EQ(way.from, 0);
    ASSERT_EQ(way.to, 1);
    const Rational end = exact(double{way.ray.origin[0]}) + exact(double{way.ray.motion[0]});
    EXPECT_LE(abs(end - (exact(from) + exact(motion))), exact(double{way.ray.pad}));
  }
}

}  // namespace
}  // namespace toccata::test
