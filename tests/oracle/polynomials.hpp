#pragma once

#include <array>
#include <vector>

#include "oracle/rational.hpp"

// Polynomials in one variable with rational coefficients, and their real roots as exact numbers (Sturm 1829).
namespace toccata::oracle {

/// The coefficients of 1, t, t², …; the last is not zero, and the zero polynomial has none.
class Polynomial {
 public:
  Polynomial() = default;
  explicit Polynomial(std::vector<Rational> coefficients);

  [[nodiscard]] bool is_zero() const { return coefficients_.empty(); }
  [[nodiscard]] int degree() const { return static_cast<int>(coefficients_.size()) - 1; }  ///< −1 of zero
  [[nodiscard]] const std::vector<Rational>& coefficients() const { return coefficients_; }
  [[nodiscard]] const Rational& leading() const { return coefficients_.back(); }
  [[nodiscard]] Rational at(const Rational& t) const;

 private:
  std::vector<Rational> coefficients_;
};

Polynomial operator+(const Polynomial& a, const Polynomial& b);
Polynomial operator-(const Polynomial& a, const Polynomial& b);
Polynomial operator-(const Polynomial& a);
Polynomial operator*(const Polynomial& a, const Polynomial& b);
Polynomial derivative(const Polynomial& a);

/// The polynomial times a positive number such that its coefficients are whole and have no common divisor. Not one
/// answer depends on it but the time.
Polynomial primitive(const Polynomial& a);

/// A polynomial of greatest degree that divides both, up to a factor; not both are zero.
Polynomial common_divisor(const Polynomial& a, const Polynomial& b);

/// The same roots, each once. Not for the zero polynomial.
Polynomial square_free(const Polynomial& a);

/// How many real roots a polynomial that is not zero has in (lower, upper], each counted once.
int roots_within(const Polynomial& a, const Rational& lower, const Rational& upper);

/// A real number: the only root of a square-free polynomial in (lower, upper].
struct AlgebraicNumber {
  Polynomial polynomial;
  Rational lower;
  Rational upper;
};

AlgebraicNumber algebraic(const Rational& value);

/// The roots in [0, 1] of a polynomial that is not zero, ascending.
std::vector<AlgebraicNumber> roots_in_unit_interval(const Polynomial& a);

/// The sign of a polynomial at a number: −1, 0 or 1.
int sign_at(const Polynomial& a, const AlgebraicNumber& t);

/// The sign of t − value.
int compared(const AlgebraicNumber& t, const Rational& value);

bool operator<(const AlgebraicNumber& s, const AlgebraicNumber& t);

/// Vectors whose coordinates are polynomials.
using PolynomialVector = std::array<Polynomial, 3>;

PolynomialVector operator-(const PolynomialVector& a, const PolynomialVector& b);
Polynomial dot(const PolynomialVector& a, const PolynomialVector& b);
PolynomialVector cross(const PolynomialVector& a, const PolynomialVector& b);

}  // namespace toccata::oracle
