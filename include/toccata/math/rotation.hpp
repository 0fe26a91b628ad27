#pragma once

#include "toccata/math/mat3.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/math/quaternion.hpp"

namespace toccata {

// Rotations and scales as the matrices that poses hold, by fixed formulas with the same bits on every platform. A pose
// is used as given, so what these round to is what is answered about.

/// Counter-clockwise by `degrees` seen against the axis a / |a|, with c and s of the angle: the diagonal is
/// c (a_j² + a_k²) + a_i², the rest a_i a_j (1 − c) ∓ a_k s (O. Rodrigues, 1840). Quarter turns about a coordinate axis
/// are exact. Throws Error when the axis has no direction.
[[nodiscard]] Mat3 rotation_about(const Vec3& axis, double degrees);

/// With n = x² + y² + z² + w²: the diagonal is 1 − 2 (q_j² + q_k²) / n, the rest 2 (q_i q_j ∓ q_k w) / n. The
/// quaternion need not have length 1. Throws Error when n is 0 or not finite.
[[nodiscard]] Mat3 rotation_of(const Quaternion& q);

/// The rotation nearest to `m` in the Frobenius norm, its orthogonal polar factor, by Newton's iteration scaled (N. J.
/// Higham, "Computing the polar decomposition — with applications", SIAM J. Sci. Stat. Comput. 7, 1986, section 3) in
/// doubles: off by about 2⁻⁴⁸ times what the greatest singular value is of the sum of the two least. Of what drifted or
/// came from floats it makes a pose that every shape accepts. Throws Error when `m` is not finite, its exact
/// determinant is not positive (it mirrors or flattens), or it is so nearly singular that doubles do not tell the
/// rotation.
[[nodiscard]] Mat3 nearest_rotation(const Mat3& m);

/// Scales first, then rotates, then moves: column j of the rotation is multiplied by component j of the scale.
[[nodiscard]] Pose pose_of(const Vec3& translation, const Mat3& rotation, const Vec3& scale);

}  // namespace toccata
