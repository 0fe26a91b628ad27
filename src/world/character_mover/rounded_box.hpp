#pragma once

#include <algorithm>

#include "toccata/bounds/aabb.hpp"

namespace toccata {

/// What is no farther from a box than a radius.
class RoundedBox {
 public:
  RoundedBox(const Aabb& core, double radius) : core_(core), square_(radius * radius * (1 + 0x1p-40)) {}

  /// No point of the other box is within the radius: proved, as the sum of squares is off by less than what the square
  /// of the radius is enlarged by.
  [[nodiscard]] bool misses(const Aabb& other) const { return square_of_distance(other) > square_; }

  /// From the box, but for rounding.
  [[nodiscard]] double square_of_distance(const Aabb& other) const {
    const double x = between(core_.lower.x, core_.upper.x, other.lower.x, other.upper.x);
    const double y = between(core_.lower.y, core_.upper.y, other.lower.y, other.upper.y);
    const double z = between(core_.lower.z, core_.upper.z, other.lower.z, other.upper.z);
    return x * x + y * y + z * z;
  }

 private:
  static double between(double low, double high, double other_low, double other_high) {
    return std::max({0.0, other_low - high, low - other_high});
  }

  Aabb core_;
  double square_;
};

}  // namespace toccata
