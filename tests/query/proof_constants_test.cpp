// Witnesses: with a constant that a proof rests on made a few times too small, these doubles give a false statement
// (docs/design/proof-constants.md).
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "narrow/near.hpp"
#include "oracle/rational.hpp"
#include "query/contacts/depth_cell.hpp"
#include "query/decomposition/cut_plane.hpp"
#include "query/decomposition/exact_polygon.hpp"
#include "query/decomposition/outermost_corners.hpp"
#include "query/decomposition/part_concavity.hpp"
#include "query/decomposition/solid_frame.hpp"
#include "query/inside/bounded_sum.hpp"
#include "query/inside/enclose.hpp"
#include "query/nearest/nearest_elements.hpp"
#include "query/penetration/separating_search.hpp"
#include "query/penetration/whole_bodies.hpp"
#include "query/posed_shape.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/query/faces_in_region.hpp"
#include "toccata/query/nearest.hpp"

namespace toccata {
namespace {

using oracle::exact;

constexpr double least_double = std::numeric_limits<double>::denorm_min();

// 1 + 2^-53 rounds to 1, and 2^-1080 to 0.
TEST(ProofConstants, ASumOfIntervalsContainsTheExactSum) {
  const Interval sum = Interval{1, 1} + Interval{0x1p-53, 0x1p-53};
  EXPECT_GE(exact(sum.upper), exact(1) + exact(0x1p-53));
}

TEST(ProofConstants, AProductOfIntervalsThatUnderflowsContainsTheExactProduct) {
  const Interval product = Interval{0x1p-540, 0x1p-540} * Interval{0x1p-540, 0x1p-540};
  EXPECT_GE(exact(product.upper), exact(0x1p-540) * exact(0x1p-540));
}

// The double nearest to 1/3 lies below it, and that nearest to 1/5 above it.
TEST(ProofConstants, AnEnclosedNumberLiesBetweenTheEnds) {
  EXPECT_GE(exact(enclose(Rational(1) / 3).upper) * exact(3), exact(1));
  EXPECT_LE(exact(enclose(Rational(1) / 5).lower) * exact(5), exact(1));
}

// 1 + 2^-60 rounds to 1.
TEST(ProofConstants, TheWorldBoxOfABallIsNotSmallerThanTheBall) {
  const PosedPolytope ball(Sphere(0x1p-60), {{}, {1, 1, 1}});
  EXPECT_GE(exact(world_box(ball).upper.x), exact(1) + exact(0x1p-60));
  EXPECT_LE(exact(world_box(ball).lower.x), exact(1) - exact(0x1p-60));
}

// The top of the solid is at the height 1, and the lower corners of the cell are 3 · 2^-54 farther below it than 1.5,
// which is what the differences of the coordinates round to.
TEST(ProofConstants, ACellsBoundsOfDistancesCoverTheirRounding) {
  const Model solid(box_mesh({3, 3, 2}, {0, 0, -1}));
  const PosedMesh mesh(solid, {});
  const DepthSide side(solid, {}, mesh, 1);
  const double half_height = 0.5 + 0x1p-53;
  DepthCell cell{
      .middle = {0, 0, -0x1p-54}, .corners = {}, .radius = 0.75, .axes = {Vec3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (unsigned i = 0; i < 8; ++i)
    cell.corners[i] = {(i & 1) != 0 ? 0.25 : -0.25, (i & 2) != 0 ? 0.25 : -0.25,
                       (i & 4) != 0 ? half_height : -half_height};
  SearchScratch scratch;
  const DepthSide::Place middle = side.at(cell.middle, scratch);
  const double slack = depth_slack * 3;
  DistanceBounds bounds = bounds_by_distance(side, middle, cell, slack);
  add_bound_by_height(side, middle, cell, {0, 0, 1}, slack, bounds);
  ASSERT_EQ(bounds.count, 2U);
  for (std::size_t k = 0; k < 4; ++k)
    for (const std::size_t bound : {0U, 1U})
      EXPECT_GE(exact(bounds.at_corners[bound][k]), exact(1.5) + 3 * exact(0x1p-54)) << bound;
}

TEST(ProofConstants, TheSideOfACuttingPlaneIsExact) {
  const Vec3 through{-0x1.be8f4817481cp-6, -0x1.e7a6b9ca0e33ap-1, 0x1.9cd280924d262p-1};
  const Vec3 normal{0x1.5e9940bd59efap-1, 0x1.2da6316f48f94p-1, -0x1.5d89902014af8p-3};
  const Vec3 point{-0x1.7632cdf6434b2p-2, -0x1.979ab9f638f06p-1, -0x1.62606d8ffb6p-7};
  const auto height = oracle::dot(exact(point) - exact(through), exact(normal));
  const Sign expected = height > 0 ? Sign::positive : height < 0 ? Sign::negative : Sign::zero;
  EXPECT_EQ(CutPlane({through, normal}).side(point), expected);
}

TEST(ProofConstants, TheLimitOfASearchIsAtLeastTheNextDouble) { EXPECT_GT(limit_from(least_double), least_double); }

TEST(ProofConstants, TheLowerEndOfAnIntervalIsAnotherDouble) { EXPECT_EQ(lower_from(least_double), 0); }

TEST(ProofConstants, TheLowerEndOfAnIntervalLeavesRoomForItsWidth) {
  EXPECT_LE(exact(lower_from(1)), exact(1) - exact(0.99e-12));
}

// A distance that is at most a number has an interval of this width, which may reach beyond the number.
TEST(ProofConstants, WhatIsALittleAboveLeavesRoomForAnInterval) {
  EXPECT_GE(exact(a_little_above(1)), exact(1) + exact(0.99e-12));
}

// 1 less the length of the point, which is no double.
TEST(ProofConstants, ADepthBelowARoundSurfaceIsRoundedUp) {
  const Vec3 point{0.125, 0.25, 0.375};
  const oracle::Rational left = exact(1) - exact(nearest_point(point, Model(Sphere(1)))->upper);
  ASSERT_GT(left, 0);
  EXPECT_LE(left * left, oracle::dot(exact(point), exact(point)));
}

TEST(ProofConstants, TheDoublesAroundANumberAreOnBothSides) {
  const RationalPoint point{Rational(1) / 3, Rational(1) / 5, Rational(0)};
  std::vector<Vec3> around;
  append_doubles_around(point, around);
  Aabb box;
  for (const Vec3& corner : around) box = merge(box, corner);
  EXPECT_TRUE(to_rational(box.lower.x) < point.x && point.x < to_rational(box.upper.x));
  EXPECT_TRUE(to_rational(box.lower.y) < point.y && point.y < to_rational(box.upper.y));
}

// The lower edge of a square is tilted by a last place, and its ends are rounded down by nearly half of one. The middle
// corner, which lies below the edge, is rounded up to half a last place above it.
TEST(ProofConstants, ACornerThatRoundingMovesInwardsIsKept) {
  const Rational place = to_rational(0x1p-52), left = 1 + place * 31 / 64, right = left + place;
  const RationalPoint below{Rational(1) / 2, left + place / 2 - to_rational(0x1p-70), 0};
  ExactPolygon polygon;
  for (const RationalPoint& corner :
       {RationalPoint{0, left, 0}, below, RationalPoint{1, right, 0}, RationalPoint{1, 2, 0}, RationalPoint{0, 2, 0}})
    polygon.corners.push_back({corner, 0});
  const CutPlane plane({{0, 0, 0}, {0, 0, 1}});
  const std::vector<RationalPoint> kept = outermost_corners({&polygon, 1}, {&plane, 1});
  EXPECT_TRUE(std::any_of(kept.begin(), kept.end(), [&](const RationalPoint& one) { return one.y == below.y; }));
}

// A ball around a point whose neighbouring doubles are all outside of it.
TEST(ProofConstants, ABallOfAFewLastPlacesHoldsNoCube) {
  const double beside = 1 + 0x1p-52;
  const Model model(TriangleMesh({{beside, 0, 0}, {2, 0, 0}, {2, 1, 0}}, {{0, 1, 2}}));
  EXPECT_TRUE(faces_in_region(Ball{{1, 0, 0}, 0x1.cp-53}, model).empty());
}

TEST(ProofConstants, TheWorldBoxOfAnEllipsoidHoldsIt) {
  const Vec3 half{0x1.8c22c2p+0, 0x1.f11caep+0, 1};
  const Mat3 turn{{Vec3{0.6, -0.8, 0}, Vec3{0.8, 0.6, 0}, Vec3{0, 0, 1}}};
  const Aabb box = world_box(PosedQuadric(Ellipsoid(half), {turn, {}}));
  for (const int axis : {0, 1}) {
    const oracle::Rational x = exact(turn[axis].x) * exact(half.x), y = exact(turn[axis].y) * exact(half.y);
    EXPECT_GE(exact(box.upper[axis]) * exact(box.upper[axis]), x * x + y * y);
  }
}

// The hull sticks out of the solid by one corner, and not by any when it is made smaller by 2^-30. How far that moves
// the corner, 2^-30 · √(1 + 2^-106), is more than the sum that it is bounded by, which is rounded down.
TEST(ProofConstants, TheConcavityOfAHullThatSticksOutALittleIsRoundedUp) {
  const Vec3 corner{1, 0x1p-53, 0}, y{0, 1, 0}, z{0, 0, 1};
  const Vec3 less = corner + 0x1p-30 * (-corner);
  const TriangleMesh mesh({less, -2.0 * corner, 2.0 * y, -2.0 * y, 2.0 * z, -2.0 * z},
                          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}});
  const Model solid(mesh);
  const SolidFrame frame(inspect(mesh));
  const ConvexHull hull({corner, -corner, y, -y, z, -z});
  const double upper = ConcaveSolid(solid, frame).concavity_of(hull, 0, {}).upper;
  ASSERT_LT(upper, 0x1.1p-30);
  const auto way = exact(corner) - exact(less);
  EXPECT_GE(exact(upper) * exact(upper), oracle::dot(way, way));
}

// A corner sticks out of the solid by a little more than 2^-10, which is lost in the frame of the solid, that counts
// from its middle.
TEST(ProofConstants, TheConcavityOfACornerThatIsRoundedInTheFrameIsNotLess) {
  const double out = 0x1p-10 + 0x1p-53, y = 0.25, z = 0.125;
  const ConvexHull hull(std::vector<Vec3>{{-out, y, z},
                                          {0x1p-10, y + 0x1p-10, z},
                                          {0x1p-10, y - 0x1p-10, z + 0x1p-10},
                                          {0x1p-10, y - 0x1p-10, z - 0x1p-10}});
  const TriangleMesh mesh = box_mesh({1, 1, 1}, {1, 0, 0});
  const Model solid(mesh);
  const SolidFrame frame(inspect(mesh));
  const double upper = ConcaveSolid(solid, frame).concavity_of(hull, 0, {}).upper;
  ASSERT_LT(upper, 0x1.001p-10);
  EXPECT_GE(exact(upper), exact(out));
}

// 1 + 2^-53 rounds to 1.
TEST(ProofConstants, ABoundedSumCoversTheRoundingOfItsValue) {
  BoundedSum sum;
  sum.add(1, 0);
  sum.add(0x1p-53, 0);
  EXPECT_GE(exact(sum.value()) + exact(sum.bound()), exact(1) + exact(0x1p-53));
}

// A million bounds, each less than half a last place of their sum.
TEST(ProofConstants, ABoundedSumCoversTheRoundingOfItsBounds) {
  constexpr int count = 1 << 20;
  BoundedSum sum;
  sum.add(0, 1);
  for (int i = 0; i < count; ++i) sum.add(0, 0x1p-54);
  EXPECT_GE(exact(sum.bound()), 1 + count * exact(0x1p-54));
}

ConvexHull octahedron_around(const Vec3& c) {
  return ConvexHull({c + Vec3{1, 0, 0}, c - Vec3{1, 0, 0}, c + Vec3{0, 1, 0}, c - Vec3{0, 1, 0}, c + Vec3{0, 0, 1},
                     c - Vec3{0, 0, 1}});
}

// Two octahedra that touch. The translation parts them, but adding it changes no coordinate.
TEST(ProofConstants, ATranslationThatRoundingTakesForNoneIsNotCovered) {
  const InnerPart a(octahedron_around({4, 4, 4})), b(octahedron_around({5, 5, 4}));
  SeparatingCover cover(24);
  cover.add({&a, &b});
  EXPECT_FALSE(cover.covers({{0x1p-60, 0x1p-60, 0}, 0}));
}

// Up to 1.5 only rounding is told to part the two boxes, whose coordinates are at most 2.
TEST(ProofConstants, ATranslationAfterWhichOnlyRoundingPartsIsNotTaken) {
  const Model box(Box({1, 1, 1}));
  const PosedModel a = pose_model(box, {}, Solid::automatic, "a"),
                   b = pose_model(box, Pose::translation(1, 0, 0), Solid::automatic, "b");
  WholeBodies wholes;
  SolidBody body_a(a, wholes), body_b(b, wholes);
  const SeparatingQuestions questions{[](const Vec3& move) { return dot(move, move) < 2.25 ? 0x1p-50 : 1.0; },
                                      [](const Vec3&) { return std::vector<SurfaceIntersection>(); }};
  const DepthLimit limit(DepthOptions{});
  SeparatingSearch search(body_a, body_b, questions, limit);
  EXPECT_GE(search.answer({.upper = infinity}).upper, 1.5);
}

}  // namespace
}  // namespace toccata
