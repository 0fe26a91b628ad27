// Witnesses: with a constant that a proof rests on made a few times too small, these doubles give a false statement
// (docs/design/proof-constants.md).
#include <gtest/gtest.h>

#include <cmath>

#include "motion/feature_boxes.hpp"
#include "motion/separating_direction.hpp"
#include "motion/volume_filter.hpp"
#include "oracle/rational.hpp"
#include "toccata/core/random.hpp"

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

// Of numbers of one size and times of few bits the sum is off by a unit and a half at most.
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

}  // namespace
}  // namespace toccata
