#include "toccata/math/rotation.hpp"

#include <cmath>

#include "toccata/core/error.hpp"
#include "toccata/math/trigonometry.hpp"

namespace toccata {
namespace {

Vec3 direction_of(const Vec3& axis) {
  const double length = std::sqrt(dot(axis, axis));
  if (!(length > 0) || !std::isfinite(length)) throw Error("a rotation's axis must have a finite length above 0");
  return {axis.x / length, axis.y / length, axis.z / length};
}

}  // namespace

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
