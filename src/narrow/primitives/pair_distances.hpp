#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include "narrow/primitives/pair_kernels.hpp"
#include "toccata/narrow/convex_convex.hpp"
#include "toccata/narrow/posed_shapes.hpp"
#include "toccata/shapes/primitives.hpp"

// Distances of pairs of simple cores, each grown by a radius, by formulas in doubles. Where these do not prove
// themselves `upper` is NaN, and the general search answers. How they do: docs/design/primitive-distances.md. All have
// the same bits alone and in arrays, at every SIMD level.
namespace toccata {

[[nodiscard]] inline bool is_known(const Distance& distance) { return distance.upper >= 0; }

/// Where there is no formula, or it does not prove itself.
[[nodiscard]] inline Distance unknown_distance() { return {.upper = std::numeric_limits<double>::quiet_NaN()}; }

/// The hull of eight corners, numbered as a box's; coordinates along each axis.
struct RoundBox {
  std::array<const double*, 3> corner;
  double radius = 0;
};

// A radius may be 0 here.
[[nodiscard]] Distance formula_distance(const PosedSphere& a, const PosedSphere& b);
[[nodiscard]] Distance formula_distance(const PosedSphere& a, const PosedCapsule& b);
[[nodiscard]] Distance formula_distance(const PosedSphere& a, const Triangle& b, double radius_b);
[[nodiscard]] Distance formula_distance(const PosedSphere& a, const RoundBox& b);
[[nodiscard]] Distance formula_distance(const PosedCapsule& a, const PosedCapsule& b);

/// For two shapes, if there is a formula for the pair and it proves itself.
[[nodiscard]] Distance distance_of_primitives(const PosedPolytope& a, const PosedPolytope& b);

/// Looks at as many pairs from the first on as fill whole vectors, writes a distance of each, and returns how many.
using DistanceKernel = std::size_t (*)(const PairColumns& pairs, Distance* distances);

struct DistanceKernels {
  DistanceKernel sphere_sphere = nullptr;
  DistanceKernel sphere_triangle = nullptr;
  DistanceKernel sphere_box = nullptr;
  DistanceKernel capsule_capsule = nullptr;
};

/// The kernels of the SIMD level in use.
[[nodiscard]] DistanceKernels distance_kernels();

}  // namespace toccata
