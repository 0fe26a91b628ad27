#pragma once

#include <array>
#include <span>
#include <vector>

#include "toccata/math/mat3.hpp"
#include "toccata/math/quaternion.hpp"
#include "toccata/math/vec3.hpp"

namespace toccata {

/// Places a shape in the world: world = linear · local + offset. `linear` is the R and `offset` the t of the truth page
/// (docs/truth.md). It is used exactly as given: it need not be a rotation, and is never re-orthonormalised.
struct Pose {
  Mat3 linear;
  Vec3 offset;

  static constexpr Pose translation(double x, double y, double z) { return {Mat3{}, {x, y, z}}; }
  static constexpr Pose translation(const Vec3& by) { return {Mat3{}, by}; }

  /// `rotation_about` (rotation.hpp), through the origin.
  static Pose rotation(const Vec3& axis, double degrees);

  /// Rotates by `rotation_of(q)`, which divides by the length of q, then moves. Throws Error when that length is 0 or
  /// not finite.
  static Pose rigid(const Quaternion& q, const Vec3& translation);

  /// Rotates by `nearest_rotation(linear)` (rotation.hpp, which says when it throws), then moves. `Pose{linear,
  /// offset}` is the pose that takes a matrix as given.
  static Pose nearest_rigid(const Mat3& linear, const Vec3& translation);

  /// Twelve numbers: R row by row, then t.
  static Pose from_numbers(const std::array<double, 12>& numbers);
  [[nodiscard]] std::array<double, 12> numbers() const;

  friend constexpr bool operator==(const Pose&, const Pose&) = default;
};

/// The world vertex of the truth page: w_i = ((R_i0·x + R_i1·y) + R_i2·z) + t_i in binary64, round to nearest, in this
/// order, never fused. The result may overflow to ±∞; callers that take user data check it.
[[nodiscard]] Vec3 transform(const Pose& pose, const Vec3& local);

/// All of them, in order.
[[nodiscard]] std::vector<Vec3> transform(const Pose& pose, std::span<const Vec3> locals);

/// The same.
[[nodiscard]] Vec3 operator*(const Pose& pose, const Vec3& local);

/// The pose `outer` applied after `inner`, rounded by a fixed formula:
/// R_ij = (O_i0·I_0j + O_i1·I_1j) + O_i2·I_2j, and t = transform(outer, inner.offset).
/// Node chains are composed with it once, from the root down; nothing is composed during a query.
[[nodiscard]] Pose operator*(const Pose& outer, const Pose& inner);

/// The pose that undoes `pose`, any that is not singular: each of its numbers is the double nearest to the exact one of
/// R⁻¹, and t is −R⁻¹ t with this R⁻¹, rounded as `transform` does. So pose * inverse(pose) is the identity but for
/// rounding. Throws Error when a number is not finite, given or found, or `pose` is singular.
[[nodiscard]] Pose inverse(const Pose& pose);

/// `pose` with every number of its linear part multiplied by `factor`: a mesh in another unit, placed.
[[nodiscard]] Pose scaled(const Pose& pose, double factor);

[[nodiscard]] bool is_finite(const Pose& pose);

/// The sign of the exact determinant of `m` is zero.
[[nodiscard]] bool is_singular(const Mat3& m);

}  // namespace toccata
