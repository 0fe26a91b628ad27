#pragma once

#include <array>
#include <vector>

#include "oracle/rational.hpp"

namespace toccata::oracle {

/// Four of the points that span space, or fewer that span as much as there is.
std::vector<RationalPoint> spanning(const std::vector<RationalPoint>& points);

/// A triangle of the boundary of a body, counter-clockwise seen from outside, and the half-space behind it.
struct BoundaryTriangle {
  std::array<RationalPoint, 3> corner;
  HalfSpace behind;
};

/// Triangles that bound the hull of points, of which `four` span space. A facet with more corners is several of them.
std::vector<BoundaryTriangle> boundary(const std::vector<RationalPoint>& points, std::vector<RationalPoint> four);

/// Directions in which the hull of some points has edges, and the normals of its facets, each once; of a flat hull
/// perhaps more than those.
struct Directions {
  std::vector<RationalPoint> edges;
  std::vector<RationalPoint> normals;
};

Directions directions_of(const std::vector<RationalPoint>& points);

}  // namespace toccata::oracle
