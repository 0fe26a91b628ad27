#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

#include "toccata/bounds/volume.hpp"
#include "toccata/narrow/convex_convex.hpp"
#include "toccata/narrow/posed_shapes.hpp"

namespace toccata {

/// A discrete orientation polytope: all points x with lower_i ≤ normal_i · x ≤ upper_i, in real numbers, for k/2 fixed
/// normals with components −1, 0 and 1. k = 6: the axes, a box; 14: and the diagonals of the cube; 18: the axes and the
/// diagonals of its faces; 26: all. Empty until something is put in. (J. T. Klosowski, M. Held, J. S. B. Mitchell, H.
/// Sowizral, K. Zikan, "Efficient collision detection using bounding volume hierarchies of k-DOPs", 1998.)
template <std::size_t k>
requires(k == 6 || k == 14 || k == 18 || k == 26) struct Kdop {
  static constexpr std::string_view name = k == 6 ? "6-dop" : k == 14 ? "14-dop" : k == 18 ? "18-dop" : "26-dop";
  static constexpr double microseconds = k == 6 ? 0.3 : k == 14 ? 0.5 : k == 18 ? 0.7 : 1;
  static constexpr std::size_t slabs = k / 2;
  std::array<double, slabs> lower = filled(std::numeric_limits<double>::infinity());
  std::array<double, slabs> upper = filled(-std::numeric_limits<double>::infinity());

  friend constexpr bool operator==(const Kdop&, const Kdop&) = default;

 private:
  static constexpr std::array<double, slabs> filled(double value) {
    std::array<double, slabs> all{};
    all.fill(value);
    return all;
  }
};

/// The normals, axes first, not of unit length.
template <std::size_t k>
[[nodiscard]] constexpr std::array<Vec3, k / 2> kdop_normals() {
  constexpr std::array<Vec3, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  constexpr std::array<Vec3, 6> edges{{{1, 1, 0}, {1, -1, 0}, {1, 0, 1}, {1, 0, -1}, {0, 1, 1}, {0, 1, -1}}};
  constexpr std::array<Vec3, 4> corners{{{1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {1, -1, -1}}};
  std::array<Vec3, k / 2> normals{};
  std::size_t count = 0;
  for (const Vec3& n : axes) normals[count++] = n;
  if constexpr (k == 18 || k == 26)
    for (const Vec3& n : edges) normals[count++] = n;
  if constexpr (k == 14 || k == 26)
    for (const Vec3& n : corners) normals[count++] = n;
  return normals;
}

// Slabs from the farthest points; merging is exact.
template <>
Kdop<6> fit<Kdop<6>>(std::span<const Vec3> points);
template <>
Kdop<14> fit<Kdop<14>>(std::span<const Vec3> points);
template <>
Kdop<18> fit<Kdop<18>>(std::span<const Vec3> points);
template <>
Kdop<26> fit<Kdop<26>>(std::span<const Vec3> points);
template <>
Kdop<6> fit<Kdop<6>>(std::span<const Triangle> triangles);
template <>
Kdop<14> fit<Kdop<14>>(std::span<const Triangle> triangles);
template <>
Kdop<18> fit<Kdop<18>>(std::span<const Triangle> triangles);
template <>
Kdop<26> fit<Kdop<26>>(std::span<const Triangle> triangles);

template <std::size_t k>
[[nodiscard]] constexpr bool is_empty(const Kdop<k>& v) {
  return !(v.lower[0] <= v.upper[0]);
}
/// The bound follows from three slabs: the direction is a sum of non-negative multiples of three normals, those of the
/// corner of the polytope that it points to (weak duality of linear programming).
template <std::size_t k>
[[nodiscard]] double support_bound(const Kdop<k>& v, const Vec3& direction, const Vec3& from);
/// That corner. Where slabs are so loose that it is cut off by others, it is not a point of the polytope.
template <std::size_t k>
[[nodiscard]] Vec3 farthest_point(const Kdop<k>& v, const Vec3& direction);
template <std::size_t k>
[[nodiscard]] Vec3 middle(const Kdop<k>& v);

template <std::size_t k>
[[nodiscard]] Kdop<k> merge(const Kdop<k>& a, const Kdop<k>& b);
template <std::size_t k>
[[nodiscard]] bool contains(const Kdop<k>& v, const Vec3& point);
/// Every slab of the outer one holds that of the inner one.
template <std::size_t k>
[[nodiscard]] bool contains(const Kdop<k>& outer, const Kdop<k>& inner) {
  return merge(outer, inner) == outer;
}
/// True when all slabs overlap, which polytopes that are apart may do: edges are not tried against edges.
template <std::size_t k>
[[nodiscard]] bool overlap(const Kdop<k>& a, const Kdop<k>& b);
/// The gap is at least what the slabs give, and more where the nearest points are on edges or corners.
template <std::size_t k>
[[nodiscard]] double gap(const Kdop<k>& a, const Kdop<k>& b);
/// The slabs of the turned polytope, by the support above: looser than slabs fitted anew to the turned points.
template <std::size_t k>
[[nodiscard]] Kdop<k> posed(const Kdop<k>& v, const Pose& pose);
template <std::size_t k>
[[nodiscard]] Aabb box_around(const Kdop<k>& v);
/// Both by cutting out every face, so a hundred times slower than the other questions.
template <std::size_t k>
[[nodiscard]] double measure(const Kdop<k>& v);
template <std::size_t k>
[[nodiscard]] double surface_area(const Kdop<k>& v);
/// The corners that are left where slabs cut off others, rounded; none where a slab is beyond the finite doubles.
template <std::size_t k>
[[nodiscard]] std::vector<Vec3> corner_points(const Kdop<k>& v);
/// Half the surface area of the box around it: what walks and builders compare has to be cheap.
template <std::size_t k>
[[nodiscard]] double half_area(const Kdop<k>& v);

}  // namespace toccata

// A sphere against a k-DOP, by the slabs that its centre violates: the lecture's 27 regions of a box
// (narrow/primitives.hpp), for all k. Exact.
namespace toccata {

/// The planes of a k-DOP that a point lies beyond, two bits for each slab: bit 2i: normal_i · p < lower_i, bit 2i + 1:
/// normal_i · p > upper_i. Exact for finite points and slabs. No bit: the point is inside. For k = 6 it is
/// `box_region`.
template <std::size_t k>
[[nodiscard]] std::uint32_t kdop_region(const Vec3& p, const Kdop<k>& kdop);

/// The sphere and the k-DOP have a point in common; touching counts. Exact. False for a k-DOP that is empty. The slabs
/// of one that is not have to be finite and to have a point in common, as those that are fitted or merged have.
///
/// Where the centre lies beyond one plane only, the nearest point may still lie on an edge: planes that meet at an
/// acute angle cut the foot off. So the region tells where to begin, and planes are added that the nearest point so far
/// violates, until it violates none (D. Goldfarb, A. Idnani, "A numerically stable dual method for solving strictly
/// convex quadratic programs", 1983): in doubles with a bound on the error, and where that leaves a doubt, in integers.
template <std::size_t k>
[[nodiscard]] bool overlap_by_regions(const PosedSphere& sphere, const Kdop<k>& kdop);

/// The nearest points of a sphere and a k-DOP, found as above, in integers; a sphere of radius 0 is a point. Where the
/// centre is inside, it is the point of both. Throws Error for a k-DOP that is empty.
template <std::size_t k>
[[nodiscard]] Distance distance(const PosedSphere& sphere, const Kdop<k>& kdop);

}  // namespace toccata
