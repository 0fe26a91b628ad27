#pragma once

#include <array>

#include "math/filter.hpp"
#include "toccata/math/predicates.hpp"
#include "toccata/shapes/triangle.hpp"

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

/// Decides what `likely_sides` left unknown.
inline PlaneSides exact_sides(PlaneSides likely, const Triangle& plane, const Triangle& t) {
  for (int i = 0; i < 3; ++i) {
    if (likely[i] != Sign::zero) continue;
    // Shared vertices are most of what a filter cannot decide in meshes, and need no arithmetic.
    if (t[i] == plane[0] || t[i] == plane[1] || t[i] == plane[2]) continue;
    likely.of[static_cast<std::size_t>(i)] = orient3d(plane[0], plane[1], plane[2], t[i]);
  }
  return likely;
}

/// The sides of two triangles against each other's planes, or that one of the planes keeps them apart.
struct MutualSides {
  bool apart = false;
  PlaneSides of_a;  ///< the vertices of a against the plane of b
  PlaneSides of_b;
};

inline MutualSides mutual_sides(const Triangle& a, const Triangle& b) {
  MutualSides sides;
  sides.of_b = likely_sides(a, b);
  if (sides.of_b.apart()) return {true, {}, {}};
  sides.of_a = likely_sides(b, a);
  if (sides.of_a.apart()) return {true, {}, {}};
  sides.of_b = exact_sides(sides.of_b, a, b);
  if (sides.of_b.apart()) return {true, {}, {}};
  sides.of_a = exact_sides(sides.of_a, b, a);
  sides.apart = sides.of_a.apart();
  return sides;
}

}  // namespace toccata
