#pragma once

#include <cmath>

#include "math/constants.hpp"
#include "math/vec3_measures.hpp"
#include "narrow/convex/gjk.hpp"
#include "narrow/quadrics/kinds/quadric_kind.hpp"
#include "query/posed_shape.hpp"
#include "toccata/query/distance.hpp"

// How far apart two convex sets at their places are along a direction of length 1, certainly, and which direction that
// should be.
namespace toccata {

/// No point of the set is lower along the direction; NaN where nothing is certain.
[[nodiscard]] inline double lowest(const PosedPolytope& shape, const Vec3& direction) {
  const SupportKernels kernels = support_kernels();
  const double of_core = SupportSearch(shape, kernels).lower_bound(direction);
  // The length of the direction is 1 but for less than 2⁻⁵⁰.
  return of_core - shape.radius() * (1 + 0x1p-48);
}

/// The products and sums of a height pass less than 16 roundings, each of at most u of the sizes.
[[nodiscard]] inline double lowest(const PosedQuadric& shape, const Vec3& direction) {
  const Mat3& linear = shape.pose().linear;
  const Vec3& half = shape.half();
  const double x = half.x * dot(direction, linear.column(0)), y = half.y * dot(direction, linear.column(1)),
               z = half.z * dot(direction, linear.column(2));
  Vec3 size = magnitudes(shape.pose().offset);
  for (int i = 0; i < 3; ++i) size[i] += dot(magnitudes(linear[i]), half);
  const QuadricReach reach = with_kind(shape.kind(), [&](auto kind) { return kind.reach(x, y, z); });
  return (dot(direction, shape.pose().offset) - reach.down) -
         (32 * unit_roundoff * sum_of_magnitudes(size) + 0x1p-1000);
}

template <class A, class B>
[[nodiscard]] double separation_along(const A& a, const B& b, const Vec3& direction) {
  const double low_b = lowest(b, direction), high_a = -lowest(a, -direction);
  return (low_b - high_a) - 2 * unit_roundoff * (std::fabs(low_b) + std::fabs(high_a));
}

/// Of a half-space the direction is its own, whatever is given; where its normal has no length of doubles, nothing is
/// certain. The height of its point passes four roundings.
template <class A>
[[nodiscard]] double separation_along(const A& a, const PosedHalfSpace& b, const Vec3&) {
  const Vec3 up = normalized(b.normal);
  const double low = lowest(a, up), level = dot(up, b.point);
  const double rounded = 8 * unit_roundoff * sum_of_magnitudes(b.point) + 2 * unit_roundoff * std::fabs(low);
  return (low - level) - rounded - 0x1p-1000;
}
template <class B>
[[nodiscard]] double separation_along(const PosedHalfSpace& a, const B& b, const Vec3& direction) {
  return separation_along(b, a, direction);
}

/// From A to B, of length 1 or zero. What is kept saves time.
[[nodiscard]] inline Vec3 parting_direction(const PosedPolytope& a, const PosedPolytope& b, VertexPairs& kept) {
  const SupportKernels kernels = support_kernels();
  const GjkEnd end = search_nearest(SupportSearch(a, kernels), SupportSearch(b, kernels), kept, {.gap = std::nan("")});
  if (end.inside) return {};
  kept = end.simplex.pairs;
  return -normalized(end.nearest);
}
template <class A>
[[nodiscard]] Vec3 parting_direction(const A&, const PosedHalfSpace& b, VertexPairs&) {
  return -normalized(b.normal);
}
template <class B>
[[nodiscard]] Vec3 parting_direction(const PosedHalfSpace& a, const B&, VertexPairs&) {
  return normalized(a.normal);
}
template <class A, class B>
[[nodiscard]] Vec3 parting_direction(const A& a, const B& b, VertexPairs&) {
  const Distance found = distance(a, b);
  return normalized(found.on_b - found.on_a);
}

/// The same of sets that overlap: along it they part in the shortest way.
template <class A, class B>
[[nodiscard]] Vec3 direction_of_depth(const A& a, const B& b) {
  if constexpr (std::same_as<A, PosedHalfSpace>)
    return -manifold(b, a).normal;
  else
    return manifold(a, b).normal;
}

[[nodiscard]] inline Distance distance_of(const PosedHalfSpace& a, const PosedPolytope& b) {
  return flipped(distance(b, a));
}
template <class A, class B>
[[nodiscard]] Distance distance_of(const A& a, const B& b) {
  return distance(a, b);
}

/// They certainly have a point in common; of a quadric what is undecided is not.
template <class A, class B>
[[nodiscard]] bool certainly_overlap(const A& a, const B& b) {
  if constexpr (std::same_as<A, PosedQuadric> || std::same_as<B, PosedQuadric>)
    return quadric_contact(a, b) == QuadricContact::contact;
  else if constexpr (std::same_as<A, PosedHalfSpace>)
    return overlap(b, a);
  else
    return overlap(a, b);
}

/// All sets that differ from these by less than `off`, point for point and both together, have a point in common.
///
/// The difference A − B is convex. Where A, shifted by each of the six corners of an octahedron, meets B, the
/// difference contains the octahedron, and a ball of 1/√3 of its size. Then the heights of A and B overlap by as much
/// along every direction; sets that differ by less still do along all, so no plane parts them. The corners are twice
/// `off` away, 2 > √3, and what is left covers the rounding of the shift.
template <class A, class B>
[[nodiscard]] bool overlap_by(const A& a, const B& b, double off) {
  if (!certainly_overlap(a, b)) return false;
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-2.0, 2.0}) {
      Vec3 shift{};
      shift[axis] = sign * off;
      if constexpr (std::same_as<A, PosedHalfSpace>) {
        if (!certainly_overlap(a, b.moved(shift))) return false;
      } else {
        if (!certainly_overlap(a.moved(shift), b)) return false;
      }
    }
  return true;
}

}  // namespace toccata
