#pragma once

#include <span>

#include "toccata/math/mat3.hpp"
#include "toccata/math/vec3.hpp"
#include "toccata/shapes/triangle.hpp"

namespace toccata {

/// How points, or the surface of triangles, are spread: the mean, the principal axes as rows (unit, right-handed, by
/// descending spread), and the standard deviation along each, in the units of the points.
struct PrincipalAxes {
  Vec3 mean;
  Mat3 axes;
  Vec3 spread;
};

/// Every point counts alike. No points: the coordinate axes at the origin. Throws Error when a coordinate is not finite
/// or of magnitude above 2^1000.
[[nodiscard]] PrincipalAxes principal_axes(std::span<const Vec3> points);

/// Every piece of surface counts alike, so that it does not matter how finely which part is cut into triangles: with
/// areas A, centroids m and corners p, q, r of each triangle, the covariance is
/// Σ A/12 (9 m mᵀ + p pᵀ + q qᵀ + r rᵀ) / ΣA − μ μᵀ, where μ = Σ A m / ΣA (S. Gottschalk, M. C. Lin, D. Manocha,
/// "OBBTree: a hierarchical structure for rapid interference detection", 1996, as corrected by their erratum; the
/// formula in print is wrong). Triangles without any area: their vertices count. Errors as above.
[[nodiscard]] PrincipalAxes principal_axes(std::span<const Triangle> triangles);

}  // namespace toccata
