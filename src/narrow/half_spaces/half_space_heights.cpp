#include "narrow/half_spaces/half_space_heights.hpp"

#include <array>
#include <cmath>

#include "math/root_sign.hpp"

namespace toccata {
namespace {

/// The sign of (height of p) − (height of q).
Sign compare_heights(const PosedHalfSpace& h, const Vec3& p, const Vec3& q) {
  const std::array ends{p, q};
  const std::array normals{h.normal};
  const int unit = common_exponent(ends), normal_unit = common_exponent(normals);
  return sign_of_integer(dot(scaled_wide(p, unit) - scaled_wide(q, unit), scaled_wide(h.normal, normal_unit)));
}

/// Farther to the side asked for, or as far and lexicographically less.
bool is_more_extreme(const ExtremeVertex& p, const ExtremeVertex& q, const PosedHalfSpace& h, Reach reach) {
  const double difference = reach == Reach::below ? q.height.value - p.height.value : p.height.value - q.height.value;
  const double error = (p.height.error + q.height.error) * (1 + 0x1p-50);
  if (std::fabs(difference) > error * 2) return difference > 0;
  const Sign exact = compare_heights(h, p.position, q.position);
  if (exact == Sign::zero) return lexicographically_less(p.position, q.position);
  return exact == (reach == Reach::below ? Sign::negative : Sign::positive);
}

/// radius · |normal| ± height, decided from doubles where that is certain.
Filtered filtered_reach(const Vec3& centre, double radius, const PosedHalfSpace& h, Reach reach) {
  const Filtered height = filtered_height(h, centre);
  const double length_squared = dot(h.normal, h.normal);
  const bool usable = length_squared > 0x1p-900 && length_squared < 0x1p900;
  const double grown = radius * std::sqrt(length_squared);
  const double value = reach == Reach::below ? grown - height.value : grown + height.value;
  // Two roundings in each square, two in their sum, halved by the root, which rounds like the product: 4 of 2^-53; and
  // one for the sum.
  const double error = height.error * (1 + 0x1p-50) + 0x1p-50 * (grown + std::fabs(height.value)) + 0x1p-1000;
  return {value, usable ? error : HUGE_VAL};
}

Sign exact_reach_sign(const Vec3& centre, double radius, const PosedHalfSpace& h, Reach reach) {
  const ExactHeight exact = exact_height(h, centre);
  if (radius == 0) return sign_of_integer(reach == Reach::below ? -exact.height : exact.height);
  const int radius_exponent = binary_fraction(radius).exponent;
  const int unit = std::min(radius_exponent, exact.length_exponent);
  const WideInteger height = exact.height << static_cast<unsigned>(exact.length_exponent - unit);
  const WideInteger radius_scaled = scaled_wide(radius, unit);
  return root_sum_sign(reach == Reach::below ? WideInteger(-height) : height, radius_scaled, exact.normal_squared);
}

}  // namespace

Sign height_sign(const PosedHalfSpace& h, const Vec3& point) { return reach_sign(point, 0, h, Reach::above); }

ExactHeight exact_height(const PosedHalfSpace& h, const Vec3& point) {
  ExactHeight result;
  const std::array points{h.point, point};
  const std::array normals{h.normal};
  result.length_exponent = common_exponent(points);
  result.normal_exponent = common_exponent(normals);
  result.point = scaled_wide(point, result.length_exponent);
  result.normal = scaled_wide(h.normal, result.normal_exponent);
  result.height = dot(result.point - scaled_wide(h.point, result.length_exponent), result.normal);
  result.normal_squared = dot(result.normal, result.normal);
  return result;
}

ExtremeVertex extreme_vertex(const PosedPolytope& a, const PosedHalfSpace& h, Reach reach) {
  ExtremeVertex best{0, a.vertex(0), filtered_height(h, a.vertex(0))};
  for (Index i = 1; i < a.vertex_count(); ++i) {
    const Vec3 position = a.vertex(i);
    const ExtremeVertex next{i, position, filtered_height(h, position)};
    if (is_more_extreme(next, best, h, reach)) best = next;
  }
  return best;
}

Sign reach_sign(const Vec3& centre, double radius, const PosedHalfSpace& h, Reach reach) {
  const Filtered likely = filtered_reach(centre, radius, h, reach);
  if (likely.is_positive()) return Sign::positive;
  if (likely.is_negative()) return Sign::negative;
  return exact_reach_sign(centre, radius, h, reach);
}

}  // namespace toccata
