#include "math/rational.hpp"

#include <utility>

namespace toccata {

Rational::Rational(int whole) : number_(whole) {}
Rational::Rational(const Integer& whole) : number_(whole) {}
Rational::Rational(const Integer& numerator, const Integer& denominator) : number_(numerator, denominator) {}
Rational::Rational(Number number) : number_(std::move(number)) {}

Rational::Rational(const Rational& other) = default;
Rational::Rational(Rational&& other) noexcept = default;
Rational& Rational::operator=(const Rational& other) = default;
Rational& Rational::operator=(Rational&& other) noexcept = default;
Rational::~Rational() = default;

int Rational::sign() const { return number_.sign(); }

Rational& Rational::operator+=(const Rational& other) {
  number_ += other.number_;
  return *this;
}

Rational& Rational::operator-=(const Rational& other) {
  number_ -= other.number_;
  return *this;
}

Rational& Rational::operator*=(const Rational& other) {
  number_ *= other.number_;
  return *this;
}

Rational& Rational::operator/=(const Rational& other) {
  number_ /= other.number_;
  return *this;
}

Rational operator-(const Rational& a) { return Rational(Rational::Number(-a.number_)); }
Rational operator+(const Rational& a, const Rational& b) { return Rational(Rational::Number(a.number_ + b.number_)); }
Rational operator-(const Rational& a, const Rational& b) { return Rational(Rational::Number(a.number_ - b.number_)); }
Rational operator*(const Rational& a, const Rational& b) { return Rational(Rational::Number(a.number_ * b.number_)); }
Rational operator/(const Rational& a, const Rational& b) { return Rational(Rational::Number(a.number_ / b.number_)); }

bool operator==(const Rational& a, const Rational& b) { return a.number_ == b.number_; }
std::strong_ordering operator<=>(const Rational& a, const Rational& b) { return a.number_.compare(b.number_) <=> 0; }

Rational abs(const Rational& value) { return value.sign() < 0 ? -value : value; }
Integer numerator(const Rational& value) { return numerator(value.number_); }
Integer denominator(const Rational& value) { return denominator(value.number_); }

}  // namespace toccata
