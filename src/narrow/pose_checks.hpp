#pragma once

#include <cmath>
#include <cstddef>
#include <string_view>

#include "toccata/math/pose.hpp"

// What a pose has to be for a shape (docs/truth.md). `who` names the shape in messages: "the sphere".
namespace toccata {

/// The largest row sum of |RᵀR − I| is more than 2⁻¹⁰, exactly: no rotation that drifted or was rounded to
/// floats, but one that was meant to stretch. Precondition: finite.
[[nodiscard]] bool deforms(const Mat3& linear);

/// A rotation, or a mirrored one, but for a few roundings; such a matrix is finite, does not deform and is not
/// singular. "No" says nothing. (The largest row sum of a symmetric matrix is at most √3 times the root of the sum of
/// its squares, which is below 2⁻⁴² here, but for an error of less than 2⁻⁴⁸. NaN and what is not finite end in "no".)
[[nodiscard]] inline bool is_surely_rigid(const Mat3& m) {
  const Vec3 x = m.column(0), y = m.column(1), z = m.column(2);
  const double xx = dot(x, x) - 1, yy = dot(y, y) - 1, zz = dot(z, z) - 1;
  const double xy = dot(x, y), yz = dot(y, z), zx = dot(z, x);
  return ((xx * xx + yy * yy) + zz * zz) + 2 * ((xy * xy + yz * yz) + zx * zx) < 0x1p-84;
}

/// "No" says nothing.
[[nodiscard]] inline bool is_surely_finite(const Vec3& v) {
  return (std::fabs(v.x) + std::fabs(v.y)) + std::fabs(v.z) < 0x1p1000;
}

/// Throws Error unless all twelve numbers are finite.
void require_finite(const Pose& pose, std::string_view who);

/// Throws Error, telling by how much and naming `nearest_rotation` and the ellipsoid, when the pose deforms.
/// Precondition: finite.
void require_undeformed(const Pose& pose, std::string_view who);

/// Throws Error when the determinant is 0: the pose would flatten a solid. Precondition: finite.
void require_regular(const Pose& pose, std::string_view who);

/// Throws Error: the world vertex of vertex `number` at `local` is not finite.
[[noreturn]] void refuse_vertex(std::size_t number, const Vec3& local, const Pose& pose, std::string_view who);

}  // namespace toccata
