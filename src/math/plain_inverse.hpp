#pragma once

#include "toccata/math/mat3.hpp"

namespace toccata {

/// The transpose of the inverse, in doubles: good to a few roundings where the matrix is nearly a rotation, and for
/// searches that correct themselves.
[[nodiscard]] inline Mat3 plain_inverse_transpose(const Mat3& m) {
  const Vec3 x = cross(m[1], m[2]), y = cross(m[2], m[0]), z = cross(m[0], m[1]);
  const double determinant = dot(m[0], x);
  return {{x / determinant, y / determinant, z / determinant}};
}

}  // namespace toccata
