#pragma once

#include <array>
#include <span>
#include <vector>

#include "toccata/math/mat3.hpp"
#include "toccata/math/vec3.hpp"

namespace toccata {

/// x i + y j + z k + w, in the order of glTF, of ROS and of GLM's memory. Write `{.x = …, .y = …, .z = …, .w = …}`
/// where yours has w first.
struct Quaternion {
  double x = 0, y = 0, z = 0, w = 1;
};

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

// Rotations and scales as the matrices that poses hold, by fixed formulas with the same bits on every platform. A pose
// is used as given, so what these round to is what is answered about.

/// Counter-clockwise by `degrees` seen against the axis a / |a|, with c and s of the angle: the diagonal is
/// c (a_j² + a_k²) + a_i², the rest a_i a_j (1 − c) ∓ a_k s (O. Rodrigues, 1840). Quarter turns about a coordinate axis
/// are exact. Throws Error when the axis has no direction.
[[nodiscard]] Mat3 rotation_about(const Vec3& axis, double degrees);

/// The rotation matrix of a quaternion. With n = x² + y² + z² + w² the diagonal is 1 − 2 (q_j² + q_k²) / n, the rest 2
/// (q_i q_j ∓ q_k w) / n. The quaternion need not have length 1. Throws Error when n is 0 or not finite.
[[nodiscard]] Mat3 rotation_of(const Quaternion& q);

/// The rotation nearest to `m` in the Frobenius norm, its orthogonal polar factor, by Newton's iteration scaled (N. J.
/// Higham, "Computing the polar decomposition — with applications", SIAM J. Sci. Stat. Comput. 7, 1986, section 3) in
/// doubles: off by about 2⁻⁴⁸ times what the greatest singular value is of the sum of the two least. It makes a pose
/// that every shape accepts of one that drifted or came from floats. Throws Error when `m` is not finite, its exact
/// determinant is not positive (it mirrors or flattens), or it is so nearly singular that doubles do not determine the
/// rotation.
[[nodiscard]] Mat3 nearest_rotation(const Mat3& m);

/// Scales first, then rotates, then moves: column j of the rotation is multiplied by component j of the scale.
[[nodiscard]] Pose pose_of(const Vec3& translation, const Mat3& rotation, const Vec3& scale);

}  // namespace toccata
