#pragma once

#include <vector>

#include "query/decomposition/cut_plane.hpp"
#include "toccata/core/index.hpp"
#include "toccata/shapes/convex_hull.hpp"

namespace toccata {

/// A triangle or what planes have left of it. Convex.
struct ExactPolygon {
  Index triangle = 0;
  std::vector<RationalPoint> corners;
};

/// Its corners' signs beside a plane, summed up.
struct PolygonSides {
  bool front = false;
  bool back = false;
};

[[nodiscard]] PolygonSides sides_of(const ExactPolygon& polygon, const CutPlane& plane);

/// What of it lies in front of the plane (`sign` 1) or behind it (−1), the border included.
[[nodiscard]] ExactPolygon clipped(const ExactPolygon& polygon, const CutPlane& plane, int sign);

/// The least box of doubles around the point by its corners: the point itself where it is one.
void append_doubles_around(const RationalPoint& point, std::vector<Vec3>& points);

/// Within the hull or on it. Nothing is in a flat hull.
[[nodiscard]] bool contains(const ConvexHull& hull, const RationalPoint& point);

/// Within the triangle or on its border.
[[nodiscard]] bool contains(const std::array<Vec3, 3>& triangle, const RationalPoint& point);

}  // namespace toccata
