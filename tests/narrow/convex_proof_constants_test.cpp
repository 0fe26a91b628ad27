// Witnesses of polyhedra, boxes and triangles: with a constant that a proof rests on made a few times too small, these
// doubles give a false statement (docs/design/proof-constants.md).
#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <vector>

#include "narrow/boxes/box_separation.hpp"
#include "narrow/convex/polyhedron_axes.hpp"
#include "narrow/triangles/passing_rays.hpp"
#include "narrow/triangles/triangle_gaps.hpp"
#include "oracle/convex.hpp"
#include "oracle/penetration.hpp"
#include "oracle/rational.hpp"

namespace toccata::test {
namespace {

using oracle::exact;
using oracle::Rational;

Rational square_of_length(const Rational& x) { return x * x; }

/// A length is no more than the least that A − B reaches, which it does along no direction less than along any.
void expect_no_more_than_reach(double length, const PosedPolytope& a, const PosedPolytope& b,
                               const oracle::RationalPoint& direction) {
  Rational reach = oracle::dot(direction, exact(a.vertex(0)) - exact(b.vertex(0)));
  for (Index i = 0; i < a.vertex_count(); ++i)
    for (Index j = 0; j < b.vertex_count(); ++j)
      reach = std::max(reach, oracle::dot(direction, exact(a.vertex(i)) - exact(b.vertex(j))));
  ASSERT_GT(reach, 0);
  EXPECT_LE(square_of_length(exact(length)) * oracle::dot(direction, direction), square_of_length(reach));
}

oracle::ConvexSet hull_of(const PosedPolytope& posed) {
  std::vector<Vec3> vertices;
  for (Index i = 0; i < posed.vertex_count(); ++i) vertices.push_back(posed.vertex(i));
  return oracle::hull_set(vertices);
}

double lower_of_axes(const PosedPolytope& a, const PosedPolytope& b) {
  PolyhedronAxes axes(a, b);
  const double lower = axes.least({}).lower;
  EXPECT_GT(lower, 0);
  return axes.body().unscaled(lower);
}

// Corners of a face of the cube are rounded where it lies, so that it bends, and a corner of B lies below it.
TEST(ConvexProofConstants, FacesOfHullsFarAwayAreBent) {
  const ConvexHull cube(
      {{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {-1, 1, 1}, {1, 1, 1}});
  const Mat3 turn{{Vec3{-0x1.70144e690f9a8p-1, 0x1.61b2a722160bbp-1, -0x1.3beade8f54504p-4},
                   Vec3{-0x1.63d47358496c9p-1, -0x1.6ca5e784cfe14p-1, 0x1.94d75efc54f26p-4},
                   Vec3{0x1.b5633df941248p-7, 0x1.fe994a6b37db8p-4, 0x1.fbf5d7448e609p-1}}};
  const PosedPolytope a(cube, {turn, {0x1.7d713f3885d68p+8, -0x1.fbb3a0e2e3658p+10, 0x1.c85c5121d02f4p+10}});
  const ConvexHull tetrahedron({{0x1.7ddd3c0a39577p+8, -0x1.fb7e952ddb78bp+10, 0x1.c88e0489ba90bp+10},
                                {0x1.7de763f337b97p+8, -0x1.fb73fdb302fdbp+10, 0x1.c8cdab3cb61d7p+10},
                                {0x1.7dcd1332ab222p+8, -0x1.fb7840664deccp+10, 0x1.c8cd94f73c4a3p+10},
                                {0x1.7e3fd61d6df8p+8, -0x1.fb82249719b89p+10, 0x1.c8d0cc398f129p+10}});
  const PosedPolytope b(tetrahedron);
  PolyhedronAxes axes(a, b);
  const double lower = axes.least({}).lower;
  // Here nothing is known, as faces may be bent by more than their normals may be off.
  EXPECT_TRUE(!(lower > 0) || oracle::Depth(hull_of(a), hull_of(b)).compare(exact(axes.body().unscaled(lower))) >= 0);
}

// The cross product of the edges at which the triangles cross is short, and rounded as if it were not.
TEST(ConvexProofConstants, TheAxisOfNearlyParallelEdgesIsRounded) {
  const Triangle a{{Vec3{0x1.c4eb191176b94p-2, -0x1.c589a82bfc3bcp-1, 0x1.1f700bae95e25p-3},
                    Vec3{-0x1.c4eb191176b94p-2, 0x1.c589a82bfc3bcp-1, -0x1.1f700bae95e25p-3},
                    Vec3{0x1.770377969f2b5p-2, 0x1.91142ef985466p-2, 0x1.b17e282f946c2p-1}}};
  const Triangle b{{Vec3{0x1.f4414c5202bedp-2, -0x1.f7cb4abb385a3p-1, 0x1.422dfc1f81367p-3},
                    Vec3{-0x1.90e443017915dp-2, 0x1.9438f7d9bd3a1p-1, -0x1.027ea212db33bp-3},
                    Vec3{-0x1.711c774cf4287p-2, -0x1.9ce6518070e53p-2, -0x1.b08e6c6e65a69p-1}}};
  const auto across = oracle::cross(exact(a[1]) - exact(a[0]), exact(b[1]) - exact(b[0]));
  const Rational side = oracle::dot(across, exact(a[0]) - exact(b[2]));
  const PosedPolytope posed_a(a), posed_b(b);
  expect_no_more_than_reach(lower_of_axes(posed_a, posed_b), posed_a, posed_b, Rational(-side.sign()) * across);
}

// A corner of one triangle lies just below the other one, which is narrow.
TEST(ConvexProofConstants, TheNormalOfANarrowFaceIsRounded) {
  const Triangle a{{Vec3{0x1.1074b8143a058p-3, 0x1.95e8da99c4fcep-1, -0x1.308918fc0d7a6p-1},
                    Vec3{-0x1.1074b8143a058p-3, -0x1.95e8da99c4fcep-1, 0x1.308918fc0d7a6p-1},
                    Vec3{0x1.3dd15ae898dc5p-6, 0x1.cc4222160f909p-4, -0x1.5aa5d9455913p-4}}};
  const Triangle b{{Vec3{-0x1.a173db9ee8577p-6, -0x1.389849f16b262p-3, 0x1.d48d5d4aae83p-4},
                    Vec3{0x1.6392bb7c97e7p-1, 0x1.1b4a6f179d997p-1, 0x1.997f850c571d7p-1},
                    Vec3{0x1.247313015f4dp+0, 0x1.42ba1b24776fp-2, 0x1.1a10164b46p+0}}};
  const auto normal = oracle::cross(exact(a[1]) - exact(a[0]), exact(a[2]) - exact(a[0]));
  const Rational side = oracle::dot(normal, exact(b[1]) - exact(a[0]));
  const PosedPolytope posed_a(a), posed_b(b);
  expect_no_more_than_reach(lower_of_axes(posed_a, posed_b), posed_a, posed_b, Rational(side.sign()) * normal);
}

// Two edges of boxes cross at an angle of 2^-10; with long radii a wide bracket is enough.
TEST(ConvexProofConstants, TheDepthOfBoxesAlongNearlyParallelEdgesIsRounded) {
  const Mat3 turn_a{{Vec3{-0x1.864482b4c7098p-1, -0x1.2b30ba3c03f5dp-1, 0x1.1d1947d6f70a8p-2},
                     Vec3{-0x1.0f1e52bce5983p-1, 0x1.4321e5315aed9p-2, -0x1.93280f2b2fd9fp-1},
                     Vec3{0x1.7d355d3aa370ap-2, -0x1.7ec957d54a568p-1, -0x1.19950a103b448p-1}}};
  const Mat3 turn_b{{Vec3{-0x1.865c5af1cd117p-1, -0x1.2b1ba79f08096p-1, 0x1.1cef229cff319p-2},
                     Vec3{-0x1.0effd4cc77d4ap-1, 0x1.433f29ea3c5edp-2, -0x1.9336b187a0929p-1},
                     Vec3{0x1.7d2a6e96240d2p-2, -0x1.7ed3a210eaa98p-1, -0x1.198abfd49af16p-1}}};
  const Box box({1, 0.5, 0.5});
  const PosedPolytope a(box, {turn_a, {0, 0, 0}});
  const PosedPolytope b(box, {turn_b, {-0x1.d64da64bf8226p-3, -0x1.ace880607c781p-2, -0x1.55b81388f03cfp+0}});
  OverlappingBoxes boxes;
  const auto found = part_rigid_boxes(view_of(a), view_of(b), 1024, boxes);
  ASSERT_TRUE(found);
  const oracle::Depth depth(hull_of(a), hull_of(b));
  EXPECT_GE(depth.compare(exact(found->lower)), 0);
  EXPECT_LE(depth.compare(exact(found->upper)), 0);
}

// Each end of both edges lies beside by a rounding, and so an edge by two along each axis.
TEST(ConvexProofConstants, AnEdgeThatSeemsAPointAlongAnotherHasALength) {
  const Vec3 edge{1, 0, 0}, beside{0, 0x1p-52, 0x1p-52};
  const auto e = exact(edge) - exact(beside), f = exact(edge) + exact(beside);
  const auto across = oracle::cross(e, f);
  EXPECT_GE(square_of_length(exact(greatest_image(edge, edge, 1, 0))) * oracle::dot(e, e), oracle::dot(across, across));
}

// The motion is so long beside the triangle that its time is certain, but the normal needs more digits.
TEST(ConvexProofConstants, TheNormalOfASliverIsNotMadeInDoubles) {
  const PreparedRay ray({-0x1.739a054a7cb1fp+0, -0x1.d1d6f4a8c29e4p-1, -0x1.3dfefb4743d6ep-3},
                        {0x1.27296fc5f83c8p+25, 0x1.8d0746109564cp+22, 0x1.b6319821fb083p+25});
  const Triangle sliver{{Vec3{-0x1.76e90a81125e4p-1, -0x1.7451b6bf739c2p-1, -0x1.8fa5c310a3378p-4},
                         Vec3{-0x1.b0b0d53596c3ap+0, -0x1.067ff079dfd54p+0, 0x1.734652e8d1e6bp-1},
                         Vec3{-0x1.1d8ca59e1b5a1p+0, -0x1.b164392a082f4p-1, 0x1.da2537d870805p-3}}};
  const PassingRay passing{&ray, sliver};
  PassingHit hit;
  hits_of_passing(std::span(&passing, 1), std::span(&hit, 1));
  const RayTime time = ray_time_of_passing(ray, sliver);
  ASSERT_TRUE(time.hit && !time.exact);
  EXPECT_TRUE(!hit.told || hit.cast == ray_hit(ray, sliver, time));
}

// The cross product of the edges loses 32 of its places; a normal is good to about 10^-9 (docs/methods/casts.md).
TEST(ConvexProofConstants, TheNormalOfASliverThatIsHitIsRightToItsLastPlaces) {
  const Triangle sliver{{Vec3{0, 0, 0}, Vec3{-1.17431640625, 0.676513671875, 0.96728515625},
                         Vec3{-0x1.e0fffffdcf6d7p-2, 0x1.15199998350dbp-2, 0x1.8c33333163b51p-2}}};
  const Cast hit = ray_hit(PreparedRay({1, 2, 3}, {-1, -2, -3}), sliver, {true, 0.5, 0.5, false});
  const auto across = oracle::cross(exact(sliver[1]), exact(sliver[2]));
  const auto aside = oracle::cross(exact(hit.normal), across);
  EXPECT_LT(oracle::dot(aside, aside) * Rational(1'000'000'000'000'000'000), oracle::dot(across, across));
}

// A vertex lies 2^-53 above a triangle: even double words have few digits left of that.
TEST(ConvexProofConstants, GapsThatAreTinyBesideTheTrianglesAreRounded) {
  const Triangle a{{Vec3{-0x1.04182348d0d8ap-2, -0x1.b2cf1f28f018ap-3, -0x1.6ec466f5ad05p-6},
                    Vec3{0x1.fb154fcde49aap-1, -0x1.27abf4c3aefa4p-2, 0x1.ac12f465eeaap-5},
                    Vec3{-0x1.802f10da3fc16p-2, -0x1.a8dae4632cac1p-1, -0x1.f92f972423dbdp-1}}};
  const Triangle b{{Vec3{-0x1.45baf5b3d1904p-3, -0x1.8cc97471c4207p-1, -0x1.1d9847f559916p-1},
                    Vec3{-0x1.81a5bb79a64p-10, -0x1.34cb84150b07cp-2, 0x1.7432582ee4518p-3},
                    Vec3{-0x1.0d8f1145d0282p-1, 0x1.2b5d61d4b0594p-1, 0x1.22d8e537bcf2cp-1}}};
  TrianglePairBlock block{};
  for (std::size_t lane = 0; lane < TrianglePairBlock::lanes; ++lane) set_pair(block, lane, a, b);
  block.count = 1;
  TriangleGaps gaps{};
  bound_gaps(block, gaps);
  refine_gaps(block, gaps);
  const auto gap =
      oracle::squared_distance(oracle::triangle_set(a[0], a[1], a[2]), oracle::triangle_set(b[0], b[1], b[2]));
  EXPECT_LE(square_of_length(exact(gaps.lower[0])), gap);
  EXPECT_GE(square_of_length(exact(gaps.upper[0])), gap);
}

// Along an axis nothing is added to the upper end for the direction. The depth is 2^-120 less than 1: what only exact
// arithmetic tells.
TEST(ConvexProofConstants, ADepthAlongAnAxisLiesBetweenTwoDoubles) {
  const double little = 0x1p-120;
  const Penetration found = penetration(PosedPolytope(Capsule({-1, 0, 0}, {-3, 1, 0}, 1)),
                                        PosedPolytope(Capsule({little, 0, 0}, {3, 0, 1}, 1)));
  EXPECT_EQ(found.direction, (Vec3{1, 0, 0}));
  EXPECT_LE(exact(found.lower), Rational(1) - exact(little));
  EXPECT_GE(exact(found.upper), Rational(1) - exact(little));
  EXPECT_LT(found.lower, found.upper);
}

}  // namespace
}  // namespace toccata::test
