#pragma once

#include <cmath>

#include "math/constants.hpp"
#include "math/vec3_measures.hpp"
#include "narrow/convex/gjk.hpp"
#include "narrow/convex/nearest_weights.hpp"
#include "narrow/quadrics/kinds/quadric_kind.hpp"
#include "query/posed_shape.hpp"
#include "toccata/core/function_ref.hpp"
#include "toccata/query/distance.hpp"

// How far apart two convex sets at their places are along a direction of length 1, certainly, and which direction that
// should be.
namespace toccata {

/// A convex set at its place, with what is made of it once for all directions.
template <PosedConvexSet S>
struct PlacedSet {
  explicit PlacedSet(FunctionRef<S()> place) : set(place()) {}
  S set;
};

template <>
struct PlacedSet<PosedPolytope> {
  explicit PlacedSet(FunctionRef<PosedPolytope()> place) : set(place()), search(set, kernels) {}
  PlacedSet(const PlacedSet&) = delete;
  PlacedSet& operator=(const PlacedSet&) = delete;
  PosedPolytope set;
  SupportKernels kernels = support_kernels();
  SupportSearch search;  ///< refers to both
};

/// No point of the set is lower along the direction; NaN where nothing is certain.
[[nodiscard]] inline double lowest(const PlacedSet<PosedPolytope>& placed, const Vec3& direction) {
  const double of_core = placed.search.lower_bound(direction);
  // The length of the direction is 1 but for less than 2⁻⁵⁰.
  return of_core - placed.set.radius() * (1 + 0x1p-48);
}

/// The products and sums of a height pass less than 16 roundings, each of at most u of the sizes.
[[nodiscard]] inline double lowest(const PlacedSet<PosedQuadric>& placed, const Vec3& direction) {
  const PosedQuadric& shape = placed.set;
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
[[nodiscard]] double separation_along(const PlacedSet<A>& a, const PlacedSet<B>& b, const Vec3& direction) {
  const double low_b = lowest(b, direction), high_a = -lowest(a, -direction);
  return (low_b - high_a) - 2 * unit_roundoff * (std::fabs(low_b) + std::fabs(high_a));
}

/// Of a half-space the direction is its own, whatever is given; where its normal has no length of doubles, nothing is
/// certain. The height of its point passes four roundings.
template <class A>
[[nodiscard]] double separation_along(const PlacedSet<A>& a, const PlacedSet<PosedHalfSpace>& b, const Vec3&) {
  const Vec3 up = normalized(b.set.normal);
  const double low = lowest(a, up), level = dot(up, b.set.point);
  const double rounded = 8 * unit_roundoff * sum_of_magnitudes(b.set.point) + 2 * unit_roundoff * std::fabs(low);
  return (low - level) - rounded - 0x1p-1000;
}
template <class B>
[[nodiscard]] double separation_along(const PlacedSet<PosedHalfSpace>& a, const PlacedSet<B>& b,
                                      const Vec3& direction) {
  return separation_along(b, a, direction);
}

/// Where a search in doubles ends that starts from what is kept, which its end becomes.
[[nodiscard]] inline GjkEnd nearest_pairs(const PlacedSet<PosedPolytope>& a, const PlacedSet<PosedPolytope>& b,
                                          VertexPairs& kept) {
  const GjkEnd end = search_nearest(a.search, b.search, kept, {.gap = std::nan("")});
  if (!end.inside) kept = end.simplex.pairs;
  return end;
}

/// From A to B, of length 1 or zero. What is kept saves time.
[[nodiscard]] inline Vec3 parting_direction(const PlacedSet<PosedPolytope>& a, const PlacedSet<PosedPolytope>& b,
                                            VertexPairs& kept) {
  const GjkEnd end = nearest_pairs(a, b, kept);
  return end.inside ? Vec3{} : -normalized(end.nearest);
}
template <class A>
[[nodiscard]] Vec3 parting_direction(const PlacedSet<A>&, const PlacedSet<PosedHalfSpace>& b, VertexPairs&) {
  return -normalized(b.set.normal);
}
template <class B>
[[nodiscard]] Vec3 parting_direction(const PlacedSet<PosedHalfSpace>& a, const PlacedSet<B>&, VertexPairs&) {
  return normalized(a.set.normal);
}
template <class A, class B>
[[nodiscard]] Vec3 parting_direction(const PlacedSet<A>& a, const PlacedSet<B>& b, VertexPairs&) {
  const Distance found = distance(a.set, b.set);
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

/// The point of B that is nearest to A, nearly; one of both where they overlap.
template <class A, class B>
[[nodiscard]] Vec3 nearest_on_b(const PlacedSet<A>& a, const PlacedSet<B>& b, VertexPairs&) {
  return distance_of(a.set, b.set).on_b;
}
/// Exact arithmetic takes over where the search does not tell.
[[nodiscard]] inline Vec3 nearest_on_b(const PlacedSet<PosedPolytope>& a, const PlacedSet<PosedPolytope>& b,
                                       VertexPairs& kept) {
  const GjkEnd end = nearest_pairs(a, b, kept);
  const auto& pairs = end.simplex.pairs;
  const auto weights = nearest_weights(end.simplex.point, pairs.size);
  Vec3 point = b.set.radius() * normalized(end.nearest);
  for (std::size_t i = 0; i < pairs.size; ++i) point += weights[i] * b.search.vertex(pairs.b[i]);
  return end.inside || !is_finite(point) ? distance(a.set, b.set).on_b : point;
}

/// They certainly have a point in common; of a quadric what is undecided is not. What is kept saves time.
template <class A, class B>
[[nodiscard]] bool certainly_overlap(const A& a, const B& b, SimplexCache& kept) {
  if constexpr (std::same_as<A, PosedQuadric> || std::same_as<B, PosedQuadric>)
    return quadric_contact(a, b) == QuadricContact::contact;
  else if constexpr (std::same_as<A, PosedHalfSpace>)
    return overlap(b, a);
  else if constexpr (std::same_as<B, PosedHalfSpace>)
    return overlap(a, b);
  else
    return overlap(a, b, &kept);
}

/// All sets that differ from these by less than `off`, point for point and both together, have a point in common.
///
/// The difference A − B is convex. Where A, shifted to each of the four corners of a regular tetrahedron, meets B, the
/// difference contains the tetrahedron, and a ball of 1/√3 of a corner's coordinates. Then the heights of A and B
/// overlap by as much along every direction; sets that differ by less still do along all, so no plane parts them. The
/// coordinates are twice `off`, 2 > √3, and what is left covers the rounding of the shift.
template <class A, class B>
[[nodiscard]] bool overlap_by(const A& a, const B& b, double off) {
  const double by = 2 * off;
  SimplexCache kept;
  for (const Vec3& shift : {Vec3{by, by, by}, Vec3{by, -by, -by}, Vec3{-by, by, -by}, Vec3{-by, -by, by}}) {
    if constexpr (std::same_as<A, PosedHalfSpace>) {
      if (!certainly_overlap(a, b.moved(shift), kept)) return false;
    } else {
      if (!certainly_overlap(a.moved(shift), b, kept)) return false;
    }
  }
  return true;
}

}  // namespace toccata
