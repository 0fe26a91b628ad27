// Witnesses: with a constant that a proof rests on made a few times too small, these doubles give a false statement
// (docs/design/proof-constants.md).
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "narrow/boxes/box_axes.hpp"
#include "narrow/convex/convex_containment.hpp"
#include "narrow/convex/core_distance.hpp"
#include "narrow/convex/core_separation.hpp"
#include "narrow/convex/difference_body.hpp"
#include "narrow/convex/gjk.hpp"
#include "narrow/convex/polyhedron_axes.hpp"
#include "narrow/convex_distance_checks.hpp"
#include "narrow/exact/exact_support.hpp"
#include "narrow/half_spaces/half_space_heights.hpp"
#include "narrow/pose_checks.hpp"
#include "narrow/primitives/nearness.hpp"
#include "narrow/triangles/point_triangles.hpp"
#include "narrow/triangles/ray_triangle.hpp"
#include "narrow/triangles/solid_angle.hpp"
#include "narrow/triangles/triangle_gaps.hpp"
#include "oracle/convex.hpp"
#include "oracle/penetration.hpp"
#include "oracle/rational.hpp"
#include "oracle/rays.hpp"
#include "oracle/winding.hpp"
#include "toccata/core/error.hpp"
#include "toccata/methods/sphere_ways.hpp"
#include "toccata/narrow/box_box.hpp"
#include "toccata/narrow/convex_convex.hpp"
#include "toccata/narrow/primitives.hpp"

