#include "oracle/winding.hpp"

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cstddef>

#include "oracle/rational.hpp"

namespace toccata::oracle {
namespace {

using Float =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float_50::backend_type, boost::multiprecision::et_off>;
using FloatVector = std::array<Float, 3>;

FloatVector difference(const Vec3& a, const Vec3& b) {
  return {Float(a.x) - Float(b.x), Float(a.y) - Float(b.y), Float(a.z) - Float(b.z)};
}
Float product(const FloatVector& a, const FloatVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
FloatVector normal(const FloatVector& a, const FloatVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Between the planes that meet in a.
Float angle_at(const FloatVector& a, const FloatVector& b, const FloatVector& c) {
  const Float volume = product(a, normal(b, c));
  return atan2(Float(sqrt(product(a, a)) * abs(volume)), product(normal(a, b), normal(a, c)));
}

/// The exact volume of the four points is 0.
bool is_coplanar(const Vec3& point, const Triangle& t) {
  const RationalPoint p = exact(point), a = exact(t[0]) - p, b = exact(t[1]) - p, c = exact(t[2]) - p;
  return dot(a, cross(b, c)).sign() == 0;
}

}  // namespace

double winding_number(const Vec3& point, std::span<const Triangle> world_triangles) {
  const Float& pi = boost::math::constants::pi<Float>();
  Float sum = 0;
  for (const Triangle& t : world_triangles) {
    if (is_coplanar(point, t)) continue;
    const FloatVector a = difference(t[0], point), b = difference(t[1], point), c = difference(t[2], point);
    const Float covered = angle_at(a, b, c) + angle_at(b, c, a) + angle_at(c, a, b) - pi;
    if (product(a, normal(b, c)) > 0)
      sum += covered;
    else
      sum -= covered;
  }
  return static_cast<double>(sum / (4 * pi));
}

}  // namespace toccata::oracle
