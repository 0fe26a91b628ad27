#include "toccata/math/predicates.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "math/extreme_doubles.hpp"
#include "math/filter.hpp"
#include "math/orientation_families.hpp"
#include "math/stages.hpp"
#include "toccata/math/pose.hpp"

namespace toccata {
namespace {

using test::FourPoints;
using test::largest;
using test::least;

Sign orientation(const FourPoints& p) { return orient3d(p[0], p[1], p[2], p[3]); }

TEST(Orientation, CounterClockwiseIsPositive) {
  EXPECT_EQ(orient2d(Vec2{0, 0}, {1, 0}, {0, 1}), Sign::positive);
  EXPECT_EQ(orient3d(Vec3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), Sign::positive);
  EXPECT_EQ(orient3d(Vec3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}), Sign::negative);
  EXPECT_EQ(triple_product_sign({{1, 0, 0}, {}}, {{0, 1, 0}, {}}, {{0, 0, 1}, {}}), Sign::positive);
}

TEST(Orientation, DroppingAnAxisKeepsTheTurnSeenAgainstIt) {
  const Vec3 a{1, 0, 0}, b{0, 1, 0}, c{0, 0, 1};
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_EQ(orient2d(drop_axis(a, axis), drop_axis(b, axis), drop_axis(c, axis)), Sign::positive);
}

TEST(Orientation, NegativeZeroEqualsZero) {
  EXPECT_EQ(orient3d(Vec3{0, 0, -0.0}, {1, 0, 0}, {0, 1, -0.0}, {5, 7, 0}), Sign::zero);
  EXPECT_EQ(orient2d(Vec2{-0.0, 0}, {0, -0.0}, {1, 1}), Sign::zero);
}

// In plain doubles all of these products are zero, and so would be the answer.
TEST(Orientation, UnderflowIsNotZero) {
  EXPECT_EQ(orient2d(Vec2{0, 0}, {least, 0}, {0, least}), Sign::positive);
  EXPECT_EQ(orient3d(Vec3{0, 0, 0}, {least, 0, 0}, {0, least, 0}, {0, 0, -least}), Sign::negative);
  EXPECT_EQ(orient3d(Vec3{0, 0, 0}, {1e-200, 0, 0}, {0, 1e-200, 0}, {1, 1, 1e-200}), Sign::positive);
}

// Here the products that underflow are multiplied by a huge number and decide against the one that does not.
TEST(Orientation, UnderflowTimesAHugeNumberStillCounts) {
  const Difference u{{0, 1e-170, 0}, {}}, v{{0, 0, 1e-170}, {}};
  EXPECT_EQ(triple_product_sign(u, v, {{1e300, 0, 0}, {}}), Sign::positive);
  EXPECT_EQ(triple_product_sign(u, v, {{-1e300, 1e300, -1e300}, {}}), Sign::negative);
}

// Two products beside the middle between 0 and the least double: they round apart in the wrong order, because the
// differences were rounded too.
TEST(Orientation, UnderflowDoesNotTurnTheSign) {
  const double above = 0x1.0000000000001p-537;
  EXPECT_EQ(orient2d(Vec2{0x1p-591, 0x1p-590}, {above, above}, {above / 2, above / 2}), Sign::negative);
}

TEST(Orientation, OverflowIsNotAnAnswer) {
  EXPECT_EQ(orient2d(Vec2{-largest, -largest}, {largest, -largest}, {-largest, largest}), Sign::positive);
  const FourPoints corner{{{-largest, -largest, -largest},
                           {largest, -largest, -largest},
                           {-largest, largest, -largest},
                           {-largest, -largest, largest}}};
  EXPECT_EQ(orientation(corner), Sign::positive);
  FourPoints flat = corner;
  flat[3] = {largest, largest, -largest};
  EXPECT_EQ(orientation(flat), Sign::zero);
  flat[3].z = std::nextafter(-largest, 0.0);
  EXPECT_EQ(orientation(flat), Sign::positive);
}

TEST(Orientation, AnUlpFarAwayIsSeen) {
  const double x = 1e15, next = std::nextafter(x, 1e16);
  EXPECT_EQ(orient3d(Vec3{x, x, x}, {x + 1, x, x}, {x, x + 1, x}, {x + 7, x - 3, x}), Sign::zero);
  EXPECT_EQ(orient3d(Vec3{x, x, x}, {x + 1, x, x}, {x, x + 1, x}, {x + 7, x - 3, next}), Sign::positive);
  EXPECT_EQ(orient2d(Vec2{x, x}, {x + 1, x + 1}, {x + 2, std::nextafter(x + 2, 0)}), Sign::negative);
}

TEST(Orientation, EveryPermutationHasItsSign) {
  for (const test::OrientationFamily& family : test::orientation_families()) {
    Random random(7);
    for (int i = 0; i < 40; ++i) {
      const FourPoints points = family.draw(random);
      std::array<std::size_t, 4> order{0, 1, 2, 3};
      do {
        int inversions = 0;
        for (std::size_t j = 0; j < 4; ++j)
          for (std::size_t k = j + 1; k < 4; ++k) inversions += order[j] > order[k];
        const Sign expected = inversions % 2 == 0 ? orientation(points) : -orientation(points);
        ASSERT_EQ(orientation({points[order[0]], points[order[1]], points[order[2]], points[order[3]]}), expected)
            << family.name << ", draw " << i;
      } while (std::next_permutation(order.begin(), order.end()));
    }
  }
}

bool survives_scaling(const FourPoints& points, const FourPoints& scaled, double factor) {
  return points == test::scaled_by(1 / factor, scaled);  // neither under- nor overflow
}

TEST(Orientation, PowersOfTwoAndMirrorsChangeNothingButTheSign) {
  for (const test::OrientationFamily& family : test::orientation_families()) {
    Random random(8);
    for (int i = 0; i < 200; ++i) {
      const FourPoints points = family.draw(random);
      const Sign sign = orientation(points);
      const double factor = test::power_of_two_between(random, -900, 900);
      const FourPoints scaled = test::scaled_by(factor, points);
      if (survives_scaling(points, scaled, factor)) {
        ASSERT_EQ(orientation(scaled), sign) << family.name << ", draw " << i;
      }
      ASSERT_EQ(orientation(test::stretched_by({1, -1, 1}, points)), -sign) << family.name << ", draw " << i;
      ASSERT_EQ(orientation(test::scaled_by(-1, points)), -sign) << family.name << ", draw " << i;
    }
  }
}

// Not a matter of truth but of speed: the filter decides what is not close, and gives up what is.
TEST(Filter, DecidesAlmostAllUniformPointsAndNoCoplanarOnes) {
  Random random(9);
  int open = 0;
  for (int i = 0; i < 1000; ++i) {
    const auto [a, b, c, d] = test::uniform(random);
    const Filtered volume = filtered_orient3d(a, b, c, d);
    open += !volume.is_positive() && !volume.is_negative();
    const auto [e, f, g, h] = test::coplanar(random);
    const Filtered none = filtered_orient3d(e, f, g, h);
    EXPECT_FALSE(none.is_positive() || none.is_negative());
  }
  EXPECT_EQ(open, 0);
}

TEST(MachineIntegers, TakeUpTo60BitsPerAxisAndLeaveTheRest) {
  const Difference x{{0x1p-500, 0, 0}, {}}, y{{0, 0x1p700, 0}, {}};
  const auto sign = [&](const Vec3& head, const Vec3& tail) {
    return triple_product_sign_by_machine_integers(x, y, {head, tail});
  };
  EXPECT_EQ(sign({0, 0, 1}, {0, 0, -0x1p59}), Sign::positive);
  EXPECT_EQ(sign({0, 0, 1}, {0, 0, 0x1p59}), Sign::negative);
  EXPECT_EQ(sign({0x1p-501, 0, -0.0}, {0, 0, 0}), Sign::zero);
  EXPECT_EQ(sign({0, 0, 1}, {0, 0, -0x1p60}), std::nullopt);
  EXPECT_EQ(sign({0, 0, 1e-200}, {0, 0, 1e200}), std::nullopt);
  EXPECT_EQ(sign({0, 0, largest}, {}), std::nullopt);
  EXPECT_EQ(sign({0, 0, least}, {}), std::nullopt);
  EXPECT_EQ(orient2d_by_machine_integers({0x1p59, -0x1p59}, {-0x1p59, 0x1p59}, {-0x1p59, 0x1p59}), Sign::zero);
  EXPECT_EQ(orient2d_by_machine_integers({-0x1p59, -0x1p59}, {0x1p59, -0x1p59}, {0x1p59, 0x1p59}), Sign::positive);
  EXPECT_EQ(orient2d_by_machine_integers({0x1p60, 0}, {1, 0}, {0, 1}), std::nullopt);
}

// The largest determinant the integers may meet, of both signs, and one beside zero that needs all 192 bits.
TEST(MachineIntegers, DoNotOverflow) {
  const double most = 0x1.fffffffffffffp59;
  const Vec3 low{-most, -most, -most};
  const Difference u{{most, -most, -most}, {-most, most, most}}, v{{-most, most, -most}, {most, -most, most}},
      w{{-most, -most, most}, {most, most, -most}};
  EXPECT_EQ(triple_product_sign_by_machine_integers(u, v, w), triple_product_sign_by_integers(u, v, w));
  EXPECT_EQ(triple_product_sign_by_machine_integers(v, u, w), triple_product_sign_by_integers(v, u, w));
  const Difference x{{most, most, 1}, low}, y{{most, most, 0}, low}, z{{most, 1 - most, 3}, {1, -most, 2}};
  EXPECT_EQ(triple_product_sign_by_machine_integers(x, y, z), triple_product_sign_by_integers(x, y, z));
  EXPECT_NE(triple_product_sign_by_integers(x, y, z), Sign::zero);
}

TEST(Expansions, TakeCoplanarPointsOfOrdinarySizeAndLeaveTheRest) {
  const Difference x{{1, 0, 0}, {}}, y{{0, 1, 0}, {}};
  EXPECT_EQ(triple_product_sign_by_expansions(x, y, {{1, 1, 0}, {}}), Sign::zero);
  EXPECT_EQ(triple_product_sign_by_expansions(x, y, {{0x1p-300, 1, 0x1p300}, {}}), Sign::positive);
  EXPECT_EQ(triple_product_sign_by_expansions(x, y, {{0x1p-301, 1, 0}, {}}), std::nullopt);
  EXPECT_EQ(triple_product_sign_by_expansions(x, y, {{1, 1, 0x1p301}, {}}), std::nullopt);
  EXPECT_EQ(triple_product_sign_by_expansions(x, y, {{1, 1, 1}, {0, 0, least}}), std::nullopt);
  EXPECT_EQ(triple_product_sign_by_expansions(x, y, {{1, 1, largest}, {0, 0, -largest}}), std::nullopt);
}

}  // namespace
}  // namespace toccata