namespace toccata {
namespace {

using oracle::exact;

// The corner lies beyond the radius by so little that the squares round to the wrong order.
TEST(ProofConstants, ASphereAlmostAtACornerIsDecidedExactly) {
  const Vec3 centre{0x1.a94a22aa2cf6p+0, 0x1.54ac0c972ea43p+0, 0x1.1cf51ecd60fc3p+0};
  const Vec3 corner{0x1.debcdcc908c0fp-11, -0x1.f828c710c9b37p-11, -0x1.5049f600796d3p-11};
  const double radius = 0x1.337c9351083dbp+1;
  const auto way = exact(centre) - exact(corner);
  ASSERT_GT(oracle::dot(way, way), exact(radius) * exact(radius));
  const PosedSphere sphere(Sphere(radius), {{}, centre});
  EXPECT_FALSE(overlap_by_regions(sphere, {-4, -4, -4}, corner));
  EXPECT_FALSE(overlap_by_clamping(sphere, {-4, -4, -4}, corner));
}

oracle::ConvexSet world_set(const Box& box, const Pose& pose) {
  std::array<Vec3, 8> corners;
  for (int i = 0; i < 8; ++i) corners[static_cast<std::size_t>(i)] = oracle::world_vertex(pose, box.corner(i));
  return oracle::box_set(corners);
}

oracle::ConvexSet world_set(const Capsule& capsule, const Pose& pose) {
  return oracle::capsule_set(oracle::world_vertex(pose, capsule.start()), oracle::world_vertex(pose, capsule.end()),
                             capsule.radius());
}

oracle::ConvexSet world_set(const Sphere& sphere, const Pose& pose) {
  return oracle::sphere_set(oracle::world_vertex(pose, sphere.centre()), sphere.radius());
}

void expect_overlap_of_the_oracle(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b) {
  const bool expected = oracle::overlap(world_set(a, pose_a), world_set(b, pose_b));
  EXPECT_EQ(overlap(PosedBox(a, pose_a), PosedBox(b, pose_b)), expected);
  EXPECT_EQ(overlap(a, pose_a, b, pose_b), expected);
  EXPECT_EQ(overlap(PosedPolytope(a, pose_a), PosedPolytope(b, pose_b)), expected);
}

void expect_overlap_of_the_oracle(const Sphere& a, const Pose& pose_a, const Box& b, const Pose& pose_b) {
  const bool expected = oracle::overlap(world_set(a, pose_a), world_set(b, pose_b));
  EXPECT_EQ(overlap(PosedSphere(a, pose_a), PosedBox(b, pose_b)), expected);
  EXPECT_EQ(overlap(a, pose_a, b, pose_b), expected);
}

// Far from the origin, where rounding bends boxes: the corners are not where the formulas have them.
const Mat3 far_turn_a{{Vec3{-0x1.1e79a2bd55fecp-2, 0x1.3563835341937p-3, 0x1.e56ea4154884p-1},
                       Vec3{-0x1.df7faf5c29e1bp-1, 0x1.6541239cb2ce8p-3, -0x1.376f7922e4cf9p-2},
                       Vec3{-0x1.b0d00efddfdd8p-3, -0x1.f22e621653011p-1, 0x1.7b9b40ae2bec8p-4}}};
const Mat3 far_turn_b{{Vec3{-0x1.f00becd2b0f68p-2, 0x1.405cc2488ee1fp-2, -0x1.a24b70314dc87p-1},
                       Vec3{0x1.bdfee32135c49p-1, 0x1.60bd37b802898p-4, -0x1.ef2090c83b404p-2},
                       Vec3{-0x1.4b6da8f115d65p-4, -0x1.e44b931d8c938p-1, -0x1.41c80ba4c4748p-2}}};
const Pose far_pose_a{far_turn_a, {-0x1.8c99444c98ep+10, 0x1.e288a4c87421p+8, -0x1.ae88a6d1f00d4p+9}};
const Vec3 far_half_a{0x1.29edf59ed49c4p-2, 0x1.89076dde0e0e8p-4, 0x1.f9bc311566505p-4};

TEST(ProofConstants, CornersOfABoxFarAwayAreNotWhereTheFormulasHaveThem) {
  const Vec3 centre{-0x1.8c9dff8e0fe4fp+10, 0x1.e2f23ef9076d8p+8, -0x1.ae8f2a7bbdad6p+9};
  expect_overlap_of_the_oracle(Sphere(0x1.9d843a7290abdp-4), {far_turn_b, centre}, Box(far_half_a), far_pose_a);
}

TEST(ProofConstants, CornersOfTwoBoxesFarAwayAreNotWhereTheAxesHaveThem) {
  const Vec3 offset{-0x1.8ca58fa5852a2p+10, 0x1.e2e1a54546ac1p+8, -0x1.ae8e1fb11e0dap+9};
  const Box b({0x1.9d843a7290abdp-4, 0x1.abbc8923386d9p-5, 0x1.08eea434bdd8p-3});
  expect_overlap_of_the_oracle(Box(far_half_a), far_pose_a, b, {far_turn_b, offset});
}

TEST(ProofConstants, BentBoxesFarAwayAreNotParallelepipeds) {
  const Mat3 turn_a{{Vec3{0x1.35e41202c668ep-2, 0x1.a6043afa60a7dp-1, 0x1.ea0d8a98a9456p-2},
                     Vec3{-0x1.6cb34865d5c54p-4, 0x1.0c79933eaed84p-1, -0x1.b1931e30205cap-1},
                     Vec3{-0x1.e5db90d09e22bp-1, 0x1.b5948a940e1d3p-3, 0x1.db4b51efd60a4p-3}}};
  const Mat3 turn_b{{Vec3{-0x1.31bd640a3f99cp-2, -0x1.e0569bd3c5a26p-1, -0x1.66e284b483fddp-3},
                     Vec3{-0x1.71a5128161dc2p-1, 0x1.a1855240077bp-4, 0x1.5e67672345eb9p-1},
                     Vec3{-0x1.3f96ef3003d8p-1, 0x1.52cb31618daddp-2, -0x1.6a5e6e606b346p-1}}};
  const Vec3 offset_a{-0x1.5fffb7df8c87ap+9, -0x1.1faa823c434p+4, -0x1.c9c9c6f6e7818p+9};
  const Vec3 offset_b{-0x1.5fdcc0fa2800bp+9, -0x1.2f629935db264p+4, -0x1.ca2471381cdcbp+9};
  expect_overlap_of_the_oracle(
      Box({0x1.0310f57575e7ep-2, 0x1.4966992542f77p-4, 0x1.11accaaa98b95p-1}), {turn_a, offset_a},
      Box({0x1.62a3da2cec948p-1, 0x1.f462250ca6026p-3, 0x1.665a14f0138adp-4}), {turn_b, offset_b});
}

TEST(ProofConstants, ASphereSeenFromABoxIsNotExactlyWhereItIs) {
  const Mat3 turn{{Vec3{-0x1.b1b7fe1c2d03ap-1, 0x1.de0cc3acade97p-2, 0x1.03fe554a5db99p-2},
                   Vec3{0x1.022f60ae17408p-1, 0x1.b6bd945591e78p-1, 0x1.b589064a8f14cp-4},
                   Vec3{-0x1.57743a04e4ba5p-3, 0x1.bf883e9037718p-3, -0x1.ec3153fa895ep-1}}};
  const Vec3 centre{-0x1.0a7311263567ep-2, -0x1.0983612d1867ep-2, 0x1.f862eb1aaa41ep-3};
  const Box box({0x1.6c624bec6dd0ep-5, 0x1.0f6653eecafd9p-2, 0x1.3d09bbdc82585p-2});
  expect_overlap_of_the_oracle(Sphere(0x1.0bb165264de09p-5), {{}, centre}, box, {turn, {0, 0, 0}});
}

// Two thin capsules, the one as good as a point, almost in touch.
TEST(ProofConstants, NearPointsOfThinCapsulesAreRounded) {
  const Pose pose_a{{{Vec3{-0x1.11b9979f214c8p-3, 0x1.efea7eae8d239p-2, -0x1.bab1ab5f903bdp-1},
                      Vec3{-0x1.e16d7a0af8b1fp-1, 0x1.b57de855dc56cp-3, 0x1.0f5c0161c6effp-2},
                      Vec3{0x1.408d9ec77b83dp-2, 0x1.b264ef52f89f5p-1, 0x1.b5114ea699a42p-2}}},
                    {0, 0, 0}};
  const Pose pose_b{{{Vec3{0x1.a8c226500bdap-1, 0x1.0cf2bfdc298e5p-1, 0x1.83a1ba3f8b352p-3},
                      Vec3{0x1.1041e4e88eccep-1, -0x1.b180b03410236p-1, 0x1.386f465faf3a1p-6},
                      Vec3{0x1.5cb77fe89663cp-3, 0x1.5b72f49b7a28fp-4, -0x1.f6a6871ac8488p-1}}},
                    {-0x1.90bf0d3878128p-5, -0x1.4173d87a111bp-8, 0x1.039463476dcfap-2}};
  const double half_a = 0x1.9f646d8019ae8p-16, half_b = 0x1.08507bec996b8p-2;
  const Capsule a({0, 0, -half_a}, {0, 0, half_a}, 0x1.72c0fe7a07139p-17);
  const Capsule b({0, 0, -half_b}, {0, 0, half_b}, 0x1.4d4fad0f18b52p-14);
  const bool expected = oracle::overlap(world_set(a, pose_a), world_set(b, pose_b));
  EXPECT_EQ(overlap(PosedCapsule(a, pose_a), PosedCapsule(b, pose_b)), expected);
  EXPECT_EQ(overlap(a, pose_a, b, pose_b), expected);
}

// A ray at an edge of the triangle.
TEST(ProofConstants, ARayAlmostThroughAnEdgeIsDecidedExactly) {
  const Vec3 origin{0x1.8886eb4003701p+1, -0x1.fdf107968a251p+1, -0x1.a32c57437430ap+1};
  const Vec3 motion{-0x1.bc3267c88e038p+2, 0x1.38832cf2fb2abp+3, 0x1.114ce9553f17ap+3};
  const Triangle target{std::array<Vec3, 3>{Vec3{-0x1.02548d21074b8p-2, 0x1.80c48d3a00afap-1, 0x1.ef69434c058f2p-1},
                                            Vec3{-0x1.039f344408be8p-1, 0x1.3edae612b2ffcp-1, 0x1.a1660f45662cp-4},
                                            Vec3{0x1.a1e6309168022p-1, -0x1.6f1800e6b63e8p-2, 0x1.1be53198ea946p-1}}};
  const bool expected = oracle::time_of_hit(exact(origin), exact(motion), oracle::exact(target)).has_value();
  EXPECT_EQ(ray_time(PreparedRay(origin, motion), target).hit, expected);
}

TEST(ProofConstants, TheFilterOfHeightsAboveAHalfSpaceCoversFourRoundings) {
  const Vec3 point{-0x1.be8f4817481cp-6, -0x1.e7a6b9ca0e33ap-1, 0x1.9cd280924d262p-1};
  const Vec3 normal{0x1.5e9940bd59efap-1, 0x1.2da6316f48f94p-1, -0x1.5d89902014af8p-3};
  const Vec3 above{-0x1.7632cdf6434b2p-2, -0x1.979ab9f638f06p-1, -0x1.62606d8ffb6p-7};
  PosedHalfSpace half_space(HalfSpace({0, 0, 0}, {0, 0, 1}));
  half_space.point = point;
  half_space.normal = normal;
  const auto height = oracle::dot(exact(above) - exact(point), exact(normal));
  const Filtered found = filtered_height(half_space, above);
  EXPECT_TRUE(!found.is_positive() || height > 0);
  EXPECT_TRUE(!found.is_negative() || height < 0);
}

// The squares of the difference's coordinates round to 0, and that of the reach, which is less than its length, does
// not.
TEST(ProofConstants, SquaresThatUnderflowProveNoMeeting) {
  const double coordinate = 0.93e-162, reach = 1.6e-162;
  ASSERT_LT(reach * reach, 3 * 0x1p-1074);
  ASSERT_GT(oracle::Rational(3) * exact(coordinate) * exact(coordinate), exact(reach) * exact(reach));
  const Vec3 difference{coordinate, coordinate, coordinate};
  const double error = nearness_error(reach, sum_of_magnitudes(difference));
  EXPECT_FALSE(proves_meeting(dot(difference, difference), reach, error));
}

// Two points of the least doubles: their unit is some 2^1074 times that of the difference. What is 1.75 or 1.25 of it
// in the world is not a double.
TEST(ProofConstants, ADepthOfLeastDoublesIsRoundedBothWays) {
  const double least = std::numeric_limits<double>::denorm_min();
  const DifferenceBody body(PosedPolytope(Point{{0, 0, 0}}), PosedPolytope(Point{{4 * least, 0, 0}}));
  const double unit = body.scaled_length(least);
  ASSERT_EQ(body.unscaled(unit), least);
  EXPECT_EQ(body.lower_in_world(1.75 * unit), least);
  EXPECT_EQ(body.upper_in_world(1.25 * unit), 2 * least);
}

// The first coordinate of the direction loses 127 of its last places, which are 2^-53 of it, when it is rounded: then
// the first vertex seems to lie at 0, and the second at -64.
TEST(ProofConstants, TheLeastVertexAlongALongDirectionIsNotThatOfTheRoundedOne) {
  const WideInteger large = WideInteger(1) << 60;
  const IntegerVector direction{{large + 127, large, WideInteger(64)}};
  const PosedPolytope segment(Segment{{-1, 1, 0}, {0, 0, -1}});
  const std::vector<Index> least = least_vertices(segment, direction);
  ASSERT_EQ(least.size(), 1U);
  EXPECT_EQ(segment.vertex(least.front()), (Vec3{-1, 1, 0}));
}

// Each coordinate of the difference is 1 + 2^-53, which rounds to 1; so does the length of (1, 1, 1), downwards.
TEST(ProofConstants, APointThatIsAsFarAsALengthIsNotNearer) {
  const double least = -0x1p-53, length = std::nextafter(std::hypot(1.0, 1.0, 1.0), 2);
  const Vec3 p{1, 1, 1}, q{least, least, least};
  const auto way = exact(p) - exact(q);
  ASSERT_GE(oracle::dot(way, way), exact(length) * exact(length));
  VertexPairs simplex;
  simplex.append(0, 0);
  EXPECT_FALSE(certainly_nearer(PosedPolytope(Point{p}), PosedPolytope(Point{q}), simplex, length));
}

void expect_between(double lower, double upper, const oracle::Rational& squared) {
  EXPECT_LE(exact(lower) * exact(lower), squared);
  EXPECT_GE(exact(upper) * exact(upper), squared);
}

// Boxes that overlap by 2^54 - 1 and by 2^54 + 1 along the first axis, which both round to 2^54.
TEST(ProofConstants, ADifferenceOfCoordinatesThatIsNoDoubleIsRoundedBothWays) {
  const double wide = 0x1p60;
  const PosedPolytope box(Box({0x1p54, wide, wide}));
  const Box other({0x1p52, wide, wide});
  const Penetration less = penetration(box, PosedPolytope(other, {{}, {0x1p52 + 1, 0, 0}}));
  EXPECT_LE(exact(less.lower), exact(0x1p54) - 1);
  const Penetration more = penetration(box, PosedPolytope(other, {{}, {0x1p52 - 1, 0, 0}}));
  EXPECT_GE(exact(more.upper), exact(0x1p54) + 1);
}

const Triangle far_triangle{
    std::array<Vec3, 3>{Vec3{0x1.c130d83adb65dp+9, -0x1.7ecab650076a1p+9, 0x1.8845510278109p+9},
                        Vec3{0x1.c11717da8f3cap+9, -0x1.7e0d7416ac38p+9, 0x1.8871d2038c7dp+9},
                        Vec3{0x1.c1b21fd95da8dp+9, -0x1.7ed5fd1a83662p+9, 0x1.880affc787081p+9}}};

// In one lane a pair whose gap seems greater than it is, in the others one whose gap seems less.
TEST(ProofConstants, BoundsOfTheGapOfTwoTrianglesHoldIt) {
  using Pair = std::array<Triangle, 2>;
  const Pair greater{far_triangle, Triangle{std::array<Vec3, 3>{
                                       Vec3{0x1.c1bba483d6182p+9, -0x1.7e15464ed4e3p+9, 0x1.8818b38477f1dp+9},
                                       Vec3{0x1.c1bacdc713999p+9, -0x1.7e14a67f72ecep+9, 0x1.881a5c623f0a8p+9},
                                       Vec3{0x1.c1bbd5aefc12ap+9, -0x1.7e122c0f1b8d9p+9, 0x1.881bba9659a61p+9}}}};
  const Pair less{
      Triangle{std::array<Vec3, 3>{Vec3{0x1.c1562718d95cdp+9, -0x1.7e921c35bc052p+9, 0x1.87e4c9359f331p+9},
                                   Vec3{0x1.c145708dc720cp+9, -0x1.7e8f7f2caf8ddp+9, 0x1.87e1b63c17965p+9},
                                   Vec3{0x1.c14e84488682fp+9, -0x1.7e93cc71bbc99p+9, 0x1.87e65b9c4c8acp+9}}},
      Triangle{std::array<Vec3, 3>{Vec3{0x1.c0d7458fa12dep+9, -0x1.7e2de2369eb43p+9, 0x1.87c7c182a8f46p+9},
                                   Vec3{0x1.c0d75dc682f6ap+9, -0x1.7e2dca08dbd11p+9, 0x1.87c877282b183p+9},
                                   Vec3{0x1.c0d771913da95p+9, -0x1.7e2de82de94c8p+9, 0x1.87c803ab5b13cp+9}}}};
  TrianglePairBlock block{};
  for (std::size_t lane = 0; lane < TrianglePairBlock::lanes; ++lane) {
    const Pair& pair = lane == 0 ? greater : less;
    set_pair(block, lane, pair[0], pair[1]);
  }
  TriangleGaps gaps{};
  bound_gaps(block, gaps);
  const auto set = [](const Triangle& t) { return oracle::triangle_set(t[0], t[1], t[2]); };
  expect_between(gaps.lower[0], gaps.upper[0], oracle::squared_distance(set(greater[0]), set(greater[1])));
  expect_between(gaps.lower[1], gaps.upper[1], oracle::squared_distance(set(less[0]), set(less[1])));
}

TEST(ProofConstants, ALowerBoundByHeightsIsNotAboveTheDistance) {
  const Vec3 point{0x1.c0f14601852ebp+9, -0x1.7f07d717c7624p+9, 0x1.883ee62cd21b2p+9};
  TriangleBlock block;
  block.count = TriangleBlock::lanes;
  for (int i = 0; i < 3; ++i)
    for (int axis = 0; axis < 3; ++axis)
      block.corner[static_cast<std::size_t>(i)][static_cast<std::size_t>(axis)].fill(far_triangle[i][axis]);
  PointDistances distances{};
  measure(point, block, distances);
  const auto triangle = oracle::triangle_set(far_triangle[0], far_triangle[1], far_triangle[2]);
  expect_between(distances.lower[0], distances.upper[0], oracle::squared_distance(oracle::point_set(point), triangle));
}

// The directions of both are shorter than 1: the depth alone does not part the two.
TEST(ProofConstants, TheDepthOfABoxInAHalfSpaceParts) {
  const Box box({0x1.3aa139a0529ebp-1, 0x1.6829e72a94804p-2, 0x1.dd378dfb021a7p-1});
  const PosedHalfSpace plane(
      HalfSpace({0, 0, 0}, {-0x1.bc8b46be234f4p-2, -0x1.998d608812b6ap-2, -0x1.6921b3bd68d98p-1}));
  const Penetration found = penetration(PosedPolytope(box), plane);
  const auto normal = exact(plane.normal), way = exact(found.upper) * exact(found.direction);
  for (int i = 0; i < 8; ++i) EXPECT_GE(oracle::dot(exact(box.corner(i)) - exact(plane.point) - way, normal), 0);
}

TEST(ProofConstants, TheDepthOfTwoSpheresParts) {
  const double radius = 0x1.bc18369ecf2dp-3, other = 0x1.7020ee5fc3a6cp-1;
  const Vec3 centre{0x1.693c7a3654c6ep-3, -0x1.589bac293850bp-3, -0x1.1345842ff87dp-2};
  const PosedPolytope a(Sphere(radius, {0, 0, 0})), b(Sphere(other, centre));
  for (const Penetration& found : {penetration(a, b), penetration_by_expansion(a, b)}) {
    const auto between = exact(centre) + exact(found.upper) * exact(found.direction);
    const oracle::Rational reach = exact(radius) + exact(other);
    EXPECT_GE(oracle::dot(between, between), reach * reach);
  }
}

// The length of the first two columns seems to be 1.
TEST(ProofConstants, TheSkewOfARotationIsNotLessThanTheExactOne) {
  const double cosine = -0x1.4fea22a169da7p-1, sine = 0x1.82668aa998302p-1;
  const Pose turn{{{Vec3{cosine, -sine, 0}, Vec3{sine, cosine, 0}, Vec3{0, 0, 1}}}, {0, 0, 0}};
  const oracle::Rational beside = exact(cosine) * exact(cosine) + exact(sine) * exact(sine) - 1;
  EXPECT_GE(exact(PosedBox(Box({1, 1, 1}), turn).rigid.skew), abs(beside));
}

// A pyramid seen along the normal of its base, of which rounding makes some corners seem lower than their neighbours.
TEST(ProofConstants, AWalkAlongEdgesFindsTheVertexThatSeemsLowest) {
  const ConvexHull hull(std::vector<Vec3>{{0x1.f250f5d49a6d8p-1, 0x1.4860a302957c8p-3, -0x1.50b32f27aafb8p-3},
                                          {0x1.613a692989f71p-3, 0x1.f5db198144df5p-1, 0x1.8eec77026c0cap-4},
                                          {-0x1.bbbd4fba68056p-1, 0x1.c823a35fa3abap-2, 0x1.cbf9611f9cd4dp-3},
                                          {-0x1.6a8d9a2992df4p-1, -0x1.68e6add106337p-1, 0x1.53456ee95595cp-5},
                                          {0x1.b756b389fbf26p-2, -0x1.c31e6620b5e0cp-1, -0x1.978dc9337d44fp-3},
                                          {0x1.065bed93e5b15p-2, 0x1.50ecb21f76bd4p-4, 0x1.fa3b079934db3p-1}});
  const PosedPolytope pyramid(hull, {{}, {1, 0, 0}});
  const Vec3 direction{0x1.7ca403e56667fp-3, -0x1.092ea2c0168e6p-3, 0x1.f2b1154d23faap-1};
  const SupportKernels kernels = support_kernels();
  const Index lowest = SupportSearch(pyramid, kernels, GjkSupport::scan).least(direction);
  for (Index start = 0; start < pyramid.vertex_count(); ++start) {
    const SupportSearch walk(pyramid, kernels, GjkSupport::hill_climbing);
    walk.begin_at(start);
    EXPECT_EQ(walk.least(direction), lowest);
  }
}

// The largest row sum of |RᵀR − I| is more than 2^-10 by less than a rounding, and seems to be less.
TEST(ProofConstants, APoseThatDeformsByARoundingMoreThanItMayDeforms) {
  const Mat3 linear{{Vec3{0x1.00140452223a1p+0, -0x1.0b03729ec3bb1p-13, 0x1.e73b15f7310c2p-13},
                     Vec3{-0x1.36bb22f713b44p-14, 0x1.0004ddfaf64d8p+0, 0x1.f35d977193dcp-17},
                     Vec3{-0x1.1e67898403682p-14, 0x1.83555e3b7cc7ep-13, 0x1.ffe5375e2bdc1p-1}}};
  const auto product = [&](int i, int j) { return oracle::dot(exact(linear.column(i)), exact(linear.column(j))); };
  ASSERT_GT(abs(oracle::Rational(product(0, 0) - 1)) + abs(product(0, 1)) + abs(product(0, 2)), exact(0x1p-10));
  EXPECT_TRUE(deforms(linear));
}

// |RᵀR − I| of what flattens a box is 1 at least, and here no more.
TEST(ProofConstants, APoseThatFlattensABoxIsRefused) {
  const Mat3 flat{{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 0}}};
  EXPECT_THROW(PosedBox(Box({1, 1, 1}), {flat, {0, 0, 0}}), Error);
}

TEST(ProofConstants, ADepthPartsAlongADirectionThatIsALittleShort) {
  const DifferenceBody body(PosedPolytope(Point{{0, 0, 0}}), PosedPolytope(Point{{1, 0, 0}}));
  const double depth = 1.5;
  const oracle::Rational length_of_direction = 1 - exact(0x1p-50);
  EXPECT_GE(exact(body.upper_in_world(body.scaled_length(depth))) * length_of_direction, exact(depth));
}

// The point lies beside an edge, so that the volume of the three directions is all but lost.
TEST(ProofConstants, ASolidAngleSeenFromBesideAnEdgeIsAsFarOffAsItsBoundSays) {
  const Vec3 point{0x1.3d23adf53744bp-1, 0x1.77084d488d30bp-3, -0x1.5fc6d989dbf89p-3};
  const Triangle triangle{std::array<Vec3, 3>{Vec3{-0x1.7ecd08213d6cp-6, 0x1.8760a72d3ea32p-1, 0x1.bcaf3626b05d6p-1},
                                              Vec3{0x1.f157c6a4a9774p-1, -0x1.19720308c1f04p-3, -0x1.7cea5aedb0591p-1},
                                              Vec3{0x1.7b07d1c170d54p-1, 0x1.160fb79792e2cp-1, 0x1.99f6d0783b4acp-2}}};
  const SolidAngle angle = solid_angle(point, triangle);
  EXPECT_NEAR(angle.value, oracle::winding_number(point, std::span(&triangle, 1)), angle.bound);
}

// Boxes that are larger than they were by 2^-23: the square of that is too much for a normal whose length is taken from
// the first two terms of a series.
TEST(ProofConstants, TheDepthOfBoxesThatAreStretchedALittleParts) {
  const double s = 1 + 0x1p-23;
  const Box box({1, 1, 0.5});
  const Pose pose_a{{{Vec3{s, 0, 0}, Vec3{0, s, 0}, Vec3{0, 0, s}}}, {0, 0, 0}};
  const Pose pose_b{{{s * Vec3{0.36, 0.48, -0.8}, s * Vec3{-0.8, 0.6, 0}, s * Vec3{0.48, 0.64, 0.6}}},
                    {0.125, 0.25, 1.25}};
  const Penetration found = penetration(PosedPolytope(box, pose_a), PosedPolytope(box, pose_b));
  const oracle::Depth depth(world_set(box, pose_a), world_set(box, pose_b));
  EXPECT_GE(depth.compare(exact(found.lower)), 0);
  EXPECT_LE(depth.compare(exact(found.upper)), 0);
}

// A face that is all but a line, whose normal is the difference of products that nearly cancel. The point lies beside a
// corner along the one axis in which they do not, so that its height is hardly off, but the normal's length is.
TEST(ProofConstants, TheLengthOfANormalThatCancelsIsNotExact) {
  const std::array<Vec3, 4> corner{Vec3{-0x1.804872ac7d81dp-1, -0x1.73eba30414b64p-3, 0x1.fe3e5ca53dfcp-2},
                                   Vec3{0x1.fede354e09f8cp-3, -0x1.73eba30414b64p-3, 0x1.fe804e5dc3314p-1},
                                   Vec3{-0x1.81886917edbccp+0, -0x1.734ce8c7408d9p-3, 0x1.f30d31f8f3eacp-4},
                                   Vec3{-0x1.e11367bf5d294p-2, -0x1.b8dad06a8e1f9p-1, 0x1.d5fafcb2cc4d9p-1}};
  const Vec3 centre{-0x1.804a6db46571ep-1, -0x1.73eba30414b64p-3, 0x1.fe3e5ca53dfcp-2};
  const double radius = 0x1.37e4a3e86a53cp-18;
  bool is_in = true;
  for (std::size_t without = 0; without < 4; ++without) {
    const auto p = exact(corner[(without + 1) % 4]), q = exact(corner[(without + 2) % 4]),
               r = exact(corner[(without + 3) % 4]);
    const auto normal = oracle::cross(q - p, r - p);
    const oracle::Rational height = oracle::dot(normal, exact(centre) - p);
    is_in = is_in && height * height >= exact(radius) * exact(radius) * oracle::dot(normal, normal);
  }
  const ConvexHull hull(std::vector<Vec3>(corner.begin(), corner.end()));
  const PosedPolytope sphere(Sphere(radius), {{}, centre});
  EXPECT_EQ(containment_of_solids(sphere, PosedPolytope(hull)).containment,
            is_in ? Containment::a_in_b : Containment::none);
}

// So slow that while the interval lasts they come nearer by less than the reach is rounded.
TEST(ProofConstants, SpheresThatMoveSlowlyHaveMetByTheUpperTime) {
  const double radius = 0x1.646ca3e25b1bdp+0, other = 0x1.bc0a1ae61a90ap-2;
  const Vec3 start{0x1.c74742cf8c694p-1, -0x1.6f784adc9642ep+0, -0x1.94111a03fc127p-1};
  const Vec3 motion{-0x1.71202e2deb1f8p-6, 0x1.5e787b6c92f2p-5, 0x1.69ff46a2188a3p-6};
  const std::optional<Cast> cast =
      cast_shape(PosedPolytope(Sphere(radius), {{}, start}), motion, PosedPolytope(Sphere(other)));
  ASSERT_TRUE(cast);
  const auto between = exact(start) + exact(cast->upper) * exact(motion);
  const oracle::Rational reach = exact(radius) + exact(other);
  // They come nearer all the time.
  ASSERT_LT(oracle::dot(exact(start) + exact(motion), exact(motion)), 0);
  EXPECT_LE(oracle::dot(between, between), reach * reach);
}

// Along the direction of the depth products are rounded down.
TEST(ProofConstants, TheDepthOfHullsAlongARoundedAxisParts) {
  const ConvexHull a(std::vector<Vec3>{{-0x1.ad04db2dd4606p-1, -0x1.2aa452af3bf96p-1, 0x1.e2b29de862d5p-2},
                                       {-0x1.f6f1c4ecf18d2p-2, 0x1.c87a531597aaap-1, 0x1.87ce806b50798p-2},
                                       {0x1.ced5a70fcf6c8p-1, 0x1.83db422c69fep-1, 0x1.19c93bcd5f2dcp-2},
                                       {-0x1.11849678e4b17p-1, -0x1.90a865e0141bap-2, 0x1.90f5117a3814p-3},
                                       {-0x1.5d604c2cb073cp-2, 0x1.6fd42d486e398p-1, 0x1.badb8b4454736p-1},
                                       {0x1.7778975a89fb4p-1, -0x1.3419cc82f65bp-2, 0x1.9adf6e9dd0848p-1}});
  const ConvexHull b(std::vector<Vec3>{{-0x1.112a7c5308997p-1, -0x1.4c9cab20692dbp-1, -0x1.89b5cce5bde0bp-1},
                                       {-0x1.bddc8b71edcap-5, 0x1.8a43e2f9c783ap-1, -0x1.3905a65282322p-2},
                                       {-0x1.cb54c1c54be5fp-1, -0x1.556660a75398p-3, 0x1.da32f12707cp-7},
                                       {-0x1.3877397c0c798p-2, 0x1.019bff5d41d3cp-2, 0x1.c89cbdb60aedep-1},
                                       {0x1.2ac5f68d44fc2p-1, -0x1.52e55cb5f4d28p-1, -0x1.e9560d1364841p-1},
                                       {-0x1.38ec348459a4ap-1, 0x1.332551203f488p-3, -0x1.12a466e5c1d48p-3}});
  const PosedPolytope posed_a(a, {{{Vec3{-0x1.12c2aeb8c7688p-2, -0x1.3f8eac725db7bp-2, 0x1.d2a0b3b79c76dp-1},
                                    Vec3{0x1.db1ef2238cd4ap-1, -0x1.59ce449dbe114p-2, 0x1.42b50a8f37576p-3},
                                    Vec3{0x1.08ced80bdf452p-2, 0x1.c6a9fdbfaef94p-1, 0x1.85539d69fc9dp-2}}},
                                  {-0x1.f699d182049p-7, -0x1.ffeb1a342f5bep-2, 0x1.dba1d3edb00b8p-2}});
  const PosedPolytope posed_b(b, {{{Vec3{0x1.3c5890f6bca5ap-1, -0x1.c73c167e4ff7p-3, 0x1.82280e3437e9ap-1},
                                    Vec3{-0x1.dfc792d7df1a2p-2, -0x1.bfb0b70997f14p-1, 0x1.024fa4a2c8665p-3},
                                    Vec3{0x1.434c7ec034818p-1, -0x1.b9a7e9d36e72p-2, -0x1.49ef47479350cp-1}}},
                                  {0x1.2a6b637f47b8p-6, -0x1.0b128dc5cc438p+0, 0x1.262a62febf718p+0}});
  const auto set = [](const PosedPolytope& hull) {
    std::vector<Vec3> vertices;
    for (Index i = 0; i < hull.vertex_count(); ++i) vertices.push_back(hull.vertex(i));
    return oracle::hull_set(vertices);
  };
  PolyhedronAxes axes(posed_a, posed_b);
  const PolyhedronAxes::Least least = axes.least({});
  const oracle::Depth depth(set(posed_a), set(posed_b));
  EXPECT_GE(depth.compare(exact(axes.body().lower_in_world(least.lower))), 0);
  EXPECT_LE(depth.compare(exact(axes.body().upper_in_world(least.upper))), 0);
}

std::string distance_fault(const PosedPolytope& a, const oracle::ConvexSet& set_a, const PosedPolytope& b,
                           const oracle::ConvexSet& set_b) {
  const Distance d = distance(a, b);
  std::string fault = test::interval_fault(d, set_a, set_b);
  return fault.empty() ? test::exact_witness_fault(d, a, b, test::size_of(set_a, set_b)) : fault;
}

void expect_distance_of_the_oracle(const Vec3& p, const Box& box, const Mat3& linear) {
  const Pose pose{linear, {}};
  EXPECT_EQ(
      distance_fault(PosedPolytope(Point(p)), oracle::point_set(p), PosedPolytope(box, pose), world_set(box, pose)),
      "");
}

// They cross at an angle of 2^-12, so that rounding moves where along them they are nearest.
TEST(ProofConstants, NearPointsOfSegmentsThatAreNearlyParallelAreNotTold) {
  const Vec3 p{-0x1.928bd3818f723p+0, 0x1.f5e7d4ebc2401p+0, 0}, q{0x1.521ff516079p+0, -0x1.d3c3e9915902ep-1, 0};
  const Vec3 r{-0x1.576c1bf892459p+10, 0x1.4ab0c04ad5cb5p+10, 1}, s{0x1.c4a6616f7751cp+7, -0x1.b2f17ecd6cec6p+7, 1};
  const PosedPolytope first(Segment(p, q)), second(Segment(r, s));
  EXPECT_EQ(distance_fault(first, oracle::segment_set(p, q), second, oracle::segment_set(r, s)), "");
}

// One apart, and so long that the points of them that rounding takes are farther than that from each other.
TEST(ProofConstants, LongSegmentsThatCrossAreNotNearestWhereRoundingHasThem) {
  const Vec3 p{0x1.476c97b9d03dfp+22, -0x1.07e4cb316b432p+20, 0}, q{-0x1.541412e59c288p+24, 0x1.1217a7c1eed06p+22, 0};
  const Vec3 r{0x1.3b9139dcfd90ap+29, -0x1.ebe731c6a85p+25, 1}, s{-0x1.82b475e1829ap+28, 0x1.2d6556d571246p+25, 1};
  const PosedPolytope first(Segment(p, q)), second(Segment(r, s));
  EXPECT_EQ(distance_fault(first, oracle::segment_set(p, q), second, oracle::segment_set(r, s)), "");
}

// The pose is sheared a little: of a point far away the length is right, but the foot is not.
TEST(ProofConstants, AFootOnAShearedBoxIsNotTold) {
  const Mat3 linear{{Vec3{0x1.0d221cb92ef8cp-3, 0x1.73cb5ac08b1b6p-4, -0x1.f96d797b7428bp-1},
                     Vec3{0x1.d61242bec56a2p-3, -0x1.f16bd7ed33a36p-1, -0x1.e180cffda06a7p-5},
                     Vec3{-0x1.edc4863d6ce7p-1, -0x1.c037e132d6a82p-3, -0x1.30236b6c0f7bcp-3}}};
  expect_distance_of_the_oracle({-0x1.20f3222107a89p+5, -0x1.4032f1989da73p+1, -0x1.4fffea5978fd2p+2},
                                Box({0x1.3434da8613e13p-1, 0x1.354a1d0b183bp-1, 0x1.de84a4dae7a3p-1}), linear);
}

// Two edges are nearly parallel, so that the violation at a foot tells little of where the nearest point is.
TEST(ProofConstants, EdgesThatAreNearlyParallelAreNotThoseOfABox) {
  const Mat3 linear{{Vec3{1, 1, 0}, Vec3{0, 0x1.7264452db3f4ep-23, 0}, Vec3{0, 0, 1}}};
  expect_distance_of_the_oracle({-0x1.f2e44bdf3ffa4p-1, -0x1.ab2cc22be479cp-26, 0x1.342b1120513bep+1},
                                Box({0x1.18c6e99cd06abp+0, 0x1.9ee4d71a69328p-1, 0x1.b1a16e1defdd4p-1}), linear);
}

// Above an edge, which lies level: rounding hides that the point is beside it.
TEST(ProofConstants, APointVeryNearAnEdgeIsBesideItByARounding) {
  const Mat3 linear{{Vec3{-0x1.48f1d3f9b8b75p-1, -0x1.156f24efa3bd2p-1, 0x1.156f24efa3bd2p-1},
                     Vec3{0x1.8859e4d5ad026p-1, -0x1.d132ae4e69e98p-2, 0x1.d132ae4e69e98p-2},
                     Vec3{0, 0x1.6a09e667f3bcdp-1, 0x1.6a09e667f3bcdp-1}}};
  expect_distance_of_the_oracle({0x1.0fcf1d4ac2b86p-2, -0x1.8a943d4a2a94ep-1, 0x1.a0fa93f0b3449p+0},
                                Box({0x1.4c4c3347e5505p+0, 0x1.5ba7c32d43b2bp+0, 0x1.e415643d74aa6p-1}), linear);
}

// A box of a thickness of 2^-16, whose corners are bent by more than their rounded differences tell.
TEST(ProofConstants, TheBendOfASlenderBoxIsRounded) {
  const Mat3 linear{{Vec3{-0x1.dfe39ee6c7b6p-1, 0x1.946bfd9b5397p-3, -0x1.26213f98ec682p-2},
                     Vec3{0x1.3780c89830f6cp-2, 0x1.f4735de92302p-5, -0x1.e6bb27946e8d1p-1},
                     Vec3{-0x1.5c867e9e45ee6p-3, -0x1.f4f145fbfc0b5p-1, -0x1.e09587671bf8p-4}}};
  expect_distance_of_the_oracle({0x1.4d83bcf4e45e4p-2, -0x1.672de2aa8ee9ep+1, -0x1.c054c1490ac68p-4},
                                Box({0x1.f49d1ae209bcap+0, 0x1.38b64cf75462ap-16, 0x1.48b7661fc3045p+0}), linear);
}

// Two plates, turned about one axis, so that no skewness is seen: a corner of the one, far from the middles, is beside
// a face of the other by less than what rounding makes of it.
TEST(ProofConstants, PlatesAreNotDecidedByWhatIsRounded) {
  const Mat3 turn_a{{Vec3{-0x1.17c9d7ed3ff8ep-1, 0x1.accab48b903d3p-1, 0},
                     Vec3{-0x1.accab48b903d3p-1, -0x1.17c9d7ed3ff8ep-1, 0}, Vec3{0, 0, 1}}};
  const Mat3 turn_b{{Vec3{-0x1.17cbd3010ff62p-1, 0x1.acc969ab24db7p-1, 0},
                     Vec3{-0x1.acc969ab24db7p-1, -0x1.17cbd3010ff62p-1, 0}, Vec3{0, 0, 1}}};
  expect_overlap_of_the_oracle(Box({0x1.52e661f23a3d8p-16, 0x1.263c9fa57d97bp-1, 0x1.52e661f23a3d8p-16}), {turn_a, {}},
                               Box({0x1.595ba18501dap-14, 0x1.ca61c9ce97b06p-3, 0x1.595ba18501dap-14}),
                               {turn_b, {-0x1.e88fc9fc8c46p-15, -0x1.765fd68fb5ecdp-14, 0}});
}

// The same of plates that are sheared.
TEST(ProofConstants, ShearedPlatesAreNotDecidedByWhatIsRounded) {
  const Box a({0x1.e9e1ee96673ecp-2, 0x1.33681799a336ep-1, 0x1.252a08fecfeb7p-16}),
      b({0x1.975ea674ff132p-2, 0x1.7710fec2b0144p-1, 0x1.8ccff68793753p-17});
  const Pose pose_a{{{Vec3{0x1.3013ceadc2d98p-6, -0x1.013c44df3efdep+0, -0x1.2caf88428376p-4},
                      Vec3{-0x1.6c4571753c884p-1, -0x1.5365c581e9ffap-4, 0x1.7b31a8adf38d2p-1},
                      Vec3{-0x1.53b0348156abfp-1, 0x1.b940ae1815bd6p-4, -0x1.55f83ad478258p-1}}},
                    {}};
  const Pose pose_b{{{Vec3{0x1.3013ceadc2d98p-6, -0x1.013c44df3efdep+0, -0x1.2caf88428376p-4},
                      Vec3{-0x1.6c4571753c884p-1, -0x1.5365c581e9ffap-4, 0x1.7b31a8adf38d2p-1},
                      Vec3{-0x1.53b0348156abfp-1, 0x1.b940ae1815bd6p-4, -0x1.55f83ad478258p-1}}},
                    {0x1.f0c1431642d06p-14, -0x1.7cbf89d73e292p-16, -0x1.5bbe4e7315ae4p-14}};
  const bool expected = oracle::overlap(world_set(a, pose_a), world_set(b, pose_b));
  const std::optional<bool> meet = BoxAxes(PosedPolytope(a, pose_a), PosedPolytope(b, pose_b)).meet();
  EXPECT_EQ(meet.value_or(expected), expected);
}

// Two wedges, whose edges are nearly parallel and overlap a little less than a face of the one and the other: so much
// less that the height of the facet that these edges make decides, which is rounded the other way.
TEST(ProofConstants, TheDepthOfEdgesThatAreNearlyParallelIsRounded) {
  const std::vector<Vec3> corners_a{{-0x1.c2f0b0d41a286p-1, 0x1.c3abb646d7e1cp-2, 0x1.612a1a208322fp-3},
                                    {-0x1.215269e763512p-1, 0x1.c103da10f46c1p-1, 0x1.56e25cc0a3516p-1},
                                    {-0x1.07949568e9f55p+0, -0x1.d9373792b0c7ap-5, 0x1.604dcb42be018p-1},
                                    {0x1.c2f0b0d41a286p-1, -0x1.c3abb646d7e1cp-2, -0x1.612a1a208322fp-3},
                                    {0x1.32477be0687fdp+0, -0x1.53ee1af1bad9p-8, 0x1.4c9a9f60c37fcp-2},
                                    {0x1.76b836d660662p-1, -0x1.e13f29c002ee4p-1, 0x1.5f717c64f8e02p-2}};
  const std::vector<Vec3> corners_b{{-0x1.68b8d330e179ap-1, 0x1.68f966a31c9c4p-2, 0x1.1cffc5680922cp-3},
                                    {-0x1.edd5c7329ff98p-1, 0x1.4347b1a75cd36p-4, -0x1.f4a36b1bfe346p-2},
                                    {-0x1.aec5287020dc1p-1, 0x1.716658e38339bp-2, -0x1.294aaa1e761ccp-1},
                                    {0x1.6907db4d7b88ap-1, -0x1.688fb22502ca4p-2, -0x1.18cdeecf26918p-3},
                                    {0x1.c7d5ce977a116p-2, -0x1.405b962f2418ep-1, -0x1.87c5229bcb074p-1},
                                    {0x1.22fb860e3c262p-1, -0x1.6022bfe49c2cep-2, -0x1.b6be172c4209dp-1}};
  const ConvexHull a(corners_a), b(corners_b);
  const std::optional<CoreSeparation> found = part_cores_fast(PosedPolytope(a), PosedPolytope(b), 0);
  if (!found) return;
  const oracle::Depth depth(oracle::hull_set(corners_a), oracle::hull_set(corners_b));
  EXPECT_GE(depth.compare(exact(found->lower)), 0);
  EXPECT_LE(depth.compare(exact(found->upper)), 0);
}

std::string distance_fault(const Vec3& p, const Triangle& t) {
  return distance_fault(PosedPolytope(Point(p)), oracle::point_set(p), PosedPolytope(t),
                        oracle::triangle_set(t[0], t[1], t[2]));
}

// A narrow triangle far from the point: rounding moves the foot along it.
TEST(ProofConstants, AFootOnANarrowTriangleIsNotTold) {
  EXPECT_EQ(distance_fault({-0x1.ffc75b64739adp-1, -0x1.ffc7e6fce3bcdp-1, -0x1.ffc87f5ab0e6p-1},
                           Triangle{{Vec3{0x1.ffa3c47200882p-1, 0x1.ff9c0d43f64d7p-1, 0x1.ff939f017277p-1},
                                     Vec3{0x1.ff8f473d38739p-1, 0x1.ff9b7158eeaa5p-1, 0x1.ffa8b821422ebp-1},
                                     Vec3{0x1.ff930f4a162f6p-1, 0x1.ff9b8cc3c684p-1, 0x1.ffa4d4a98c993p-1}}}),
            "");
}

// One above a triangle that is so large that what rounds of the foot is a part of that.
TEST(ProofConstants, AFootOnALargeTriangleIsNotTheNearestPoint) {
  EXPECT_EQ(distance_fault({0x1.d0e3d6320d9acp-2, -0x1.42cd0b78a7564p-1, 1},
                           Triangle{{Vec3{-0x1.8b7eb7940762ep+28, -0x1.81b3842c216aap+28, 0},
                                     Vec3{0x1.a679cd9ac6591p+29, 0x1.79581f8c8da8bp+29, 0},
                                     Vec3{0x1.d27d648ccd60fp+29, 0x1.e176f72a2335dp+29, 0}}}),
            "");
}

}  // namespace
}  // namespace toccata
