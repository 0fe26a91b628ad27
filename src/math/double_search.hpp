#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "math/constants.hpp"
#include "toccata/math/predicates.hpp"

// Rounding of a number that is only known by comparisons.
namespace toccata {

/// The doubles in ascending order as whole numbers; 0 and −0 are 0, ±∞ the first beyond the others.
inline std::int64_t rank_of(double value) {
  const auto magnitude = std::bit_cast<std::int64_t>(std::fabs(value));
  return value < 0 ? -magnitude : magnitude;
}

inline double of_rank(std::int64_t rank) {
  const double magnitude = std::bit_cast<double>(rank < 0 ? -rank : rank);
  return rank < 0 ? -magnitude : magnitude;
}

/// The greatest double that is at most the number, −∞ included. `compare(x, y)` is the sign of the number less
/// (x + y) / 2, for finite x and y.
template <class Compare>
double greatest_double_below(const Compare& compare, double guess) {
  const std::int64_t end = rank_of(infinity);
  const auto twice = [&](std::int64_t step) { return step < end / 2 ? 2 * step : end; };
  const auto reaches = [&](std::int64_t rank) {
    if (rank <= -end || rank >= end) return rank < 0;
    return compare(of_rank(rank), of_rank(rank)) != Sign::negative;
  };
  // Steps away from the guess are doubled until the number lies between two ranks, which are then halved.
  std::int64_t below = std::isnan(guess) ? 0 : rank_of(guess), step = 1;
  if (!reaches(below)) {
    do {
      below = below < step - end ? -end : below - step;
      step = twice(step);
    } while (!reaches(below));
    step /= 2;
  }
  std::int64_t above = below > end - step ? end : below + step;
  while (reaches(above)) {
    below = above;
    step = twice(step);
    above = below > end - step ? end : below + step;
  }
  while (above - below > 1) {
    const std::int64_t middle = below + (above - below) / 2;
    (reaches(middle) ? below : above) = middle;
  }
  return of_rank(below);
}

/// The double nearest to the number, ties to even; the number is within the range of doubles.
template <class Compare>
double nearest_double_by(const Compare& compare, double guess) {
  const double below = greatest_double_below(compare, guess);
  const double above = of_rank(rank_of(below) + 1);
  if (!std::isfinite(below)) return above;
  if (!std::isfinite(above)) return below;
  const Sign half = compare(below, above);
  if (half == Sign::zero) return (rank_of(below) & 1) == 0 ? below : above;
  return half == Sign::negative ? below : above;
}

}  // namespace toccata
