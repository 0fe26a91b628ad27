#include "oracle/motion.hpp"

#include <gtest/gtest.h>

namespace toccata::oracle {
namespace {

MovingPoint resting(const Vec3& p) { return {p, p}; }

/// The triangle (0, 0, 0), (1, 0, 0), (0, 1, 0), which rests.
const std::array<MovingPoint, 3> corner_of_the_plane{resting({0, 0, 0}), resting({1, 0, 0}), resting({0, 1, 0})};

/// The time is this number exactly.
testing::AssertionResult is_at(const std::optional<AlgebraicNumber>& contact, const Rational& time) {
  if (!contact) return testing::AssertionFailure() << "no contact";
  if (compared(*contact, time) != 0) return testing::AssertionFailure() << "another time";
  return testing::AssertionSuccess();
}

TEST(OracleMotion, APointThatFallsOntoATriangleMeetsItAtItsHeight) {
  EXPECT_TRUE(
      is_at(contact_time(VertexFace{{{0.25, 0.25, 1}, {0.25, 0.25, -2}}, corner_of_the_plane}), Rational(1, 3)));
  EXPECT_TRUE(is_at(contact_time(VertexFace{{{0.25, 0.25, 1}, {0.25, 0.25, 0}}, corner_of_the_plane}), 1));
  EXPECT_TRUE(is_at(contact_time(VertexFace{{{0.25, 0.25, 0}, {0.25, 0.25, 9}}, corner_of_the_plane}), 0));
  EXPECT_FALSE(contact_time(VertexFace{{{0.75, 0.75, 1}, {0.75, 0.75, -1}}, corner_of_the_plane}));
  EXPECT_FALSE(contact_time(VertexFace{{{0.25, 0.25, 2}, {0.25, 0.25, 0x1p-1074}}, corner_of_the_plane}));
}

TEST(OracleMotion, EdgesAndCornersBelongToTheTriangle) {
  for (const Vec3& p : {Vec3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 0.5, 0}, {0.5, 0, 0}, {0, 0.125, 0}}) {
    EXPECT_TRUE(
        is_at(contact_time(VertexFace{{p + Vec3{0, 0, 1}, p - Vec3{0, 0, 1}}, corner_of_the_plane}), Rational(1, 2)));
    EXPECT_TRUE(is_at(contact_time(VertexFace{resting(p), corner_of_the_plane}), 0));
  }
}

TEST(OracleMotion, APointThatSlidesInThePlaneMeetsTheEdgeFirst) {
  EXPECT_TRUE(is_at(contact_time(VertexFace{{{-1, 0.5, 0}, {3, 0.5, 0}}, corner_of_the_plane}), Rational(1, 4)));
  EXPECT_TRUE(is_at(contact_time(VertexFace{{{-1, 1, 0}, {3, 1, 0}}, corner_of_the_plane}), Rational(1, 4)));
  EXPECT_FALSE(contact_time(VertexFace{{{-1, 1.0625, 0}, {3, 1.0625, 0}}, corner_of_the_plane}));
}

/// One edge turns about the y axis, the other slides along below it: in the middle of the way, where both pass the
/// origin, the distance of their lines is (1 − 2t)² − height.
EdgeEdge grazing_at(double height) {
  return {{MovingPoint{{2, -1, height}, {-2, -1, height}}, MovingPoint{{2, 1, height}, {-2, 1, height}}},
          {MovingPoint{{-2, 0, -1}, {-2, 0, 1}}, MovingPoint{{2, 0, 1}, {2, 0, -1}}}};
}

TEST(OracleMotion, WhatGrazesInADoubleRootIsMet) {
  EXPECT_TRUE(is_at(contact_time(grazing_at(0)), Rational(1, 2)));
  EXPECT_TRUE(is_at(contact_time(grazing_at(0x1p-100)), Rational(1, 2) - Rational(1).scaled(-51)));
  EXPECT_FALSE(contact_time(grazing_at(-0x1p-100)));
}

TEST(OracleMotion, AnIrrationalTimeLiesBetweenItsNeighbouringDoubles) {
  const std::array<MovingPoint, 3> tilting{MovingPoint{{-1, -1, 0}, {-3, -1, 2}}, MovingPoint{{-1, 1, 0}, {-3, 1, 2}},
                                           MovingPoint{{9, 0, -1}, {9, 0, 0}}};
  // In the plane y = 0 the face runs from (−1 − 2t, 2t) to (9, t − 1). The origin lies on it when
  // 2t · 9 + (t − 1)(1 + 2t) = 2t² + 17t − 1 is 0.
  const auto contact = contact_time(VertexFace{resting({0, 0, 0}), tilting});
  ASSERT_TRUE(contact);
  EXPECT_EQ(sign_at(Polynomial({-1, 17, 2}), *contact), 0);
}

TEST(OracleMotion, ATriangleWithoutAreaIsTheSegmentOrThePointThatItIs) {
  const VertexFace onto_segment{{{0.5, 0, 1}, {0.5, 0, -1}},
                                {resting({0, 0, 0}), resting({1, 0, 0}), resting({0.25, 0, 0})}};
  EXPECT_TRUE(is_at(contact_time(onto_segment), Rational(1, 2)));
  const VertexFace past_segment{{{1.5, 0, 1}, {1.5, 0, -1}}, onto_segment.face};
  EXPECT_FALSE(contact_time(past_segment));
  const VertexFace onto_point{{{0, 0, 1}, {0, 0, -3}}, {resting({0, 0, 0}), resting({0, 0, 0}), resting({0, 0, 0})}};
  EXPECT_TRUE(is_at(contact_time(onto_point), Rational(1, 4)));
  const VertexFace past_point{{{0, 1, 1}, {0, 1, -3}}, onto_point.face};
  EXPECT_FALSE(contact_time(past_point));
}

TEST(OracleMotion, ATriangleThatCollapsesForAMomentIsMetThenAlone) {
  // All in one line at t = ½ and in the plane z = 0 always; the vertex lies on that line, beyond the triangle before.
  const std::array<MovingPoint, 3> folding{resting({0, 0, 0}), resting({1, 0, 0}), MovingPoint{{3, 1, 0}, {3, -1, 0}}};
  EXPECT_TRUE(is_at(contact_time(VertexFace{resting({2, 0, 0}), folding}), Rational(1, 2)));
  EXPECT_FALSE(contact_time(VertexFace{resting({4, 0, 0}), folding}));
}

TEST(OracleMotion, EdgesMeetWhereTheyCrossAndNotWhereTheirLinesDo) {
  const std::array<MovingPoint, 2> along_x{resting({-1, 0, 0}), resting({1, 0, 0})};
  const auto falling_at = [](double x) {
    return std::array<MovingPoint, 2>{MovingPoint{{x, -1, 1}, {x, -1, -1}}, MovingPoint{{x, 1, 1}, {x, 1, -1}}};
  };
  EXPECT_TRUE(is_at(contact_time(EdgeEdge{along_x, falling_at(0)}), Rational(1, 2)));
  EXPECT_TRUE(is_at(contact_time(EdgeEdge{along_x, falling_at(1)}), Rational(1, 2)));
  EXPECT_FALSE(contact_time(EdgeEdge{along_x, falling_at(1.0000000000000002)}));
}

TEST(OracleMotion, EdgesOfOneLineMeetEndToEnd) {
  const std::array<MovingPoint, 2> resting_edge{resting({0, 0, 0}), resting({1, 0, 0})};
  const EdgeEdge sliding{resting_edge, {MovingPoint{{3, 0, 0}, {1, 0, 0}}, MovingPoint{{5, 0, 0}, {0, 0, 0}}}};
  EXPECT_TRUE(is_at(contact_time(sliding), Rational(4, 5)));
  const EdgeEdge parallel{resting_edge, {MovingPoint{{3, 1, 0}, {-1, 1, 0}}, MovingPoint{{5, 1, 0}, {-1, 1, 0}}}};
  EXPECT_FALSE(contact_time(parallel));
}

TEST(OracleMotion, EdgesWithoutLengthArePoints) {
  const std::array<MovingPoint, 2> point{resting({0.5, 0, 0}), resting({0.5, 0, 0})};
  const auto falling = [](double y) {
    return std::array<MovingPoint, 2>{MovingPoint{{0, y, 1}, {0, y, 0}}, MovingPoint{{1, y, 1}, {1, y, 0}}};
  };
  EXPECT_TRUE(is_at(contact_time(EdgeEdge{point, falling(0)}), 1));
  EXPECT_FALSE(contact_time(EdgeEdge{point, falling(1)}));
  const std::array<MovingPoint, 2> flying{MovingPoint{{-1, 0, 0}, {2, 0, 0}}, MovingPoint{{-1, 0, 0}, {2, 0, 0}}};
  EXPECT_TRUE(is_at(contact_time(EdgeEdge{point, flying}), Rational(1, 2)));
}

}  // namespace
}  // namespace toccata::oracle
