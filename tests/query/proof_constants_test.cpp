// Witnesses: with a constant that a proof rests on made a few times too small, these doubles give a false statement
// (docs/design/proof-constants.md).
#include <gtest/gtest.h>

#include "oracle/rational.hpp"
#include "query/decomposition/cut_plane.hpp"
#include "query/inside/enclose.hpp"
#include "query/posed_shape.hpp"

namespace toccata {
namespace {

using oracle::exact;

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

TEST(ProofConstants, TheSideOfACuttingPlaneIsExact) {
  const Vec3 through{-0x1.be8f4817481cp-6, -0x1.e7a6b9ca0e33ap-1, 0x1.9cd280924d262p-1};
  const Vec3 normal{0x1.5e9940bd59efap-1, 0x1.2da6316f48f94p-1, -0x1.5d89902014af8p-3};
  const Vec3 point{-0x1.7632cdf6434b2p-2, -0x1.979ab9f638f06p-1, -0x1.62606d8ffb6p-7};
  const auto height = oracle::dot(exact(point) - exact(through), exact(normal));
  const Sign expected = height > 0 ? Sign::positive : height < 0 ? Sign::negative : Sign::zero;
  EXPECT_EQ(CutPlane({through, normal}).side(point), expected);
}

}  // namespace
}  // namespace toccata
