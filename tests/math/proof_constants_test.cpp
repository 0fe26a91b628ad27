// Witnesses: with a constant that a proof rests on made a few times too small, these doubles give a false statement
// (docs/design/proof-constants.md).
#include <gtest/gtest.h>

#include "math/bounded_double.hpp"
#include "math/double_word.hpp"
#include "math/filter.hpp"
#include "math/floats.hpp"
#include "oracle/rational.hpp"

namespace toccata::test {
namespace {

using oracle::exact;
using oracle::Rational;

/// What a filter is certain of is so.
bool is_true(const Filtered& found, const Rational& number) {
  return (!found.is_positive() || number > 0) && (!found.is_negative() || number < 0);
}

bool holds(const BoundedDouble& found, const Rational& number) {
  return abs(exact(found.value) - number) <= exact(found.reach());
}

Rational number_of(const DoubleWord& a) { return exact(a.high) + exact(a.low); }

bool holds(const BoundedNumber& found, const Rational& number) {
  return abs(number_of(found.value) - number) <= exact(found.reach());
}

TEST(ProofConstants, TheFilterOfOrient2dCoversThreeRoundings) {
  const Vec2 a{0x1.081155be422d8p-1, -0x1.4e5c843490842p-1}, b{-0x1.5dd6cd91c49fp-2, 0x1.a8dd9fc94538ap-1},
      c{-0x1.18645da38f0a7p+0, 0x1.110de881e72c8p+1};
  const Rational left = (exact(b.x) - exact(a.x)) * (exact(c.y) - exact(a.y));
  const Rational right = (exact(b.y) - exact(a.y)) * (exact(c.x) - exact(a.x));
  EXPECT_TRUE(is_true(filtered_orient2d(a, b, c), left - right));
}

TEST(ProofConstants, TheFilterOfOrient3dCoversSevenRoundings) {
  const Vec3 a{0x1.1834dd2dcdd16p-1, 0x1.affa6a4b79488p-3, -0x1.04086ee60e364p-2},
      b{0x1.92804f4d6d5ep-4, 0x1.fe7897ca9b1bep-1, -0x1.4682aa1b5aa58p-3},
      c{0x1.1d90bc8aa451p-4, 0x1.89643db1297a8p-3, -0x1.288064c1ddeep-1},
      d{0x1.e55071cbb63b9p-1, -0x1.ea830e9b174a1p-2, -0x1.5491609d83afbp-2};
  EXPECT_TRUE(is_true(filtered_orient3d(a, b, c, d), oracle::orientation(exact(a), exact(b), exact(c), exact(d))));
}

// Two products beside the middle between 0 and the least double: they round apart in the wrong order.
TEST(ProofConstants, TheFloorOfFiltersCoversUnderflow) {
  const double above = 0x1.0000000000001p-537;
  const Vec2 a{0x1p-591, 0x1p-590}, b{above, above}, c{above / 2, above / 2};
  const Rational left = (exact(b.x) - exact(a.x)) * (exact(c.y) - exact(a.y));
  const Rational right = (exact(b.y) - exact(a.y)) * (exact(c.x) - exact(a.x));
  EXPECT_TRUE(is_true(filtered_orient2d(a, b, c), left - right));
}

// 1 + 2^-53 lies in the middle between two doubles, and so do the product and, but for 2^-107, the root.
TEST(ProofConstants, ASumOfBoundedDoublesCoversItsRounding) {
  EXPECT_TRUE(holds(BoundedDouble{1, 0} + BoundedDouble{0x1p-53, 0}, exact(1) + exact(0x1p-53)));
}

TEST(ProofConstants, AProductOfBoundedDoublesCoversItsRounding) {
  const double a = 1 + 0x1p-26, b = 1 + 0x1p-27;
  EXPECT_TRUE(holds(BoundedDouble{a, 0} * BoundedDouble{b, 0}, exact(a) * exact(b)));
}

TEST(ProofConstants, AQuotientOfBoundedDoublesCoversItsRounding) {
  EXPECT_TRUE(holds(BoundedDouble{1, 0} / BoundedDouble{3, 0}, exact(1) / exact(3)));
}

TEST(ProofConstants, ARootOfABoundedDoubleCoversItsRounding) {
  const double square = 1 + 0x1p-52;
  const BoundedDouble root = square_root(BoundedDouble{square, 0});
  const Rational most = exact(root.value) + exact(root.reach());
  EXPECT_GE(most * most, exact(square));
}

TEST(ProofConstants, AProductThatUnderflowsIsNotCertainlyZero) {
  const double small = 0x1p-540;
  EXPECT_TRUE(holds(BoundedDouble{small, 0} * BoundedDouble{small, 0}, exact(small) * exact(small)));
}

TEST(ProofConstants, AProductOfDoubleWordsCoversItsRounding) {
  const DoubleWord a = {0x1.08ffa769043e5p+0, 0x1.fee0ecab7746ep-54}, b = {0x1.103c37f5c6012p+0, 0x1.f79323eef00bp-54};
  EXPECT_TRUE(holds(BoundedNumber{a, 0} * BoundedNumber{b, 0}, number_of(a) * number_of(b)));
}

// The nearest float to 0.7 lies below it.
TEST(ProofConstants, AFloatAboveIsNotTheNearest) { EXPECT_GE(exact(double{up_to_float(0.7)}), exact(0.7)); }

// The end of the error rounds back to the value.
TEST(ProofConstants, TheFloorOfABoundedDoubleIsNotAboveTheExactNumber) {
  const BoundedDouble number{1, 0x1p-56};
  EXPECT_LE(exact(floor_of(number)), exact(1) - exact(number.reach()));
}

TEST(ProofConstants, TheFloorOfABoundedNumberIsNotAboveTheExactNumber) {
  EXPECT_LE(exact(floor_of(BoundedNumber{{1, -0x1p-60}, 0})), exact(1) - exact(0x1p-60));
}

TEST(ProofConstants, TheBracketOfANumberBesideADoubleHoldsIt) {
  const auto above = bracket(BoundedNumber{{1, 0x1p-60}, 0}), below = bracket(BoundedNumber{{1, -0x1p-60}, 0});
  ASSERT_TRUE(above && below);
  EXPECT_GE(exact(above->upper), exact(1) + exact(0x1p-60));
  EXPECT_LE(exact(below->lower), exact(1) - exact(0x1p-60));
}

}  // namespace
}  // namespace toccata::test
