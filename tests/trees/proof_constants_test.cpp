// Witnesses: with a constant that a proof rests on made a few times too small, these doubles give a false statement
// (docs/design/proof-constants.md).
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "oracle/rational.hpp"
#include "trees/leaf_triangles.hpp"
#include "trees/oriented_boxes.hpp"
#include "trees/wide_boxes.hpp"
#include "trees/wide_check.hpp"
#include "trees/wide_frame.hpp"
#include "trees/wide_walk.hpp"
#include "trees/winding_moments.hpp"

namespace toccata::test {
namespace {

using oracle::exact;
using oracle::Rational;

Aabb box_up_to(double x) { return {{0, 0, 0}, {x, 0, 0}}; }

// The float nearest to 0.7 lies below it.
TEST(ProofConstants, ABoxInAFrameReachesToTheFloatBeyond) {
  const FloatBox box = to_frame({{0, 0, 0}, 1, 1}, box_up_to(0.7));
  EXPECT_GE(exact(double{box.upper[0]}), exact(0.7));
}

TEST(ProofConstants, ABoxInAFrameReachesBeyondWhatIsBelowTheLeastFloat) {
  const FloatBox box = to_frame({{0, 0, 0}, 1, 1}, box_up_to(1e-46));
  EXPECT_GE(exact(double{box.upper[0]}), exact(1e-46));
}

// The middle of -1 and 2^-25 is rounded to -1/2, and the way from it to 2^-25 to 1/2.
TEST(ProofConstants, TheExtentOfALaneIsRoundedUp) {
  WideBlock block{};
  set_box(block, 0, {Float4{-1, 0, 0, 0}, Float4{0x1p-25F, 0, 0, 0}});
  EXPECT_GE(exact(double{block.centre[0][0]}) + exact(double{block.extent[0][0]}), exact(0x1p-25));
}

WideBvh tree_of_one_lane(double origin, float centre, float extent) {
  WideBvh tree;
  tree.origin = {origin, 0, 0};
  tree.blocks.push_back({});
  tree.blocks[0].centre[0][0] = centre;
  tree.blocks[0].extent[0][0] = extent;
  return tree;
}

// 1 + 2^-54 rounds to 1, and less the origin it is 0.
TEST(ProofConstants, TheBoxOfALaneCoversTheSumOfCentreAndExtent) {
  EXPECT_GE(exact(box_of(tree_of_one_lane(-1, 1, 0x1p-54F), 0, 0).upper.x), exact(0x1p-54));
}

TEST(ProofConstants, TheBoxOfALaneCoversTheSumWithTheOrigin) {
  EXPECT_GE(exact(box_of(tree_of_one_lane(1, 0, 0x1p-60F), 0, 0).upper.x), exact(1) + exact(0x1p-60));
}

/// By how much the first corner's x of the only triangle, in the tree's units, is off.
Rational off_in_x(const WideBvh& tree, const TriangleMesh& mesh, const LeafTriangles& leaves) {
  const Rational seen = exact(double{leaves.of_block[0].corner[0][0][0]});
  return abs((exact(mesh.vertices()[mesh.triangles()[0][0]].x) - exact(tree.origin.x)) / exact(tree.unit) - seen);
}

// Halfway between two floats.
TEST(ProofConstants, CornersAsFloatsAreOffByHalfAStepNearOne) {
  const double x = 0.75 + 0x1p-25;
  const TriangleMesh mesh({{x, 0, 0}, {-x, 0, 0}, {0, 0.5, 0}}, {{0, 1, 2}});
  const WideBvh tree = build_wide_bvh(std::vector<Aabb>{{{-x, 0, 0}, {x, 0.5, 0}}});
  ASSERT_EQ(tree.unit, 1);
  const LeafTriangles leaves = leaf_triangles(tree, mesh);
  EXPECT_LE(off_in_x(tree, mesh, leaves), exact(double{leaves.off}));
}

TEST(ProofConstants, CornersAsFloatsAreOffByHalfAStepBeyondOne) {
  const double x = (1.5 + 0x1p-24) * 0x1p1023;
  const TriangleMesh mesh({{x, 0, 0}, {-x, 0, 0}, {0, 0.5, 0}}, {{0, 1, 2}});
  const WideBvh tree = build_wide_bvh(std::vector<Aabb>{{{-x, 0, 0}, {x, 0.5, 0}}});
  ASSERT_EQ(tree.unit, 0x1p1023);
  const LeafTriangles leaves = leaf_triangles(tree, mesh);
  EXPECT_LE(off_in_x(tree, mesh, leaves), exact(double{leaves.off}));
}

// Twice the area is 2^-54, the difference of two products that round to the same double. Seen from so far above that
// only the rounding share remains of the bound. The exact part is at least area · height / (4π · distance³).
TEST(ProofConstants, TheRoundingShareOfWindingNumbersCoversACrossProductThatVanishes) {
  const double a = 1 + 0x1p-27, b = 1 + 0x1p-26;
  const TriangleMesh mesh({{0, 0, 0}, {a, 1, 0}, {b, a, 0}}, {{0, 1, 2}});
  const WideBvh tree = build_wide_bvh(std::vector<Aabb>{{{0, 0, 0}, {b, a, 0}}});
  ASSERT_EQ(tree.unit, 1);
  ASSERT_EQ(exact(a) * exact(a) - exact(b), exact(0x1p-54));
  const std::vector<WindingMoments> moments = winding_moments(tree, mesh);
  const double height = 16, distance = 17;
  const WindingPart part = winding_part(moments.at(0), {0, 0, -height}, 0);
  const double least = 0x1p-55 * height / (4 * std::numbers::pi * distance * distance * distance);
  EXPECT_GE(std::abs(part.value) + part.bound, least);
}

WindingMoments moments_of(const std::vector<Vec3>& corners, const Aabb& box) {
  return winding_moments(build_wide_bvh(std::vector<Aabb>{box}), TriangleMesh(corners, {{0, 1, 2}})).at(0);
}

// The product of two edges is rounded down.
TEST(ProofConstants, UpperBoundsOfASurfaceAreRoundedUp) {
  const double a = 1 + 0x1p-27;
  const WindingMoments moments = moments_of({{0, 0, 0}, {a, 0, 0}, {0, a, 0}}, {{0, 0, 0}, {a, a, 0}});
  EXPECT_GE(exact(moments.size), exact(a) * exact(a));
}

// As above, twice the area is 2^-54 and seems to be 0.
TEST(ProofConstants, TheAreaOfATriangleCoversACrossProductThatVanishes) {
  const double a = 1 + 0x1p-27, b = 1 + 0x1p-26;
  EXPECT_GE(exact(moments_of({{0, 0, 0}, {a, 1, 0}, {b, a, 0}}, {{0, 0, 0}, {b, a, 0}}).area), exact(0x1p-55));
}

// A triangle without extent, which is rounded where the origin is taken off it.
TEST(ProofConstants, TheRadiusOfASurfaceCoversTheRoundingOfCorners) {
  const TriangleMesh mesh({{0.75, 0, 0}, {0.75, 0, 0}, {0.75, 0, 0}}, {{0, 1, 2}});
  WideBvh tree = build_wide_bvh(std::vector<Aabb>{{{-0.75, -0.75, -0.75}, {0.75, 0.75, 0.75}}});
  ASSERT_EQ(tree.unit, 1);
  tree.origin = {0x1p-54 - 0x1p-100, 0, 0};
  const WindingMoments moments = winding_moments(tree, mesh).at(0);
  EXPECT_GE(exact(moments.radius), abs(exact(0.75) - exact(tree.origin.x) - exact(moments.centre.x)));
}

// A tree whose boxes reach a little beyond 1, as those of floats do.
TEST(ProofConstants, ATreeMayReachALittleBeyondItsUnit) {
  const double most = 1 - 0x1p-53;
  const std::vector<Aabb> boxes{{{-most, -most, -most}, {most, most, most}}};
  const WideBvh tree = build_wide_bvh(boxes);
  ASSERT_EQ(tree.unit, 1);
  ASSERT_GT(tree.blocks.at(0).centre[0][0] + tree.blocks.at(0).extent[0][0], 1);
  EXPECT_EQ(fault_of(tree, boxes), "");
}

/// Whether the point is centre + Σ αₖ axisₖ with |αₖ| at most extentₖ, for the box in the first lane.
bool holds(const OrientedBlock& block, const oracle::RationalPoint& point) {
  const auto first_lane = [](const auto& lanes) { return Vec3{lanes[0][0], lanes[1][0], lanes[2][0]}; };
  const Vec3 first = first_lane(block.axis[0]), second = first_lane(block.axis[1]);
  const auto u = exact(first), v = exact(second), w = exact(cross(first, second));
  const auto from_centre = point - exact(first_lane(block.centre));
  const Rational volume = abs(oracle::dot(u, oracle::cross(v, w)));
  const auto is_within = [&](const oracle::RationalPoint& p, const oracle::RationalPoint& q, std::size_t axis) {
    return abs(oracle::dot(from_centre, oracle::cross(p, q))) <= exact(double{block.extent[axis][0]}) * volume;
  };
  return is_within(v, w, 0) && is_within(w, u, 1) && is_within(u, v, 2);
}

// As floats its two axes are not quite at right angles, so that along the needle they go apart.
TEST(ProofConstants, ABoxAroundANeedleHoldsItsCorners) {
  const Vec3 end{0x1.300b214093e52p-2, 0x1.9db1be6db9edbp-2, -0x1.f305955f94767p-4};
  const TriangleMesh needle({end, -end, {0, 0, 0}}, {{0, 1, 2}});
  const WideBvh tree = build_wide_bvh(std::vector<Aabb>{merge(Aabb{end, end}, -end)});
  ASSERT_EQ(tree.origin, Vec3{});
  const OrientedBlock block = oriented_boxes(tree, needle).at(0);
  EXPECT_TRUE(holds(block, exact((1 / tree.unit) * end)));
  EXPECT_TRUE(holds(block, exact((-1 / tree.unit) * end)));
}

/// Collects nothing but how many pairs a walk finds.
class PairCounter final : public WideVisitor {
 public:
  bool visit(std::span<const ItemPair> pairs) override {
    count += pairs.size();
    return true;
  }
  std::size_t count = 0;
};

// One box along an axis, and a point within it: 1.75 - extent < at. As a float, `at` is 2^-24 less, so that the
// distance from 1.75 is computed as 1/4, more than the extent.
TEST(ProofConstants, TheSlackOfTheWideWalkCoversTheRoundingOfAMiddle) {
  const double at = 1.5 + 0x1p-24 - 0x1p-40, extent = 0.25 - 0x1p-24 + 0x1p-26;
  ASSERT_LT(exact(1.75) - exact(extent), exact(at));
  WideBvh a = build_wide_bvh(std::vector<Aabb>(1, {{-1, -1, -1}, {1, 1, 1}})), b = a;
  a.blocks.at(0).centre[0][0] = 1.75F;
  a.blocks.at(0).extent[0][0] = static_cast<float>(extent);
  b.blocks.at(0).centre[0][0] = 0;
  b.blocks.at(0).extent[0][0] = 0;
  WideCull cull;
  for (WideAxes* axes : {&cull.of_a, &cull.of_b})
    for (std::size_t i = 0; i < WideAxes::straight; ++i) axes->pad[i] = std::numeric_limits<float>::infinity();
  for (auto [axes, offset] : {std::pair{&cull.of_a, at}, {&cull.of_b, -at}}) {
    axes->pad[0] = 0;
    axes->own_size[0] = 2;
    axes->other[0][0] = 1;
    axes->other_size[0][0] = 1;
    axes->offset[0] = offset;
  }
  const WideWalk walk(a, b, cull);
  WideFrontier frontier;
  PairCounter found;
  walk.start(frontier, 1);
  walk.run(frontier, found);
  EXPECT_EQ(found.count, 1);
}

}  // namespace
}  // namespace toccata::test
