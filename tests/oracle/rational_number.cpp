#include "oracle/rational_number.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace toccata::oracle {
namespace {

long trailing_zeros(const Integer& value) { return static_cast<long>(lsb(abs(value))); }

long length(const Integer& value) { return static_cast<long>(msb(abs(value))); }

/// The terms with one exponent.
struct Aligned {
  Integer a;
  Integer b;
  long exponent;
};

Aligned aligned(const Integer& a, long exponent_a, const Integer& b, long exponent_b) {
  if (exponent_a > exponent_b) return {shifted(a, exponent_a - exponent_b), b, exponent_b};
  return {a, shifted(b, exponent_b - exponent_a), exponent_a};
}

}  // namespace

Integer shifted(const Integer& value, long power) {
  return power == 0 ? value : Integer(value << static_cast<unsigned long>(power));
}

Rational::Rational(double value) {
  if (!std::isfinite(value)) throw std::invalid_argument("oracle: not a finite number");
  if (value == 0) return;
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);
  const auto whole = static_cast<std::int64_t>(std::ldexp(mantissa, 53));  // exact
  const int zeros = __builtin_ctzll(static_cast<std::uint64_t>(whole));
  numerator_ = whole / (std::int64_t{1} << zeros);
  exponent_ = exponent - 53 + zeros;
}

Rational::Rational(const Integer& numerator, const Integer& denominator) {
  if (denominator.is_zero()) throw std::invalid_argument("oracle: division by 0");
  if (numerator.is_zero()) return;
  const Integer divisor = gcd(numerator, denominator);
  numerator_ = denominator < 0 ? Integer(-numerator / divisor) : Integer(numerator / divisor);
  denominator_ = abs(denominator) / divisor;
  const long zeros = trailing_zeros(denominator_);
  denominator_ >>= static_cast<unsigned long>(zeros);
  exponent_ = -zeros;
  if (denominator_ == 1) denominator_ = 0;
}

double Rational::to_double() const {
  if (is_dyadic()) {
    long exponent = 0;
    const double mantissa = mpz_get_d_2exp(&exponent, numerator_.backend().data());
    return std::ldexp(mantissa, static_cast<int>(exponent + exponent_));
  }
  // Enough digits of the quotient that what is cut off after them does not show.
  const long digits = std::max(0L, 64 + length(denominator_) - length(numerator_));
  return Rational(Integer(shifted(numerator_, digits) / denominator_)).scaled(exponent_ - digits).to_double();
}

Rational Rational::scaled(long power) const {
  Rational result = *this;
  if (!is_zero()) result.exponent_ += power;
  return result;
}

Rational Rational::operator-() const {
  Rational result = *this;
  result.numerator_ = -result.numerator_;
  return result;
}

Rational operator+(const Rational& a, const Rational& b) {
  if (a.is_zero()) return b;
  if (b.is_zero()) return a;
  if (a.is_dyadic() && b.is_dyadic()) {
    Rational sum;
    if (a.exponent_ == b.exponent_) {
      sum.numerator_ = a.numerator_ + b.numerator_;
      sum.exponent_ = a.exponent_;
    } else {
      const Rational& high = a.exponent_ > b.exponent_ ? a : b;
      const Rational& low = a.exponent_ > b.exponent_ ? b : a;
      sum.numerator_ = shifted(high.numerator_, high.exponent_ - low.exponent_) + low.numerator_;
      sum.exponent_ = low.exponent_;
    }
    if (sum.is_zero()) sum.exponent_ = 0;
    return sum;
  }
  const Integer bottom_a = a.denominator(), bottom_b = b.denominator();
  const Aligned terms = aligned(a.numerator_ * bottom_b, a.exponent_, b.numerator_ * bottom_a, b.exponent_);
  Rational sum(Integer(terms.a + terms.b), Integer(bottom_a * bottom_b));
  if (!sum.is_zero()) sum.exponent_ += terms.exponent;
  return sum;
}

Rational operator-(const Rational& a, const Rational& b) { return a + -b; }

Rational operator*(const Rational& a, const Rational& b) {
  if (a.is_zero() || b.is_zero()) return {};
  Rational product;
  if (a.is_dyadic() && b.is_dyadic())
    product.numerator_ = a.numerator_ * b.numerator_;
  else
    product = Rational(Integer(a.numerator_ * b.numerator_), Integer(a.denominator() * b.denominator()));
  product.exponent_ += a.exponent_ + b.exponent_;
  return product;
}

Rational operator/(const Rational& a, const Rational& b) {
  if (a.is_zero()) return {};
  Rational quotient(Integer(a.numerator_ * b.denominator()), Integer(b.numerator_ * a.denominator()));
  quotient.exponent_ += a.exponent_ - b.exponent_;
  return quotient;
}

std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
  if (a.sign() != b.sign()) return a.sign() <=> b.sign();
  if (a.is_dyadic() && b.is_dyadic() && a.exponent_ == b.exponent_) return a.numerator_.compare(b.numerator_) <=> 0;
  return (a - b).sign() <=> 0;
}

}  // namespace toccata::oracle
