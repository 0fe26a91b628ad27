#pragma once

#include "toccata/math/predicates.hpp"
#include "toccata/narrow/triangle_triangle.hpp"

namespace toccata {

/// Whether a closed segment and a closed triangle have a point in common; exact. Its ends lie on different sides of the
/// triangle's plane, or one of them in it, and its line passes no two edges on different sides. Where both ends lie in
/// the plane, or there is none, the test of two triangles tells.
inline bool segment_meets_triangle(const Vec3& p, const Vec3& q, const Triangle& t) {
  const Sign of_p = orient3d(t[0], t[1], t[2], p), of_q = orient3d(t[0], t[1], t[2], q);
  if (of_p == of_q) return of_p == Sign::zero && overlap(t, Triangle{{p, q, q}});
  bool is_left = false, is_right = false;
  for (int i = 0; i < 3 && !(is_left && is_right); ++i) {
    const Sign side = orient3d(p, q, t[i], t[(i + 1) % 3]);
    is_left = is_left || side == Sign::positive;
    is_right = is_right || side == Sign::negative;
  }
  return !(is_left && is_right);
}

}  // namespace toccata
