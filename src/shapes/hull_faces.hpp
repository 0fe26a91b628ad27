#pragma once

#include <span>
#include <vector>

#include "shapes/quickhull.hpp"

namespace toccata {

/// The faces of a convex hull as HullTopology describes them, their corners as numbers of points, in no order.
struct HullFaces {
  int dimension = 0;
  std::vector<Index> corners;
  std::vector<Index> first{0};  ///< face i has the corners [first[i], first[i + 1])

  void close_face() { first.push_back(static_cast<Index>(corners.size())); }
};

/// The faces of the hull of finite points, at least one. Where the hull is one point, the only corner belongs to no
/// face.
[[nodiscard]] HullFaces hull_faces(std::span<const Vec3> points);

/// The same as triangles, if it is not flat; else none.
[[nodiscard]] std::vector<HullTriangle> hull_triangles(std::span<const Vec3> points);

/// The hull of points in one plane, of which the first three are not on one line, by the numbers of these three.
/// A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions", 1979.
[[nodiscard]] HullFaces flat_hull_faces(std::span<const Vec3> points, const std::array<Index, 3>& triangle);

/// Triangles in one plane become one face, and vertices within an edge or a face are dropped.
[[nodiscard]] HullFaces merged_faces(std::span<const Vec3> points, std::span<const HullTriangle> triangles);

}  // namespace toccata
