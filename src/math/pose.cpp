#include "toccata/math/pose.hpp"

#include <algorithm>
#include <cmath>

#include "math/exact.hpp"
#include "math/world_vertex.hpp"
#include "toccata/core/error.hpp"
#include "toccata/math/predicates.hpp"

namespace toccata {
namespace {

using IntegerColumn = std::array<Integer, 3>;

/// The exponent of the last bit of a finite number that is not 0.
int exponent_of_last_bit(double value) { return std::max(std::ilogb(value), -1022) - 52; }

IntegerColumn multiples_of_power(const Vec3& v, int exponent) {
  IntegerColumn result;
  for (int i = 0; i < 3; ++i) {
    if (v[i] == 0) continue;
    const int own = exponent_of_last_bit(v[i]);
    const Integer bits(static_cast<long long>(std::scalbn(v[i], -own)));
    result[static_cast<std::size_t>(i)] = bits * (Integer(1) << (own - exponent));
  }
  return result;
}

IntegerColumn cross(const IntegerColumn& a, const IntegerColumn& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The inverse of a matrix with a determinant other than 0: its rows are the cross products of the columns over the
/// determinant, in whole multiples of a power of two.
Mat3 exact_inverse(const Mat3& m) {
  int exponent = 2000;
  for (const Vec3& row : m.row)
    for (int j = 0; j < 3; ++j)
      if (row[j] != 0) exponent = std::min(exponent, exponent_of_last_bit(row[j]));
  std::array<IntegerColumn, 3> column;
  for (int j = 0; j < 3; ++j) column[static_cast<std::size_t>(j)] = multiples_of_power(m.column(j), exponent);
  const auto& [x, y, z] = column;
  const std::array<IntegerColumn, 3> rows{cross(y, z), cross(z, x), cross(x, y)};
  const Integer determinant = x[0] * rows[0][0] + x[1] * rows[0][1] + x[2] * rows[0][2];
  Mat3 result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const Integer numerator = determinant < 0 ? Integer(-rows[i][j]) : rows[i][j];
      result[static_cast<int>(i)][static_cast<int>(j)] = nearest_double(numerator, abs(determinant), -exponent);
    }
  return result;
}

}  // namespace

Pose Pose::from_numbers(const std::array<double, 12>& n) {
  Pose pose;
  pose.linear = {{{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]}}}};
  pose.offset = {n[9], n[10], n[11]};
  return pose;
}

std::array<double, 12> Pose::numbers() const {
  const auto& [r0, r1, r2] = linear.row;
  return {r0.x, r0.y, r0.z, r1.x, r1.y, r1.z, r2.x, r2.y, r2.z, offset.x, offset.y, offset.z};
}

// This function defines the truth. It lives here, in a file compiled with -ffp-contract=off, and not in the header, so
// that a user's compiler cannot fuse it.
Vec3 transform(const Pose& pose, const Vec3& v) { return world_vertex(pose, v); }

Pose Pose::rotation(const Vec3& axis, double degrees) { return {rotation_about(axis, degrees), {}}; }

Pose Pose::rigid(const Quaternion& q, const Vec3& translation) { return {rotation_of(q), translation}; }

Pose Pose::nearest_rigid(const Mat3& linear, const Vec3& translation) {
  return {nearest_rotation(linear), translation};
}

std::vector<Vec3> transform(const Pose& pose, std::span<const Vec3> locals) {
  std::vector<Vec3> world;
  world.reserve(locals.size());
  for (const Vec3& v : locals) world.push_back(transform(pose, v));
  return world;
}

Vec3 operator*(const Pose& pose, const Vec3& local) { return world_vertex(pose, local); }

Pose operator*(const Pose& outer, const Pose& inner) {
  Pose result;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) result.linear[i][j] = row_times(outer.linear[i], inner.linear.column(j));
  result.offset = transform(outer, inner.offset);
  return result;
}

Pose inverse(const Pose& pose) {
  if (!is_finite(pose)) throw Error("a pose with a number that is not finite has no inverse");
  if (is_singular(pose.linear)) throw Error("a singular pose (its 3×3 part has determinant 0) has no inverse");
  const Mat3 back = exact_inverse(pose.linear);
  const Pose result{back, -transform({back, {}}, pose.offset)};
  if (!is_finite(result)) throw Error("the inverse of the pose has a number that is not finite; scale the pose");
  return result;
}

Pose scaled(const Pose& pose, double factor) {
  Pose result = pose;
  for (Vec3& row : result.linear.row) row = factor * row;
  return result;
}

bool is_finite(const Pose& pose) { return is_finite(pose.linear) && is_finite(pose.offset); }

bool is_singular(const Mat3& m) {
  const Vec3 zero{};
  return triple_product_sign({m[0], zero}, {m[1], zero}, {m[2], zero}) == Sign::zero;
}

}  // namespace toccata
