// Witnesses: with a constant that a proof rests on made a few times too small, these doubles give a false statement
// (docs/design/proof-constants.md).
#include <gtest/gtest.h>

#include "broad/exact_balls.hpp"
#include "broad/own_bounds.hpp"
#include "oracle/rational.hpp"
#include "toccata/broad/broad_phase.hpp"

namespace toccata {
namespace {

using oracle::exact;

// Apart by so little that the squares round to the wrong order.
TEST(ProofConstants, BallsThatAreAlmostInTouchAreDecidedExactly) {
  const Ball a{{0x1.a1d7d9ad45d5ep+0, 0x1.435e9ee1733f2p+0, 0x1.07707d9a3513p+0}, 0x1.5e44e5bb8bf6p-2};
  const Ball b{{0x1.187ae08cdf17ap-4, 0x1.277cacd33e1f8p-4, 0x1.1e89b4eca642dp-4}, 0x1.d858272800a53p+0};
  const auto way = exact(a.centre) - exact(b.centre);
  const auto reach = exact(a.radius) + exact(b.radius);
  ASSERT_GT(oracle::dot(way, way), reach * reach);
  EXPECT_FALSE(balls_meet(a, b));
}

// 1 - 2^-55 and 1 + 2^-55 round to 1.
TEST(ProofConstants, ABoxGrowsByAMarginThatRoundsToNothing) {
  const double margin = 0x1p-55;
  const Aabb box = offset_outward(Aabb{{1, 1, 1}, {1, 1, 1}}, margin);
  EXPECT_LE(exact(box.lower.x), exact(1) - exact(margin));
  EXPECT_GE(exact(box.upper.x), exact(1) + exact(margin));
}

// An axis that is 2^-47 too short, as axes may be: the coordinate of a point at the distance 1 is greater than 1.
TEST(ProofConstants, AnOrientedBoxGrowsByMoreThanTheMargin) {
  const Mat3 axes{{Vec3{1 - 0x1p-47, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}};
  const Obb grown = offset_outward(Obb{{0, 0, 0}, axes, {0, 0, 0}}, 1);
  EXPECT_GE(exact(grown.half.x) * exact(axes[0].x), exact(1));
}

// Proofs about oriented boxes need axes to be of length 1 up to 2^-46, as the second ones are.
TEST(ProofConstants, AxesThatAreNotOfLengthOneAreRefused) {
  const auto box_along = [](double x) { return Obb{{}, {{Vec3{x, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}}, {1, 1, 1}}; };
  EXPECT_NE(complaint_about(box_along(1 + 0x1p-45)), "");
  EXPECT_EQ(complaint_about(box_along(1 + 0x1p-47)), "");
}

}  // namespace
}  // namespace toccata
