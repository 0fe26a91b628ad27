#pragma once

#include <array>
#include <span>
#include <vector>

#include "toccata/core/index.hpp"
#include "toccata/math/vec3.hpp"

namespace toccata {

/// A triangle on the boundary of a hull, counter-clockwise seen from outside. `neighbours[i]` lies across the edge from
/// vertex i to the next.
struct HullTriangle {
  std::array<Index, 3> vertices{};
  std::array<Index, 3> neighbours{};
};

/// The boundary of the convex hull of the points as triangles with area; vertices are numbers of points. Neighbours may
/// be coplanar, and a vertex may lie within an edge or a face of the hull. `simplex` are four points that are not in
/// one plane. The first of equal points is used.
///
/// Quickhull (C. B. Barber, D. P. Dobkin, H. Huhdanpaa, 1996) with exact signs in place of their tolerances.
[[nodiscard]] std::vector<HullTriangle> quickhull(std::span<const Vec3> points, const std::array<Index, 4>& simplex);

}  // namespace toccata
