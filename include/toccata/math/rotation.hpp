#pragma once

#include "toccata/math/mat3.hpp"
#include "toccata/math/pose.hpp"

namespace toccata {

// Rotations and scales as the matrices that poses hold, by fixed formulas with the same bits on every platform. A pose
// is used as given, so what these round to is what is answered about.

/// Counter-clockwise by `degrees` seen against the axis a / |a|, with c and s of the angle: the diagonal is
/// c (a_j² + a_k²) + a_i², the rest a_i a_j (1 − c) ∓ a_k s (O. Rodrigues, 1840). Quarter turns about a coordinate axis
/// are exact. Throws Error when the axis has no direction.
[[nodiscard]] Mat3 rotation_about(const Vec3& axis, double degrees);

struct Quaternion {
  double x = 0, y = 0, z = 0, w = 1;
};

/// With n = x² + y² + z² + w²: the diagonal is 1 − 2 (q_j² + q_k²) / n, the rest 2 (q_i q_j ∓ q_k w) / n. The
/// quaternion need not have length 1. Throws Error when n is 0 or not finite.
[[nodiscard]] Mat3 rotation_of(const Quaternion& q);

/// Scales first, then rotates, then moves: column j of the rotation is multiplied by component j of the scale.
[[nodiscard]] Pose pose_of(const Vec3& translation, const Mat3& rotation, const Vec3& scale);

}  // namespace toccata
