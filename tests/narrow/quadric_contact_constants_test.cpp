// Witnesses of quadrics that touch or nearly do: with a constant that a proof rests on made a few times too small,
// these doubles give a false statement (docs/design/proof-constants.md).
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <vector>

#include "math/constants.hpp"
#include "narrow/quadrics/distance/axial_box.hpp"
#include "narrow/quadrics/distance/ellipsoid_pair.hpp"
#include "narrow/quadrics/distance/fast_overlap.hpp"
#include "narrow/quadrics/distance/fast_pair.hpp"
#include "narrow/quadrics/distance/fast_proof.hpp"
#include "narrow/quadrics/distance/fast_refinement.hpp"
#include "narrow/quadrics/inside/quadric_containment.hpp"
#include "narrow/quadrics/inside/unit_frame.hpp"
#include "oracle/convex.hpp"
#include "oracle/rational.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata::test {
namespace {

using oracle::exact;
using oracle::Rational;

Rational square_of_number(const Rational& x) { return x * x; }

PosedQuadric ball_in_contact(double radius, const Vec3& centre) {
  return PosedQuadric(Ellipsoid({radius, radius, radius}), {{}, centre});
}

/// The squared distance of two centres, exactly.
Rational squared_between(const Vec3& p, const Vec3& q) { return oracle::dot(exact(p) - exact(q), exact(p) - exact(q)); }

// Products with the last two coordinates are half of a last place, and lost one after the other.
TEST(QuadricContactConstants, AHeightOfAPointIsNoLessThanItsProduct) {
  const Vec3 point{1, 0x1p-53, 0x1p-53}, direction{0.5, 0.5, 0.5};
  const PosedPolytope posed(Point{point});
  const double height = PlainBody(posed, PairFrame{}).height_at_most(direction);
  EXPECT_GE(exact(height), oracle::dot(exact(point), exact(direction)));
}

// What the search finds to be their gap is rounding.
TEST(QuadricContactConstants, ABallAndAPointThatTouchAreNotApart) {
  const Vec3 centre{0x1.328960ff5b0c8p-2, 0x1.0b26b9614c7abp-4, 0x1.086656cd56249p-2};
  const Vec3 point{0x1.1f44fd01f88a9p+0, -0x1.c622f9b5de715p-2, 0x1.3531b7c5cc4edp-2};
  const double radius = 0x1.efcb20f6d2cebp-1;
  ASSERT_LE(squared_between(centre, point), square_of_number(exact(radius)));
  const PosedQuadric a = ball_in_contact(radius, centre);
  const PosedPolytope b(Point{point});
  EXPECT_FALSE(FastPair<PosedPolytope>(a, b, pair_frame(a, b)).is_apart());
}

// Their gap along the way between the centres is rounded upwards.
TEST(QuadricContactConstants, BallsThatTouchAreNotApart) {
  const Vec3 centre{-0x1.b3cfb854f9c2ep-1, 0x1.dd16b4c06a792p-4, 0x1.337a11ca2d341p-1};
  const double r = 0x1.d211280f62129p-2, s = 0x1.2fa69ae3a5456p-1;
  ASSERT_LE(squared_between(centre, {}), square_of_number(exact(r) + exact(s)));
  EXPECT_NE(ellipsoid_contact(ball_in_contact(r, {}), ball_in_contact(s, centre)), QuadricContact::apart);
}

// The bottom lies 64 roundings below the origin, and corners may be 117 too low.
TEST(QuadricContactConstants, CornersMayBeOffByMoreThanTheOriginIsWithin) {
  const double z = -64 * unit_roundoff;
  std::vector<QuadricSearch::Corner> corners(4);
  corners[0].a.point = {4, 0, z};
  corners[1].a.point = {-2, 3.4, z};
  corners[2].a.point = {-2, -3.4, z};
  corners[3].a.point = {0, 0, 3};
  EXPECT_FALSE(are_surely_around_origin(corners));
}

// Three corners lie so near to each other that the volumes that they span with the origin are rounding.
TEST(QuadricContactConstants, VolumesOfSliversAreRounded) {
  const std::array<Vec3, 4> point{Vec3{-0x1.da941761589e7p-1, 0x1.5f83e514bd735p-2, -0x1.87a8032cc3dfep-4},
                                  Vec3{0x1.292ba381aa9d5p+0, -0x1.b838d39cc7e32p-2, 0x1.ea7e2d906d94cp-4},
                                  Vec3{0x1.292ba381aa412p+0, -0x1.b838d39cc6a97p-2, 0x1.ea7e2d906fb54p-4},
                                  Vec3{0x1.292ba381aa654p+0, -0x1.b838d39cc8b91p-2, 0x1.ea7e2d90720a5p-4}};
  std::vector<QuadricSearch::Corner> corners(4);
  for (std::size_t i = 0; i < 4; ++i) corners[i].a.point = point[i];
  const auto side = [&](std::size_t i, std::size_t j, std::size_t k) {
    return oracle::dot(exact(point[i]), oracle::cross(exact(point[j]), exact(point[k]))).sign();
  };
  // The origin is on different sides of two faces that both look outwards.
  ASSERT_LT(std::abs(side(1, 2, 3) + side(0, 3, 2) + side(0, 1, 3) + side(0, 2, 1)), 4);
  EXPECT_FALSE(are_surely_around_origin(corners));
}

// Two balls of whole radii and centres, the one inside of the other: they touch where the point of the greatest value,
// which is rounded, lies a little outside of the ball.
TEST(QuadricContactConstants, ABallThatTouchesAnotherFromWithinIsHeld) {
  const double radius = 0x1.fcp+0, inner = 0x1.88p-1;
  const Vec3 centre{0x1.2p-2, 0x1.8p-2, -0x1.2p+0};
  ASSERT_EQ(squared_between(centre, {}), square_of_number(exact(radius) - exact(inner)));
  const PosedQuadric a = ball_in_contact(radius, {}), b = ball_in_contact(inner, centre);
  const PairFrame frame = pair_frame(a, b);
  EXPECT_NE(is_held(UnitFrame(QuadricBody(a, frame)), QuadricBody(b, frame)), Within::no);
}

// A corner of the box lies above the end of the cylinder, by little beside their sizes.
TEST(QuadricContactConstants, TheDistanceOfAnEndAndACornerIsRounded) {
  const Mat3 turn_a{{Vec3{-0x1.864482b4c7098p-1, -0x1.385b6e2fd6023p-1, -0x1.bb0c2c9b61f14p-3},
                     Vec3{-0x1.0f1e52bce5983p-1, 0x1.8f51b9a1c7444p-1, -0x1.55a906270b038p-2},
                     Vec3{0x1.7d355d3aa370ap-2, -0x1.1e3fbfcaf3057p-3, -0x1.d5c793d9493cp-1}}};
  const Mat3 turn_b{{Vec3{-0x1.4ab86970bb1cp-2, 0x1.80478199434a3p-1, -0x1.272d4aa6ae114p-1},
                     Vec3{0x1.129408a9a158ep-2, -0x1.05f4cbbc30ab4p-1, -0x1.a1f0e13e46222p-1},
                     Vec3{-0x1.d0b4bf38bbd9ep-1, -0x1.ac435ed9492cbp-2, -0x1.2701f2582fcep-5}}};
  const double half = 0x1.38bcfc057e746p-1;
  const PosedQuadric a(Cylinder(0x1.ca26a1a840992p-1, half), {turn_a, {0, 0, 0}});
  const PosedPolytope b(Box({0x1.239726b2542d7p-2, 0x1.4bb3a02add4bdp-3, 0x1.5f7cf98ab4b21p-3}),
                        {turn_b, {-0x1.cb4cabf1ebe8cp-4, -0x1.b73b7d6a0f082p-2, -0x1.c731f4651349p-1}});
  const auto found = axial_box_distance(a, b);
  ASSERT_TRUE(found);
  const auto normal = oracle::cross(exact(turn_a.column(0)), exact(turn_a.column(1)));
  Rational lowest = oracle::dot(normal, exact(b.vertex(0)));
  for (Index i = 1; i < 8; ++i) lowest = std::min(lowest, oracle::dot(normal, exact(b.vertex(i))));
  const Rational gap = lowest - exact(half) * oracle::dot(normal, exact(turn_a.column(2)));
  EXPECT_LE(square_of_number(exact(found->lower)) * oracle::dot(normal, normal), square_of_number(gap));
  EXPECT_GE(square_of_number(exact(found->upper)) * oracle::dot(normal, normal), square_of_number(gap));
}

// The middle of a tiny box is in a needle, at its end.
TEST(QuadricContactConstants, ABoxAtTheEndOfANeedleIsNotParted) {
  const Mat3 turn{{Vec3{0x1.7e5f244b746acp-3, 0x1.b6ea7fbe114b7p-1, -0x1.eb5c3af5794b8p-2},
                   Vec3{0x1.b7033852921d5p-1, 0x1.8a0d58b0cbbb8p-4, 0x1.02d0e929a451bp-1},
                   Vec3{0x1.eb03dc12a8c6ap-2, -0x1.02fad3571d9bfp-1, -0x1.6f2689baff3dcp-1}}};
  const Vec3 middle{0x1.6aa9d26739c1p-2, -0x1.7e0dd9440d1e3p-2, 0x1.0efc91df6c0cdp-1};
  const double half = 0x1.79e5ab2338f2dp-1;
  const auto normal = oracle::cross(exact(turn.column(0)), exact(turn.column(1)));
  ASSERT_LE(oracle::dot(normal, -exact(middle)), exact(half) * oracle::dot(normal, exact(turn.column(2))));
  const PosedQuadric needle(Cylinder(0x1p-40, half), {turn, middle});
  EXPECT_NE(axial_box_contact(needle, PosedPolytope(Box({0x1p-58, 0x1p-58, 0x1p-58}))), QuadricContact::apart);
}

// The line passes next to the ball's surface, and begins so far away that the nearest place on it is rounded.
TEST(QuadricContactConstants, ARayFromAfarThatGrazesABallIsRounded) {
  const Vec3 origin{-0x1.647b56fda77dp+8, -0x1.82d36f6687b2cp+9, -0x1.7ca59526f986bp+9};
  const Vec3 motion{0x1.235ed08520e6ep+9, 0x1.3d13a5c95fc67p+10, 0x1.376e62f31aa3ap+10};
  const Vec3 centre{-0x1.b938e1a7493b4p-1, 0x1.8edecf836a394p-2, 0x1.2eb00ca8d2c54p-2};
  const std::optional<Cast> found = cast_ray(origin, motion, ball_in_contact(1, centre));
  ASSERT_TRUE(found);
  const auto from = exact(origin) - exact(centre);
  const Rational nearest = -oracle::dot(from, exact(motion)) / oracle::dot(exact(motion), exact(motion));
  const auto beyond = [&](double time) {
    const auto way = from + exact(time) * exact(motion);
    return oracle::dot(way, way) - Rational(1);
  };
  EXPECT_TRUE(exact(found->lower) < nearest && beyond(found->lower) >= 0);
  EXPECT_TRUE(exact(found->upper) >= nearest || beyond(found->upper) <= 0);
}

// The tip of a needle lies next to a vertex of a triangle, in the middle of its longest side but for little. The
// direction is across the triangle, so that the heights of the other two vertices are rounding.
TEST(QuadricContactConstants, OtherVerticesAreRoundedWhereTheyAreFar) {
  const Triangle triangle{{Vec3{0x1.589708ea49bp-5, 0x1.f57be5d4b266p-5, -0x1.871b9afb7602p-4},
                           Vec3{0x1.891f4f02da2bap-5, -0x1.25eb2e91cc215p-2, -0x1.527ff181f8b97p-2},
                           Vec3{0x1.1958812e01238p-5, 0x1.2d06426bd1a38p-2, 0x1.eacb35b90415p-5}}};
  const Vec3 across{0x1.6a11fcfb397acp-2, 0x1.0e11cdb495c97p-1, -0x1.8b8409421f084p-1};
  const Vec3 middle{0x1.4f9b5eaf821dbp-5, 0x1.f770f4258fdb2p-5, -0x1.188a8432daf51p+0};
  const PosedQuadric needle(Cone(0x1p-60, 1), {{}, middle});
  FastSide tip, vertex;
  tip.size = vertex.size = 1;
  tip.generator[0] = 1;
  tip.weight = vertex.weight = {1, 0, 0};
  const FastDistance found = proved_interval(needle, PosedPolytope(triangle), tip, vertex, across);
  const oracle::ConvexSet point{{exact(middle) + exact(Vec3{0, 0, 1})}, {}};
  EXPECT_GT(found.lower, 0);
  EXPECT_LE(square_of_number(exact(found.lower)),
            oracle::squared_distance(point, oracle::triangle_set(triangle[0], triangle[1], triangle[2])));
}

// The depth has 27 digits there, and lies beyond the middle between two doubles: the nearest one is more.
TEST(QuadricContactConstants, ADepthBelowNormalDoublesIsRoundedDown) {
  const double r = 0x1.cda0e546aaf7p-1002, s = 0x1.797efaca4dbdap-1002;
  const Vec3 centre{-0x1.e19154e2f36adp-1002, -0x1.bfdcab4b8316p-1002, 0x1.0498b3fcca9dap-1001};
  const Penetration found = penetration(ball_in_contact(r, {}), ball_in_contact(s, centre));
  EXPECT_GT(found.lower, 0);
  EXPECT_GE(square_of_number(exact(r) + exact(s) - exact(found.lower)), squared_between(centre, {}));
}

// The steps to two vertices cancel, but not what is rounded of each; a vertex next to the first is the highest.
TEST(QuadricContactConstants, StepsOfAPointThatCancelAreRounded) {
  const Vec3 first{0x1.c39718db678fp-3, 0x1.53f8811759bc8p-3, -0x1.eb859b07c93d2p-1},
      highest{0x1.c399b2a713529p-3, 0x1.53f85de2aad77p-3, -0x1.eb855ef3db17ap-1};
  const Vec3 left{0x1.48e41b674a843p-5, 0x1.7505d91105d11p-1, -0x1.82f741ea48983p-2},
      right{0x1.8b97f03417bc2p-2, -0x1.67a484e704585p-2, -0x1.7ec4855c55a54p+0};
  const Vec3 below{-0x1.614f81364f04p-7, -0x1.7dc2da9c408bap-3, -0x1.61d649ae81904p-1},
      centre{0x1.c39b917312371p-3, 0x1.53fb376d018c1p-3, -0x1.eb85ea2084ec8p-1};
  const double radius = 0x1.d097b0c1155fap-29;
  const ConvexHull hull(std::vector<Vec3>{first, highest, left, right, below});
  const PosedPolytope posed(hull);
  const PlainBody body(posed, PairFrame{});
  const auto number_of = [&](const Vec3& point) {
    Index i = 0;
    while (!(posed.vertex(i) == point)) ++i;
    return i;
  };
  const Vec3 upwards{0x1.d9ac10eecc7f4p-2, 0x1.68ddadd9cd241p-1, -0x1.135ea2b28f59bp-1};
  FastSide ball, mean;
  ball.size = 1;
  ball.weight = {1, 0, 0};
  ball.round = -upwards;
  mean.size = 3;
  mean.body = &body;
  mean.generator = {number_of(first), number_of(left), number_of(right)};
  mean.weight = {1 - 0x1.c8ca22ab673eep-2 - 0x1.f0d6a45f24593p-2, 0x1.c8ca22ab673eep-2, 0x1.f0d6a45f24593p-2};
  const FastDistance found = proved_interval(ball_in_contact(radius, centre), posed, ball, mean, upwards);
  EXPECT_LE(square_of_number(exact(found.lower) + exact(radius)), squared_between(centre, highest));
}

// Seen from the origin of the frame, the tip is rounded to within the radius around the core.
TEST(QuadricContactConstants, ATipJustBeyondARoundedShapeIsNotHeld) {
  const double radius = 0x1.8p-12, half_height = 0x1p-14 + 0x1p-54;
  const Vec3 middle{1, 1, 1 + radius - 0x1p-14};
  ASSERT_GT(exact(middle.z) + exact(half_height), exact(1) + exact(radius) + exact(0x1p-60));
  const PosedQuadric cone(Cone(0x1p-20, half_height), {{}, middle});
  const PosedPolytope core(Segment({1, 1, 1}, {1, 1, 0}));
  EXPECT_NE(is_held_by_offset(QuadricBody(cone, PairFrame{}), core, radius + 0x1p-60), Within::yes);
}

// For a ball beside a tiny one the length of the direction rounds up, and its product with the point that lies there,
// drawn in by ten roundings, nearly as much.
TEST(QuadricContactConstants, WhatABallReachesBeyondItsPointIsRounded) {
  const Vec3 centre{-0x1.d54700bc65f08p-2, -0x1.30b8ba70285bp-1, -0x1.4b05f1dd839d8p-4};
  const double tiny = 0x1p-40, radius = 0x1.82ce4e2114761p-1;
  FastSide on_a, on_b;
  on_a.size = on_b.size = 1;
  on_a.weight = on_b.weight = {1, 0, 0};
  on_a.round = -centre;
  on_b.round = centre;
  const FastDistance found =
      proved_interval(ball_in_contact(tiny, centre), PosedPolytope(Sphere(radius), Pose{}), on_a, on_b, centre);
  EXPECT_GT(found.lower, 0);
  EXPECT_LE(square_of_number(exact(found.lower) + exact(radius) + exact(tiny)), squared_between(centre, {}));
}

}  // namespace
}  // namespace toccata::test
