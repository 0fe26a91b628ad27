#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

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

/// For a half-space the direction is its own, whatever is given; where its normal has no length of doubles, nothing is
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

/// A direction from A to B, of length 1 or zero. What is kept saves time.
[[nodiscard]] inline Vec3 separating_direction(const PlacedSet<PosedPolytope>& a, const PlacedSet<PosedPolytope>& b,
                                               VertexPairs& kept) {
  const GjkEnd end = nearest_pairs(a, b, kept);
  return end.inside ? Vec3{} : -normalized(end.nearest);
}
template <class A>
[[nodiscard]] Vec3 separating_direction(const PlacedSet<A>&, const PlacedSet<PosedHalfSpace>& b, VertexPairs&) {
  return -normalized(b.set.normal);
}
template <class B>
[[nodiscard]] Vec3 separating_direction(const PlacedSet<PosedHalfSpace>& a, const PlacedSet<B>&, VertexPairs&) {
  return normalized(a.set.normal);
}
template <class A, class B>
[[nodiscard]] Vec3 separating_direction(const PlacedSet<A>& a, const PlacedSet<B>& b, VertexPairs&) {
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

/// Whether they certainly have a point in common; what is undecided of a quadric is not certain. What is kept saves
/// time.
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

/// More than the magnitude of any coordinate of the set, but for its radius: what a shift of it is rounded by, in u.
[[nodiscard]] inline double greatest_coordinates(const PosedPolytope& set) {
  double greatest = 0;
  if (set.in_world())
    for (Index i = 0; i < set.vertex_count(); ++i) greatest = std::max(greatest, sum_of_magnitudes(set.vertex(i)));
  else
    for (int i = 0; i < 3; ++i)
      greatest += sum_of_magnitudes(set.pose().linear[i]) * set.stored_extent() + std::fabs(set.pose().offset[i]);
  return greatest;
}
[[nodiscard]] inline double greatest_coordinates(const PosedQuadric& set) {
  double greatest = sum_of_magnitudes(set.pose().offset);
  for (int i = 0; i < 3; ++i) greatest += dot(magnitudes(set.pose().linear[i]), set.half());
  return greatest;
}

/// A half-space is not shifted.
template <class A, class B>
[[nodiscard]] bool shifts_first(const A& a, const B& b) {
  if constexpr (std::same_as<A, PosedHalfSpace>)
    return false;
  else if constexpr (std::same_as<B, PosedHalfSpace>)
    return true;
  else
    return greatest_coordinates(a) <= greatest_coordinates(b);
}

/// The corners of a regular tetrahedron, which contains the ball of radius 1/√3 around the origin, and of an
/// octahedron, which does too; of the second none is farther than 1, of the first √3.
inline constexpr std::array<Vec3, 4> tetrahedron_corners{Vec3{1, 1, 1}, Vec3{1, -1, -1}, Vec3{-1, 1, -1},
                                                         Vec3{-1, -1, 1}};
inline constexpr std::array<Vec3, 6> octahedron_corners{Vec3{1, 0, 0},  Vec3{-1, 0, 0}, Vec3{0, 1, 0},
                                                        Vec3{0, -1, 0}, Vec3{0, 0, 1},  Vec3{0, 0, -1}};

/// All sets that differ from these by less than `off`, point for point and both together, have a point in common.
///
/// The difference A − B is convex. Where one of the sets, shifted by 2 off times each of the corners, meets the other,
/// the difference contains the hull of so many corners or its mirror image, and a ball of 2 off / √3. Then the heights
/// of A and B overlap by as much along every direction; sets that differ by less still do along all, so no plane parts
/// them. What is left, 2 > √3, covers the rounding of the shift, of the smaller of the two: `off` holds what the poses
/// of those that move are off by, a hundred u of their coordinates, and so of the smaller one's.
template <class A, class B>
[[nodiscard]] bool overlap_by(const A& a, const B& b, double off, std::span<const Vec3> corners) {
  SimplexCache kept;
  const bool of_first = shifts_first(a, b);
  return std::all_of(corners.begin(), corners.end(), [&](const Vec3& corner) {
    const Vec3 shift = (2 * off) * corner;
    if constexpr (!std::same_as<A, PosedHalfSpace>)
      if (of_first) return certainly_overlap(a.moved(shift), b, kept);
    if constexpr (!std::same_as<B, PosedHalfSpace>)
      if (!of_first) return certainly_overlap(a, b.moved(shift), kept);
    return false;
  });
}

}  // namespace toccata
