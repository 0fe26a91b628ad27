#pragma once

#include <array>
#include <cstddef>

#include "narrow/convex/facet_slots.hpp"
#include "toccata/narrow/posed_polytope.hpp"

namespace toccata {

/// A closed surface of triangles whose corners are points of the Minkowski difference D = A − B, as a search in doubles
/// left it: a sphere, as each step replaces a disc by a fan. Which facets a point sees was decided by rounded numbers,
/// so that it need not be convex.
struct FastSurface {
  static constexpr std::size_t most_points = FacetSlots::most_corners;
  static constexpr std::size_t most_facets = FacetSlots::most_facets;

  // For points: a − b, each coordinate rounded once, and of which vertices.
  std::array<double, most_points> x, y, z;
  std::array<Index, most_points> on_a, on_b;
  Index points = 0;

  FacetSlots facets;
  // For facets, by their slots: the rounded cross product of two edges, outwards, and its product with a corner, with
  // what rounding makes of such a product; the squared distance from the origin with the sign of the product, but for
  // the last bits, which hold the number of the facet. Zero, and an infinite distance, of vacant slots and up to the
  // next multiple of 8.
  alignas(64) std::array<double, most_facets> normal_x;
  alignas(64) std::array<double, most_facets> normal_y;
  alignas(64) std::array<double, most_facets> normal_z;
  alignas(64) std::array<double, most_facets> offset;
  alignas(64) std::array<double, most_facets> rounding;
  alignas(64) std::array<double, most_facets> order;

  Index nearest = 0;  ///< the facet that is nearest to the origin, when it is found

  [[nodiscard]] Vec3 point(Index i) const { return {x[i], y[i], z[i]}; }
  [[nodiscard]] Vec3 normal(Index f) const { return {normal_x[f], normal_y[f], normal_z[f]}; }
};

/// Expands a polytope of points of D until nothing seems to lie beyond the facet that is nearest to the origin (G. van
/// den Bergen, "Proximity queries and penetration depth computation on 3D game objects", 2001). False when that did not
/// come to an end, the origin is not well within D, or the numbers are too large or too small. What it finds is a
/// guess, though the surface is closed, and the same at every SIMD level.
[[nodiscard]] bool expand_fast(const PosedPolytope& a, const PosedPolytope& b, FastSurface& surface);

}  // namespace toccata
