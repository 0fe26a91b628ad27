#include "toccata/math/pose.hpp"

#include <algorithm>
#include <cmath>

#include "math/plain_inverse.hpp"
#include "math/vec3_measures.hpp"
#include "toccata/core/error.hpp"
#include "toccata/math/predicates.hpp"
#include "toccata/math/trigonometry.hpp"

namespace toccata {
namespace {

Vec3 direction_of(const Vec3& axis) {
  const double length = std::sqrt(dot(axis, axis));
  if (!(length > 0) || !std::isfinite(length)) throw Error("a rotation's axis must have a finite length above 0");
  return {axis.x / length, axis.y / length, axis.z / length};
}

/// The largest of the numbers.
double size_of(const Mat3& m) {
  return std::max({largest_magnitude(m[0]), largest_magnitude(m[1]), largest_magnitude(m[2])});
}

double frobenius_norm(const Mat3& m) { return std::sqrt((dot(m[0], m[0]) + dot(m[1], m[1])) + dot(m[2], m[2])); }

Mat3 combined(double s, const Mat3& a, double t, const Mat3& b) {
  return {{s * a[0] + t * b[0], s * a[1] + t * b[1], s * a[2] + t * b[2]}};
}

/// More than any matrix needs of which something can be told: nine steps of a condition of 2^52.
constexpr int most_polar_steps = 30;

}  // namespace

Mat3 nearest_rotation(const Mat3& m) {
  if (!is_finite(m)) throw Error("the matrix to turn into a rotation has a number that is not finite");
  if (triple_product_sign({m[0], {}}, {m[1], {}}, {m[2], {}}) != Sign::positive)
    throw Error("the matrix to turn into a rotation mirrors or flattens: its determinant is not positive");
  const int exponent = -std::ilogb(size_of(m));
  Mat3 x = m;
  for (Vec3& row : x.row)
    for (int axis = 0; axis < 3; ++axis) row[axis] = std::scalbn(row[axis], exponent);
  for (int step = 0; step < most_polar_steps; ++step) {
    const Mat3 back = plain_inverse_transpose(x);
    const double factor = std::sqrt(frobenius_norm(back) / frobenius_norm(x));
    const Mat3 next = combined(0.5 * factor, x, 0.5 / factor, back);
    const double change = size_of(combined(1, next, -1, x));
    x = next;
    if (change < 0x1p-30)
      return combined(0.5, x, 0.5, plain_inverse_transpose(x));  // one step more squares what is left
    if (!is_finite(x)) break;
  }
  throw Error("the matrix to turn into a rotation is so nearly singular that doubles do not tell the rotation");
}

Mat3 rotation_about(const Vec3& axis, double degrees) {
  if (!std::isfinite(degrees)) throw Error("a rotation's angle must be finite");
  const Vec3 a = direction_of(axis);
  const auto [s, c] = sine_cosine_of_degrees(degrees);
  Mat3 m;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    m[i][i] = c * (a[j] * a[j] + a[k] * a[k]) + a[i] * a[i];
    m[i][j] = a[i] * a[j] * (1 - c) - a[k] * s;
    m[j][i] = a[i] * a[j] * (1 - c) + a[k] * s;
  }
  return m;
}

Mat3 rotation_of(const Quaternion& q) {
  const double n = (q.x * q.x + q.y * q.y) + (q.z * q.z + q.w * q.w);
  if (!(n > 0) || !std::isfinite(n)) throw Error("a quaternion must have a finite length above 0");
  const Vec3 v{q.x, q.y, q.z};
  Mat3 m;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    m[i][i] = 1 - 2 * (v[j] * v[j] + v[k] * v[k]) / n;
    m[i][j] = 2 * (v[i] * v[j] - v[k] * q.w) / n;
    m[j][i] = 2 * (v[i] * v[j] + v[k] * q.w) / n;
  }
  return m;
}

Pose pose_of(const Vec3& translation, const Mat3& rotation, const Vec3& scale) {
  Pose pose{rotation, translation};
  for (Vec3& row : pose.linear.row) row = {row.x * scale.x, row.y * scale.y, row.z * scale.z};
  return pose;
}

}  // namespace toccata
