// Witnesses: with a constant that a proof rests on made a few times too small, these doubles give a false statement
// (docs/design/proof-constants.md).
#include <gtest/gtest.h>

#include <cmath>

#include "motion/approach.hpp"
#include "motion/convex_gap.hpp"
#include "motion/feature_boxes.hpp"
#include "motion/moving_part.hpp"
#include "motion/point_bounds.hpp"
#include "motion/scaled_polygon.hpp"
#include "motion/separating_direction.hpp"
#include "motion/volume_filter.hpp"
#include "oracle/rational.hpp"
#include "toccata/core/random.hpp"
#include "toccata/motion/rigid_motion.hpp"
#include "toccata/motion/time_of_impact.hpp"
#include "toccata/narrow/convex_convex.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {
namespace {

using oracle::exact;

// The points of the filter of orient3d, at rest.
TEST(ProofConstants, TheVolumeOfAMovingPolygonCoversItsRoundings) {
  const Vec3 a{0x1.1834dd2dcdd16p-1, 0x1.affa6a4b79488p-3, -0x1.04086ee60e364p-2},
      b{0x1.92804f4d6d5ep-4, 0x1.fe7897ca9b1bep-1, -0x1.4682aa1b5aa58p-3},
      c{0x1.1d90bc8aa451p-4, 0x1.89643db1297a8p-3, -0x1.288064c1ddeep-1},
      d{0x1.e55071cbb63b9p-1, -0x1.ea830e9b174a1p-2, -0x1.5491609d83afbp-2};
  const RoundedCorner p{b - a, b - a}, q{c - a, c - a}, r{d - a, d - a};
  const BernsteinVolume volume = bernstein_volume(p, q, r);
  const oracle::Rational truth = oracle::orientation(exact(a), exact(b), exact(c), exact(d));
  EXPECT_LE(abs(exact(volume.start) - truth), exact(volume.error));
  EXPECT_LE(abs(exact(volume.near_start) - 3 * truth), 3 * exact(volume.error));
}

// A difference and two sums, each of which loses half a unit.
TEST(ProofConstants, ADotProductWithACornerCoversItsRoundings) {
  const double half_unit = 0x1p-53, tail = -0x1.ffffffffffffep-54;
  const Vec3 corner{1 - tail, half_unit, half_unit}, direction{1, 1, 1};
  const RoundedPolygon<3> corners{{{corner, corner}, {corner, corner}, {corner, corner}}};
  const PolygonSpan<3> span{corners, greatest_magnitudes(corners)};
  const oracle::Rational truth = (exact(1) - exact(tail)) + exact(half_unit) + exact(half_unit);
  EXPECT_LE(abs(exact(dot(direction, corner)) - truth), exact(span.slack(direction)));
}

// The sum of numbers of one size and times of few bits is off by a unit and a half at most.
TEST(ProofConstants, ABoxAroundAMomentContainsThePointThen) {
  Random random(8);
  for (int i = 0; i < 1000; ++i) {
    const MovingPoint point{{random.between(-1, 1), random.between(1, 2), 0x1p-1074},
                            {random.between(-1, 1), random.between(1, 2), 0x3p-1074}};
    const double time = std::ldexp(static_cast<double>(random.below(std::uint32_t{1} << 30U)), -30);
    const Aabb box = moment_box(point, time);
    for (int axis = 0; axis < 3; ++axis) {
      const oracle::Rational at =
          exact(point.start[axis]) + exact(time) * (exact(point.end[axis]) - exact(point.start[axis]));
      ASSERT_LE(exact(box.lower[axis]), at) << i;
      ASSERT_GE(exact(box.upper[axis]), at) << i;
    }
  }
}

// The mean of both ends is rounded up by a unit, and what the way takes from it to half a unit below 1.
TEST(ProofConstants, AGapBetweenTwoTimesCoversItsRoundings) {
  const double unit = 0x1p-53, start = 1, end = 1 + 6 * unit, speed = 7 * unit;
  const double least = least_between(start, end, 1, {.speed = speed, .bending = HUGE_VAL});
  EXPECT_LE(exact(least), (exact(start) + exact(end) - exact(speed)) / 2);
}

// The length of (1, 1, 1) is rounded down.
TEST(ProofConstants, ASeparationAlongADirectionIsNotTooShort) {
  const oracle::Rational length = exact(separation_along(Vec3{1, 1, 1}, 1.0));
  EXPECT_GE(length * length, 3);
}

// A direction of length 1 but for rounding: its square is more by 0.8 units, and the sum of its coordinates is rounded
// up by one.
const Vec3 long_direction{0x1.1c01aa03be896p-1, 0x1.aa027f059dce1p-1, 0};

template <class S>
double lowest_of(const S& set, const Vec3& direction) {
  return lowest(PlacedSet<S>([&] { return set; }), direction);
}

TEST(ProofConstants, ABallReachesAsFarAsADirectionIsLong) {
  const oracle::Rational low = exact(lowest_of(PosedPolytope(Sphere(1)), long_direction));
  EXPECT_LT(low, 0);
  EXPECT_GE(low * low, oracle::dot(exact(long_direction), exact(long_direction)));
}

TEST(ProofConstants, TheLowestPointOfAQuadricCoversItsRoundings) {
  const Vec3 centre{1, 1, 0};
  const PosedQuadric small(Ellipsoid({0x1p-80, 0x1p-80, 0x1p-80}), Pose::translation(1, 1, 0));
  EXPECT_LE(exact(lowest_of(small, long_direction)), oracle::dot(exact(long_direction), exact(centre)));
}

// The height of the half-space's point is rounded down by a unit and a half.
TEST(ProofConstants, TheHeightOfAHalfSpaceCoversItsRoundings) {
  const Vec3 normal{1, 2, 0}, point{0.0625, 1.3125, 0}, up = normalized(normal);
  const PlacedSet<PosedPolytope> origin([] { return PosedPolytope(Point({0, 0, 0})); });
  const PlacedSet<PosedHalfSpace> ground([&] { return PosedHalfSpace(HalfSpace(point, normal)); });
  EXPECT_LE(exact(separation_along(origin, ground, up)), -oracle::dot(exact(up), exact(point)));
}

// A tetrahedron whose faces are 0.993 from the origin, and a point there. They are parted when either is a pad wrong.
TEST(ProofConstants, SetsThatOverlapByLessThanTheirPadMayBeApart) {
  std::vector<Vec3> corners;
  for (const Vec3& corner : tetrahedron_corners) corners.push_back(1.72 * corner);
  const ConvexHull hull(corners);
  const PosedPolytope tetrahedron(hull), point(Point({0, 0, 0}));
  const double way = 0.998 / std::sqrt(3);
  for (const double side : {-1.0, 1.0}) {
    const PosedPolytope wrong = tetrahedron.moved(side * Vec3{way, way, way});
    if (!overlap(wrong, point)) {
      EXPECT_FALSE(overlap_by(tetrahedron, point, 1, tetrahedron_corners));
      EXPECT_TRUE(overlap_by(tetrahedron, point, 0.8, tetrahedron_corners));
      return;
    }
  }
  FAIL() << "no side of the tetrahedron is near enough";
}

// At the start of the cell in which it comes through the plane the vertex is still before an edge, and beyond it then.
TEST(ProofConstants, ACornerMayPassASideWithinACell) {
  const double edge = 1 - 0x1p-44;
  const auto rests = [](const Vec3& p) { return MovingPoint{p, p}; };
  const VertexFace pair{.vertex = {{0, 0, -1}, {3, 0, 2}},
                        .face = {rests({edge, -1, 0}), rests({edge, 1, 0}), rests({-1, 0, 0})}};
  EXPECT_FALSE(time_of_impact(pair));
}

// A face and a vertex, half a unit apart along (1, d, 0), go almost at right angles to it, far and together. What each
// goes along it, three eighths of a unit and against the other, is lost in the rounding of d y.
TEST(ProofConstants, WaysAcrossADirectionMayLeadAlongIt) {
  const double unit = 0x1p-12, d = 0.75 + unit, y = 0x1.ep40 + 0.625, x = d * y;
  ASSERT_EQ(d * (y + unit), x);
  const Vec3 foot{-unit, 2 * unit, 0}, along{-d, 1, 0}, up{0, 0, 1}, way_of_face{x, -(y + unit), 0};
  const auto goes = [](const Vec3& p, const Vec3& way) { return MovingPoint{p, p + way}; };
  const VertexFace pair{.vertex = goes({0, 0, 0}, {x, -y, 0}),
                        .face = {goes(foot - along - up, way_of_face), goes(foot - along + 3 * up, way_of_face),
                                 goes(foot + 3 * along - up, way_of_face)}};
  const double fraction = independent_fraction(differences(pair), 0);
  EXPECT_GT(fraction, 0);
  EXPECT_LT(exact(fraction) * (exact(d) * exact(unit)), oracle::dot(exact(Vec3{1, d, 0}), exact(foot)));
}

// What is fixed to a shape turns about a point that is rounded, and so beside the shape's, which rests: by a quarter of
// a unit that is not seen, where it is shifted by one and a half, and by 2^-23 where it is almost flat.
TEST(ProofConstants, WhatIsCarriedMovesNoFasterThanIsTold) {
  const MotionSpeed turning{.centre = {1, 2, 0.3}, .turns = 1};
  const RigidMotion motion = RigidMotion::of([](double) { return Pose{}; }, turning);
  const Pose shifted = Pose::translation(0x3p-54, 0, 0);
  const Pose flat{{{Vec3{1, 1, 0}, Vec3{1, 1 + 0x1p-30, 0}, Vec3{0, 0, 1}}}, {0.1, 0.2, 0.3}};
  for (const Pose& fixed : {shifted, flat}) {
    const MotionSpeed told = motion.carrying(fixed).speed();
    oracle::Rational square = 0;
    for (int i = 0; i < 3; ++i) {
      const oracle::Rational beside =
          oracle::dot(exact(fixed.linear[i]), exact(told.centre)) + exact(fixed.offset[i]) - exact(turning.centre[i]);
      square += beside * beside;
    }
    EXPECT_LE(36 * square, exact(told.speed) * exact(told.speed));
  }
}

// What is left of a million turns is a part of one that is rounded away.
TEST(ProofConstants, APoseOfManyTurnsIsNoFartherOffThanIsTold) {
  const double turns = 0x1p20 + 0x1p-32, time = 1 - 0x1p-53;
  ASSERT_EQ(turns * time, 0x1p20);
  const oracle::Rational left = exact(turns) * exact(time) - exact(0x1p20);
  const Model point(Point({1, 0, 0}));
  const RigidMotion motion(Pose{}, {.axis = {0, 0, 1}, .turns = turns});
  const std::vector<MovingPart> parts = moving_parts(point, motion, Solid::automatic, "a point");
  // Its sine is more than 6.28 times as much.
  const double posed = (motion.at(time) * Vec3{1, 0, 0}).y;
  EXPECT_LE(exact(6.28) * left - exact(posed), exact(parts[0].motion({}).alike.pad));
}

}  // namespace
}  // namespace toccata
