#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <compare>

namespace toccata {

// Without expression templates, so that `auto` holds a number and not a reference to temporaries.
using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;

/// A fraction of integers of any size, in lowest terms, with a positive denominator. A class around Boost's number
/// whose functions are compiled once, in rational.cpp: wherever they are inlined they cost more time of the compiler
/// than anything else in the library.
class Rational {
 public:
  Rational() : Rational(0) {}
  Rational(int whole);  ///< implicit, so that 1 / r and r < 0 read as they do for doubles
  explicit Rational(const Integer& whole);
  /// The denominator is not zero.
  Rational(const Integer& numerator, const Integer& denominator);

  Rational(const Rational& other);
  Rational(Rational&& other) noexcept;
  Rational& operator=(const Rational& other);
  Rational& operator=(Rational&& other) noexcept;
  ~Rational();

  [[nodiscard]] int sign() const;  ///< -1, 0 or 1

  Rational& operator+=(const Rational& other);
  Rational& operator-=(const Rational& other);
  Rational& operator*=(const Rational& other);
  Rational& operator/=(const Rational& other);  ///< which is not zero

  friend Rational operator-(const Rational& a);
  friend Rational operator+(const Rational& a, const Rational& b);
  friend Rational operator-(const Rational& a, const Rational& b);
  friend Rational operator*(const Rational& a, const Rational& b);
  friend Rational operator/(const Rational& a, const Rational& b);
  friend bool operator==(const Rational& a, const Rational& b);
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b);
  friend Rational abs(const Rational& value);
  friend Integer numerator(const Rational& value);
  friend Integer denominator(const Rational& value);

 private:
  using Number =
      boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;

  explicit Rational(Number number);

  Number number_;
};

}  // namespace toccata
