// Witnesses: with a constant that a proof rests on made a few times too small, these doubles give a false statement
// (docs/design/proof-constants.md).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <span>

#include "bounds/box_bounds.hpp"
#include "bounds/frame.hpp"
#include "bounds/posed_bounds.hpp"
#include "bounds/upper_sum.hpp"
#include "oracle/rational.hpp"
#include "toccata/bounds/all_volumes.hpp"
#include "toccata/bounds/kdop.hpp"
#include "toccata/bounds/obb.hpp"

namespace toccata::test {
namespace {

using oracle::exact;
using oracle::Rational;

// Each of the small products is half a unit in the last place of the sum, and is lost.
TEST(ProofConstants, AnUpperSumCoversProductsThatAreLost) {
  UpperSum sum;
  sum.add(1, 1);
  for (int i = 0; i < 31; ++i) sum.add(0x1p-53, 1);
  EXPECT_GE(exact(sum.bound()), exact(1) + Rational(31) * exact(0x1p-53));
}

TEST(ProofConstants, AnUpperSumOfAProductThatUnderflowsIsPositive) {
  UpperSum sum;
  sum.add(0x1p-540, 0x1p-540);
  EXPECT_GT(sum.bound(), 0);
}

// This length is computed too small by more than one unit in its last place.
TEST(ProofConstants, ALengthRoundedUpIsNotBelowTheExactOne) {
  const Vec3 v{-0x1.991d4badf7dccp-1, 0x1.30238d2551966p-1, 0x1.5445484f26e8cp-1};
  const Rational bound = exact(length_bound(v));
  EXPECT_GE(bound * bound, oracle::dot(exact(v), exact(v)));
}

TEST(ProofConstants, ALengthOfLeastDoublesIsRoundedUp) {
  const double least = std::numeric_limits<double>::denorm_min();
  const Rational bound = exact(length_bound({least, least, 0}));
  EXPECT_GE(bound * bound, Rational(2) * exact(least) * exact(least));
}

// The double nearest to the root of 2 lies above it.
TEST(ProofConstants, AGapOfBoxesIsNotAboveTheExactOne) {
  const Rational gap = exact(box_gap({{0, 0, 0}, {0, 0, 0}}, {{1, 1, 0}, {1, 1, 0}}));
  EXPECT_LE(gap * gap, Rational(2));
}

TEST(ProofConstants, ABoxIsEnteredNotBeforeTheComputedTime) {
  const double from = 0x1.7e123e465ea44p-2, to = 0x1.d224aeb0613cp-1, motion = 0x1.ab6e02afe727ep-1;
  const double entry = box_entry({{0, 0, 0}, {from, 1, 1}}, {motion, 0, 0}, {{to, 0, 0}, {2, 1, 1}});
  EXPECT_LE(exact(entry) * exact(motion), exact(to) - exact(from));
}

// The world vertex of 3 is rounded up by 1, and the image of the middle, 1.5, by 0.5.
TEST(ProofConstants, APosedBoxFarAwayContainsRoundedVertices) {
  const Obb box{{1.5, 0, 0}, {}, {1.5, 0, 0}};
  const Pose pose{{}, {0x1p53, 0, 0}};
  const Obb far = posed(box, pose);
  const Rational vertex = exact(oracle::world_vertex(pose, {3, 0, 0}).x);
  ASSERT_EQ(far.axes, Mat3{});
  EXPECT_LE(vertex - exact(far.centre.x), exact(far.half.x));
}

// A point of the slim box, on its end, is another box. The axes use up some of what they may be off by.
TEST(ProofConstants, AnOrientedBoxMeetsAPointOfItself) {
  const Mat3 axes{{Vec3{0x1.23a7d70e35f66p-10, -0x1.35c3a4124c6a5p-2, -0x1.e802f08639013p-1},
                   Vec3{-0x1.fc6b44bc5552fp-1, 0x1.cb8c0787ef773p-4, -0x1.2d311b4d0f6ffp-5},
                   {0x1.e39269084d9fbp-4, 0x1.e49e85577f4dfp-1, -0x1.337849eb6f993p-2}}};
  const Obb box{{0x1.5747c75b268e4p-1, -0x1.7639558d20b88p-1, 0x1.9847b90a63c72p-1},
                axes,
                {0x1.2d934947dce7bp-1, 0x1.c319b4241621fp-12, 0x1.2c3d84d8fb517p-12}};
  const Vec3 point{0x1.5795f790e28f8p-1, -0x1.d1784308e54acp-1, 0x1.e35c427d81cc8p-3};
  // Its coordinates in the frame by Cramer's rule.
  const auto determinant = [](const auto& u, const auto& v, const auto& w) {
    return oracle::dot(oracle::cross(u, v), w);
  };
  const auto way = exact(point) - exact(box.centre), u = exact(axes[0]), v = exact(axes[1]), w = exact(axes[2]);
  const Rational whole = abs(determinant(u, v, w));
  ASSERT_LE(abs(determinant(way, v, w)), whole * exact(box.half.x));
  ASSERT_LE(abs(determinant(u, way, w)), whole * exact(box.half.y));
  ASSERT_LE(abs(determinant(u, v, way)), whole * exact(box.half.z));
  EXPECT_TRUE(overlap(box, Obb{point, {}, {0, 0, 0}}));
  EXPECT_TRUE(overlap(Obb{point, {}, {0, 0, 0}}, box));
}

// (1, 0, 0) is the first axis less 2^-46 times the second, with which its product is 0.
TEST(ProofConstants, CoordinatesInAFrameThatIsNotQuiteOrthonormal) {
  const Mat3 axes{{Vec3{1, 0x1p-46, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}};
  EXPECT_GE(coordinate_bounds(axes, {0, 0, 0}, {1, 0, 0}).y, 0x1p-46);
}

template <class V, std::size_t count>
V fitted(const std::array<Vec3, count>& points) {
  return fit<V>(std::span<const Vec3>(points));
}

// Two points far apart: what the box's length lets `contains` be off by is more than how wide the box is.
TEST(ProofConstants, TwoPointsAreInTheBoxThatTheirBoxesMake) {
  const Vec3 p{0, 0, 0}, q{1, 0, 0};
  const Obb merged = merge(fitted<Obb>(std::array{p}), fitted<Obb>(std::array{q}));
  EXPECT_TRUE(contains(merged, p));
  EXPECT_TRUE(contains(merged, q));
}

TEST(ProofConstants, TwoPointsAreInTheEllipsoidThatTheirEllipsoidsMake) {
  const Vec3 p{0x1.dc097e086147ep-2, 0x1.e00402e550374p-1, 0x1.bfdf79277fd5ep-2};
  const Vec3 q{0x1.4c82e6daccbc6p+0, 0x1.e00a51340ad32p-1, 0x1.23f5610ffd1c1p-2};
  const auto merged = merge(fitted<EllipsoidBound>(std::array{p}), fitted<EllipsoidBound>(std::array{q}));
  EXPECT_TRUE(contains(merged, p));
  EXPECT_TRUE(contains(merged, q));
}

// The middle of two neighbouring doubles is rounded to one of them.
TEST(ProofConstants, TwoPointsFarAwayAreInTheEllipsoidThatTheirEllipsoidsMake) {
  const Vec3 p{0x1p40, 0, 0}, q{0x1p40 + 0x1p-12, 0, 0};
  const auto merged = merge(fitted<EllipsoidBound>(std::array{p}), fitted<EllipsoidBound>(std::array{q}));
  EXPECT_TRUE(contains(merged, p));
  EXPECT_TRUE(contains(merged, q));
}

TEST(ProofConstants, AnEllipsoidThatHasGrownAroundTwoPointsHoldsThem) {
  const std::array points{Vec3{0x1.8c25e6225b551p-4, -0x1.9c6b7652b8ceep-1, -0x1.d7ce6d5878b2p-2},
                          Vec3{0x1.8beb34ed04bb9p-4, -0x1.9c6c80f6a6fd7p-1, -0x1.d7af62d9fdbb3p-2}};
  const auto around = fitted<EllipsoidBound>(points);
  EXPECT_TRUE(std::ranges::all_of(points, [&](const Vec3& p) { return contains(around, p); }));
}

// The product of a rotation's least entry with the direction is lost, and the box reaches very far along it.
TEST(ProofConstants, APosedBoxIsBoundedWhereTheTurnedDirectionUnderflows) {
  const double far = 0x1p1000, least = std::numeric_limits<double>::denorm_min();
  Pose pose;
  pose.linear[0].y = least;
  const Aabb box{{0, -far, 0}, {0, far, 0}};
  const Vec3 vertex = oracle::world_vertex(pose, {0, far, 0});
  EXPECT_GE(PosedSupport(box, pose)({0.5, 0, 0}, {}), 0.5 * vertex.x);
}

template <std::size_t k>
std::size_t slab_of(const Vec3& normal) {
  constexpr auto normals = kdop_normals<k>();
  return static_cast<std::size_t>(std::find(normals.begin(), normals.end(), normal) - normals.begin());
}

// The direction is (1, 1, 0) and (1, 0, 1), each just less than half, and twice as much of (1, 0, 0) as is computed.
TEST(ProofConstants, APartOfADirectionThatCancelsIsCovered) {
  const double less_than_half = 0.5 - 0x1p-54;
  Kdop<18> volume;
  volume.lower.fill(-5000);
  volume.upper.fill(5000);
  volume.upper[0] = 1000;
  volume.upper[slab_of<18>({1, 1, 0})] = volume.upper[slab_of<18>({1, 0, 1})] = 0;
  const Vec3 point{1000, -1000, -1000}, direction{1, less_than_half, less_than_half};
  for (std::size_t i = 0; i < Kdop<18>::slabs; ++i) {
    const double height = dot(kdop_normals<18>()[i], point);  // of whole numbers
    ASSERT_TRUE(volume.lower[i] <= height && height <= volume.upper[i]);
  }
  EXPECT_GE(exact(support_bound(volume, direction, {})), oracle::dot(exact(direction), exact(point)));
}

// 1 + 2^-53 rounds to 1: the sum of the coordinates is 2^-52, and seems to be half of that.
TEST(ProofConstants, APointBeyondASlabByLessThanRoundingIsSeenBeyondIt) {
  const std::size_t slab = slab_of<14>({1, 1, 1});
  Kdop<14> volume;
  volume.lower.fill(-10);
  volume.upper.fill(10);
  volume.upper[slab] = 0x1.8p-53;
  const Vec3 point{1, 0x1p-53, -1 + 0x1p-53};
  ASSERT_EQ((exact(point.x) + exact(point.y)) + exact(point.z), exact(0x1p-52));
  EXPECT_EQ(kdop_region(point, volume) >> (2 * slab + 1) & 1U, 1U);
}

}  // namespace
}  // namespace toccata::test
