#pragma once

#include <array>

#include "math/filter.hpp"
#include "toccata/math/predicates.hpp"
#include "toccata/shapes/primitives.hpp"

namespace toccata {

/// On which sides of a triangle's plane the vertices of another lie, as orient3d tells.
struct PlaneSides {
  std::array<Sign, 3> of{};

  constexpr Sign operator[](int i) const { return of[static_cast<std::size_t>(i)]; }
  /// All three strictly on one side.
  [[nodiscard]] constexpr bool apart() const { return of[0] != Sign::zero && of[0] == of[1] && of[1] == of[2]; }
  [[nodiscard]] constexpr bool all_zero() const {
    return of[0] == Sign::zero && of[1] == Sign::zero && of[2] == Sign::zero;
  }
};

/// The sides as far as plain arithmetic can tell; zero means unknown. The normal is computed once for the three.
inline PlaneSides likely_sides(const Triangle& plane, const Triangle& t) {
  const FilteredCross normal = filtered_cross(plane[1] - plane[0], plane[2] - plane[0]);
  PlaneSides sides;
  for (int i = 0; i < 3; ++i) {
    const Filtered height = filtered_triple_product(normal, t[i] - plane[0]);
    sides.of[static_cast<std::size_t>(i)] = height.is_positive()   ? Sign::positive
                                            : height.is_negative() ? Sign::negative
                                                                   : Sign::zero;
  }
  return sides;
}

/// Lies in the plane for a reason that needs no arithmetic: most of what a filter cannot decide in meshes.
inline bool plainly_in_plane(const Vec3& v, const Triangle& plane) {
  if (v == plane[0] || v == plane[1] || v == plane[2]) return true;
  for (int axis = 0; axis < 3; ++axis)
    if (v[axis] == plane[0][axis] && v[axis] == plane[1][axis] && v[axis] == plane[2][axis]) return true;
  return false;
}

/// Decides what `likely_sides` left unknown.
inline PlaneSides exact_sides(PlaneSides likely, const Triangle& plane, const Triangle& t) {
  for (int i = 0; i < 3; ++i)
    if (likely[i] == Sign::zero && !plainly_in_plane(t[i], plane))
      likely.of[static_cast<std::size_t>(i)] = orient3d(plane[0], plane[1], plane[2], t[i]);
  return likely;
}

/// How two triangles lie to each other's planes.
struct MutualSides {
  bool apart = false;  ///< one of the planes keeps them apart
  bool flat = false;   ///< they are coplanar, or one of them has no area and so no plane
  PlaneSides of_a;     ///< where neither: the vertices of a against the plane of b
  PlaneSides of_b;
};

inline MutualSides mutual_sides(const Triangle& a, const Triangle& b) {
  constexpr MutualSides apart{true, false, {}, {}}, flat{false, true, {}, {}};
  // Both filters come before any exact sign.
  const PlaneSides likely_b = likely_sides(a, b);
  if (likely_b.apart()) return apart;
  const PlaneSides likely_a = likely_sides(b, a);
  if (likely_a.apart()) return apart;
  const PlaneSides of_b = exact_sides(likely_b, a, b);
  if (of_b.apart()) return apart;
  if (of_b.all_zero()) return flat;
  const PlaneSides of_a = exact_sides(likely_a, b, a);
  if (of_a.apart()) return apart;
  if (of_a.all_zero()) return flat;
  return {false, false, of_a, of_b};
}

}  // namespace toccata
