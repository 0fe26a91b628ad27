#include "toccata/math/vec3.hpp"

#include "math/vec3_measures.hpp"

namespace toccata {

double length(const Vec3& v) {
  const double squared = dot(v, v);
  if (squared > 0x1p-900 && squared < 0x1p900) return std::sqrt(squared);
  const double largest = largest_magnitude(v);
  if (!(largest > 0) || !is_finite(v)) return sum_of_magnitudes(v);  // 0, infinity or NaN
  const int exponent = std::ilogb(largest);
  return std::scalbn(plain_length(near_unit(v)), exponent);
}

Vec3 normalized(const Vec3& v) { return is_finite(v) ? unit_or_zero(v) : Vec3{}; }

}  // namespace toccata
