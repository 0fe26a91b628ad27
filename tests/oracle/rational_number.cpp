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

/// The double nearest to (digits + part) · 2^exponent, of two the even one; infinite beyond the largest. The part is
/// less than 1, and 0 unless told; then there are more than 54 digits.
double nearest_double(const Integer& digits, bool has_part, long exponent) {
  // A double has 53 digits, or fewer: none is below 2^-1074.
  const long beyond = std::max(length(digits) - 52, -1074 - exponent);
  if (beyond <= 0) return std::ldexp(digits.convert_to<double>(), static_cast<int>(std::min(exponent, 2000L)));
  if (beyond > length(digits) + 1) return 0;
  Integer kept = digits >> static_cast<unsigned long>(beyond);
  const int half = Integer(2 * (digits - shifted(kept, beyond))).compare(shifted(1, beyond));
  if (half > 0 || (half == 0 && (has_part || bit_test(kept, 0)))) kept += 1;
  return std::ldexp(kept.convert_to<double>(), static_cast<int>(std::min(exponent + beyond, 2000L)));
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
  if (is_zero()) return 0;
  const Integer size = abs(numerator_);
  if (is_dyadic()) return sign() * nearest_double(size, false, exponent_);
  // More digits of the quotient than a double has, and whether it ends there.
  const long more = std::max(0L, 66 + length(denominator_) - length(size));
  const Integer dividend = shifted(size, more), digits = dividend / denominator_;
  return sign() * nearest_double(digits, digits * denominator_ != dividend, exponent_ - more);
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
