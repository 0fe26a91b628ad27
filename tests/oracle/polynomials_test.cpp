#include "oracle/polynomials.hpp"

#include <gtest/gtest.h>

namespace toccata::oracle {
namespace {

/// The product of (t − root) over the roots.
Polynomial with_roots(const std::vector<Rational>& roots) {
  Polynomial product({1});
  for (const Rational& root : roots) product = product * Polynomial({-root, 1});
  return product;
}

const Polynomial square_less_half({Rational(-1, 2), 0, 1});  // its root is √½

TEST(OraclePolynomials, RootsAreCountedOnceEachAndTheLowerEndIsLeftOut) {
  const Polynomial a = with_roots({0, 1, 1, 2, 2, 2, 3});
  EXPECT_EQ(roots_within(a, 0, 3), 3);
  EXPECT_EQ(roots_within(a, -1, 3), 4);
  EXPECT_EQ(roots_within(a, Rational(1, 2), Rational(3, 2)), 1);
  EXPECT_EQ(roots_within(Polynomial({1, 0, 1}), -10, 10), 0);
  EXPECT_EQ(roots_within(Polynomial({5}), -10, 10), 0);
}

TEST(OraclePolynomials, TheRootsInTheUnitIntervalComeAscendingWithBothEnds) {
  const std::vector<Rational> roots{0, Rational(1, 3), Rational(1, 2), 1};
  const std::vector<AlgebraicNumber> found =
      roots_in_unit_interval(with_roots({1, 0, 0, Rational(1, 2), Rational(1, 3), 2, -1}));
  ASSERT_EQ(found.size(), roots.size());
  for (std::size_t i = 0; i < roots.size(); ++i) EXPECT_EQ(compared(found[i], roots[i]), 0);
}

TEST(OraclePolynomials, ASignAtARootIsZeroExactlyWhereTheRootIsShared) {
  const AlgebraicNumber root = roots_in_unit_interval(square_less_half).front();
  EXPECT_EQ(sign_at(square_less_half * with_roots({5}), root), 0);
  EXPECT_EQ(sign_at(Polynomial(), root), 0);
  EXPECT_EQ(sign_at(Polynomial({3}), root), 1);
  EXPECT_EQ(compared(root, Rational(0x1.6a09e667f3bccp-1)), 1);   // the double below √½
  EXPECT_EQ(compared(root, Rational(0x1.6a09e667f3bcdp-1)), -1);  // and above
  // So near that only the exact sign tells.
  const Polynomial beside({Rational(-1, 2) - Rational(1).scaled(-400), 0, 1});
  EXPECT_EQ(sign_at(beside, root), -1);
}

TEST(OraclePolynomials, NumbersAreOrderedAlsoWhereTheyAreRootsOfDifferentPolynomials) {
  const AlgebraicNumber half_root = roots_in_unit_interval(square_less_half).front();
  const AlgebraicNumber same = roots_in_unit_interval(square_less_half * with_roots({Rational(1, 7)})).back();
  const AlgebraicNumber greater =
      roots_in_unit_interval(Polynomial({Rational(-1, 2) - Rational(1).scaled(-90), 0, 1})).front();
  EXPECT_FALSE(half_root < same);
  EXPECT_FALSE(same < half_root);
  EXPECT_TRUE(half_root < greater);
  EXPECT_FALSE(greater < half_root);
}

TEST(OraclePolynomials, MultipleFactorsAreTakenOut) {
  EXPECT_EQ(square_free(with_roots({2, 2, 2, 3, 3})).degree(), 2);
  EXPECT_EQ(common_divisor(with_roots({1, 2, 2}), with_roots({2, 2, 3})).degree(), 2);
}

}  // namespace
}  // namespace toccata::oracle
