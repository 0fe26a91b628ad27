#pragma once

#include <algorithm>
#include <cmath>

#include "math/constants.hpp"

namespace toccata {

/// A sum of numbers that are each known up to a bound.
class BoundedSum {
 public:
  void add(double more, double more_bound) {
    value_ += more;
    rounded_bound_ += more_bound + unit_roundoff * std::abs(value_);
    additions_ += 1;
  }
  [[nodiscard]] double value() const { return value_; }

  /// The sum of the bounds as it came to be.
  [[nodiscard]] double rounded_bound() const { return rounded_bound_; }

  /// Not less than what the value is off by: every addition of a bound may have lost 2⁻⁵³ of their sum, and what was
  /// added as much of itself.
  [[nodiscard]] double bound() const { return (1 + std::max(0x1p-40, 0x1p-52 * additions_)) * rounded_bound_; }

 private:
  double value_ = 0;
  double rounded_bound_ = 0;
  double additions_ = 0;
};

}  // namespace toccata
