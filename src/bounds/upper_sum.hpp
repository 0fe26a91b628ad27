#pragma once

#include <cmath>
#include <limits>

#include "math/constants.hpp"
#include "math/vec3_measures.hpp"
#include "toccata/bounds/aabb.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/math/vec3.hpp"

// Bounds that rounding cannot break. Everything a volume promises goes through these few functions.
namespace toccata {

/// A sum of up to 32 products, with a bound on what it is off by.
///
/// With ε = 2⁻⁵³ each product is off by ε of itself, and by 2⁻¹⁰⁷⁵ where it is below the range; a factor that is itself
/// the rounded result of up to eight operations by 8ε more for each of the two; and every one of at most 32 additions
/// by ε of the partial sum, which is at most the sum of magnitudes. That is less than 50ε of that sum together, itself
/// rounded by no more than 33ε; 2⁻⁴⁶ = 128ε of it also covers rounding the bound. `tiny` covers what is below the
/// range.
class UpperSum {
 public:
  void add(double a, double b) {
    const double product = a * b;
    value_ += product;
    magnitude_ += std::fabs(product);
  }
  void add(const Vec3& a, const Vec3& b) {
    add(a.x, b.x);
    add(a.y, b.y);
    add(a.z, b.z);
  }
  /// What the sum is off by besides.
  void add_slack(double slack) { slack_ += slack; }

  /// The exact sum is at most this; +∞ when a product or slack has overflowed or was not a number.
  [[nodiscard]] double bound() const { return value_finite() ? number_or_infinity(value_ + error()) : infinity; }
  /// So is the exact sum of which every product has the opposite sign.
  [[nodiscard]] double opposite_bound() const {
    return value_finite() ? number_or_infinity(error() - value_) : infinity;
  }
  [[nodiscard]] double magnitude_bound() const {
    return value_finite() ? number_or_infinity(std::fabs(value_) + error()) : infinity;
  }

 private:
  static constexpr double tiny = 0x1p-1060;

  /// Slack that overflowed may be no number.
  static double number_or_infinity(double x) { return x <= infinity ? x : infinity; }
  [[nodiscard]] double error() const { return 0x1p-46 * magnitude_ + (1.0000001 * slack_ + tiny); }
  // Written so that what is not a number is not finite.
  [[nodiscard]] bool value_finite() const { return magnitude_ <= std::numeric_limits<double>::max() / 4; }

  double value_ = 0;
  double magnitude_ = 0;
  double slack_ = 0;
};

/// No less than the exact result of a few operations on non-negative numbers that rounded to this.
inline double rounded_up(double x) { return x * (1 + 0x1p-46) + 0x1p-1060; }

/// No more than that, and not negative; +∞ and what is not a number become 0, an honest bound of anything.
inline double rounded_down(double x) {
  const double less = x * (1 - 0x1p-46) - 0x1p-1060;
  return less > 0 && less <= std::numeric_limits<double>::max() ? less : 0;
}

/// No less than |v|, whatever its scale.
inline double length_bound(const Vec3& v) {
  const double size = largest_magnitude(v);
  if (size == 0) return 0;
  if (!(size <= std::numeric_limits<double>::max())) return infinity;
  const double x = v.x / size, y = v.y / size, z = v.z / size;
  return rounded_up(size * std::sqrt((x * x + y * y) + z * z));
}

/// About the same direction with a greatest component of 1; zero for none, and where one is infinite or not a number.
inline Vec3 scaled_direction(const Vec3& v) {
  const double size = largest_magnitude(v);
  if (!(size > 0 && size <= std::numeric_limits<double>::max())) return {};
  return {v.x / size, v.y / size, v.z / size};
}

}  // namespace toccata
