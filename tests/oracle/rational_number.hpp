#pragma once

#include <boost/multiprecision/gmp.hpp>
#include <compare>
#include <concepts>

namespace toccata::oracle {

/// GMP's, which the library itself never uses: an oracle with other arithmetic, and a much faster one.
using Integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

/// An exact fraction, numerator · 2^exponent / denominator. Doubles, their sums and their products have the denominator
/// 1, and so need no common divisors, which is where rationals spend their time.
class Rational {
 public:
  Rational() = default;
  Rational(std::integral auto value) : numerator_(value) {}  // NOLINT: a whole number is a fraction
  explicit Rational(Integer value) : numerator_(std::move(value)) {}
  explicit Rational(double value);
  /// The denominator is not 0.
  Rational(const Integer& numerator, const Integer& denominator);

  [[nodiscard]] int sign() const { return numerator_.sign(); }
  [[nodiscard]] bool is_zero() const { return numerator_.is_zero(); }
  /// The nearest double, of two the even one; infinite beyond the largest, by half of its last place or more.
  [[nodiscard]] double to_double() const;
  explicit operator double() const { return to_double(); }
  /// Times 2^power.
  [[nodiscard]] Rational scaled(long power) const;

  /// Without a divisor but powers of two.
  [[nodiscard]] bool is_dyadic() const { return denominator_.is_zero(); }
  /// The value is numerator() · 2^exponent() / denominator().
  [[nodiscard]] const Integer& numerator() const { return numerator_; }
  [[nodiscard]] Integer denominator() const { return is_dyadic() ? Integer(1) : denominator_; }
  [[nodiscard]] long exponent() const { return exponent_; }

  Rational operator-() const;
  friend Rational operator+(const Rational& a, const Rational& b);
  friend Rational operator-(const Rational& a, const Rational& b);
  friend Rational operator*(const Rational& a, const Rational& b);
  friend Rational operator/(const Rational& a, const Rational& b);
  Rational& operator+=(const Rational& b) { return *this = *this + b; }
  Rational& operator*=(const Rational& b) { return *this = *this * b; }
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b);
  friend std::strong_ordering operator<=>(const Rational& a, std::integral auto b) {
    return b == 0 ? a.sign() <=> 0 : a <=> Rational(b);
  }
  friend bool operator==(const Rational& a, const Rational& b) { return (a <=> b) == std::strong_ordering::equal; }
  friend bool operator==(const Rational& a, std::integral auto b) { return (a <=> b) == std::strong_ordering::equal; }
  friend Rational abs(const Rational& a) { return a.sign() < 0 ? -a : a; }

 private:
  Integer numerator_;
  Integer denominator_;  ///< odd and greater than 1, without a common divisor with the numerator; or 0, in place of 1
  long exponent_ = 0;
};

/// value · 2^power, power ≥ 0.
Integer shifted(const Integer& value, long power);

}  // namespace toccata::oracle
