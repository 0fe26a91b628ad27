#include "toccata/math/mat3.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "math/vec3_measures.hpp"

namespace toccata {
namespace {

// Convergence is quadratic; six rounds reach the last place from any start, the others cost little.
constexpr int rounds = 8;

/// The vector scaled to length 1, or zero where there is no direction.
Vec3 normalised(const Vec3& v) {
  const double size = largest_magnitude(v);
  if (!(size > 0) || !std::isfinite(size)) return {};
  const Vec3 scaled{v.x / size, v.y / size, v.z / size};
  const double length = std::sqrt(dot(scaled, scaled));
  return {scaled.x / length, scaled.y / length, scaled.z / length};
}

/// The coordinate axis along which a unit vector has its least component.
Vec3 axis_across(const Vec3& unit) {
  const double x = std::fabs(unit.x), y = std::fabs(unit.y), z = std::fabs(unit.z);
  return x <= y && x <= z ? Vec3{1, 0, 0} : y <= z ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
}

/// The part of a unit vector at right angles to another, of length 1. Twice: the first time may leave as much as the
/// cancellation has made visible.
Vec3 across(const Vec3& unit, const Vec3& other) {
  const Vec3 once = normalised(other - dot(unit, other) * unit);
  return normalised(once - dot(unit, once) * unit);
}

Vec3 with_positive_largest(const Vec3& v) {
  const double size = largest_magnitude(v);
  for (int axis = 0; axis < 3; ++axis)
    if (std::fabs(v[axis]) == size) return v[axis] < 0 ? -v : v;
  return v;
}

/// Makes entry (p, q) zero by a rotation of the rows and columns p and q.
void rotate(Mat3& m, Mat3& axes, int p, int q) {
  if (m[p][q] == 0) return;
  const double theta = (m[q][q] - m[p][p]) / (2 * m[p][q]);
  const double tangent = std::copysign(1.0, theta) / (std::fabs(theta) + std::hypot(theta, 1.0));
  const double cosine = 1 / std::sqrt(tangent * tangent + 1), sine = tangent * cosine;
  for (int k = 0; k < 3; ++k) {
    const double kp = m[k][p], kq = m[k][q];
    m[k][p] = cosine * kp - sine * kq;
    m[k][q] = sine * kp + cosine * kq;
  }
  const Vec3 row_p = m[p], row_q = m[q], axis_p = axes[p], axis_q = axes[q];
  m[p] = cosine * row_p - sine * row_q;
  m[q] = sine * row_p + cosine * row_q;
  axes[p] = cosine * axis_p - sine * axis_q;
  axes[q] = sine * axis_p + cosine * axis_q;
}

}  // namespace

Mat3 orthonormal_axes(const Vec3& first, const Vec3& second) {
  Vec3 x = normalised(first);
  if (x == Vec3{}) x = axis_across(normalised(second));
  // A vector so nearly parallel that its direction across is mostly rounding is as good as none.
  const Vec3 unit = normalised(second);
  const Vec3 rest = unit - dot(x, unit) * x;
  const Vec3 y = across(x, largest_magnitude(rest) > 0x1p-40 ? unit : axis_across(x));
  return {{x, y, cross(x, y)}};
}

SymmetricEigen symmetric_eigen(const Mat3& matrix) {
  Mat3 m = matrix;
  m[1].x = m[0].y;
  m[2].x = m[0].z;
  m[2].y = m[1].z;
  Mat3 axes;
  for (int round = 0; round < rounds; ++round) {
    rotate(m, axes, 0, 1);
    rotate(m, axes, 0, 2);
    rotate(m, axes, 1, 2);
  }
  Vec3 values{m[0].x, m[1].y, m[2].z};
  const auto order = [&](int i, int j) {
    if (!(values[i] < values[j])) return;
    std::swap(values[i], values[j]);
    std::swap(axes[i], axes[j]);
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  return {values, orthonormal_axes(with_positive_largest(axes[0]), with_positive_largest(axes[1]))};
}

}  // namespace toccata
