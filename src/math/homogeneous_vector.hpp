#pragma once

#include "math/wide_integer.hpp"

namespace toccata {

/// A point or vector with rational coordinates: numerator / denominator, in a unit that is kept elsewhere; the
/// denominator is positive.
struct HomogeneousVector {
  IntegerVector numerator;
  WideInteger denominator{1};
};

[[nodiscard]] inline HomogeneousVector operator-(const HomogeneousVector& p, const HomogeneousVector& q) {
  if (p.denominator == q.denominator) return {p.numerator - q.numerator, p.denominator};
  return {q.denominator * p.numerator - p.denominator * q.numerator, p.denominator * q.denominator};
}

[[nodiscard]] inline HomogeneousVector operator+(const IntegerVector& p, const HomogeneousVector& q) {
  return {q.denominator * p + q.numerator, q.denominator};
}

}  // namespace toccata
