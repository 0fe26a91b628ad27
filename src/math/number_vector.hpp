#pragma once

#include <array>
#include <cstddef>

#include "math/bounded_double.hpp"
#include "math/double_word.hpp"

namespace toccata {

/// Three numbers of any kind: double, DoubleWord, BoundedDouble or BoundedNumber.
template <class Number>
using VectorOf = std::array<Number, 3>;

/// A vector of numbers of about 106 bits.
using FineVector = VectorOf<DoubleWord>;

template <class Number>
VectorOf<Number> sum(const VectorOf<Number>& u, const VectorOf<Number>& v) {
  return {u[0] + v[0], u[1] + v[1], u[2] + v[2]};
}

template <class Number>
VectorOf<Number> difference(const VectorOf<Number>& u, const VectorOf<Number>& v) {
  return {u[0] - v[0], u[1] - v[1], u[2] - v[2]};
}

template <class Number>
VectorOf<Number> multiple(const Number& s, const VectorOf<Number>& v) {
  return {s * v[0], s * v[1], s * v[2]};
}

template <class Number>
Number inner(const VectorOf<Number>& u, const VectorOf<Number>& v) {
  return (u[0] * v[0] + u[1] * v[1]) + u[2] * v[2];
}

template <class Number>
VectorOf<Number> outer(const VectorOf<Number>& u, const VectorOf<Number>& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

/// A bounded number as one of another kind; a bound of a kind that has one still holds.
template <class Number>
Number number_as(const BoundedNumber& a);

template <>
inline double number_as(const BoundedNumber& a) {
  return a.value.high;
}
template <>
inline DoubleWord number_as(const BoundedNumber& a) {
  return a.value;
}
template <>
inline BoundedDouble number_as(const BoundedNumber& a) {
  return {a.value.high, std::fabs(a.value.low) + a.error};
}
template <>
inline BoundedNumber number_as(const BoundedNumber& a) {
  return a;
}

template <class Number>
VectorOf<Number> vector_as(const BoundedVector& v) {
  return {number_as<Number>(v[0]), number_as<Number>(v[1]), number_as<Number>(v[2])};
}

template <class Number>
Number number_as(const DoubleWord& a) {
  return number_as<Number>(BoundedNumber{a, 0});
}

template <class Number>
Number number_as(double a) {
  return number_as<Number>(BoundedNumber{{a, 0}, 0});
}

template <class Number>
VectorOf<Number> vector_as(const FineVector& v) {
  return {number_as<Number>(v[0]), number_as<Number>(v[1]), number_as<Number>(v[2])};
}

inline Vec3 high_parts(const FineVector& v) { return {v[0].high, v[1].high, v[2].high}; }

inline Vec3 plain(const BoundedVector& v) { return high_parts(v); }

}  // namespace toccata
