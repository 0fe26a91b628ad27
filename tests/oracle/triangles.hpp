#pragma once

#include <array>
#include <vector>

#include "oracle/rational.hpp"
#include "toccata/shapes/primitives.hpp"

namespace toccata::oracle {

/// The convex hull of three exact points.
struct RationalTriangle {
  std::array<RationalPoint, 3> vertex;
};

RationalTriangle exact(const Triangle& triangle);

/// (v1 − v0) × (v2 − v0); zero for a triangle without area.
RationalPoint normal(const RationalTriangle& triangle);

/// The vertices without those that lie between the others: 3 of a triangle, 2 of a segment, 1 of a point.
std::vector<RationalPoint> extreme_points(const RationalTriangle& triangle);

/// 2, or 1 or 0 for a triangle that is a segment or a point.
int dimension(const RationalTriangle& triangle);

/// A triangle as what bounds it: the planes that contain it (one, or two of a segment, three of a point) and the
/// half-spaces whose common part with them it is.
struct Bounding {
  std::vector<HalfSpace> containing;
  std::vector<HalfSpace> sides;
};

Bounding bounding(const RationalTriangle& triangle);

/// The closed axis-aligned boxes around the triangles have a point in common; without one the triangles have none.
bool boxes_overlap(const RationalTriangle& a, const RationalTriangle& b);

bool contains(const RationalTriangle& triangle, const RationalPoint& p);
bool contains_in_relative_interior(const RationalTriangle& triangle, const RationalPoint& p);

/// The vertex (dimension 0), open edge (1, from vertex `index` to the next) or open face (2) of the triangle on which
/// one of its points lies. Among equal vertices the least index counts, and an edge joins such vertices. A point of a
/// triangle that is a segment lies on an end of it or on the edge between the ends, even where the middle vertex is.
struct TriangleFeature {
  int dimension = 2;
  int index = 0;
  friend bool operator==(const TriangleFeature&, const TriangleFeature&) = default;
};

TriangleFeature feature_at(const RationalTriangle& triangle, const RationalPoint& point_of_it);

enum class CommonSetKind { none, point, segment, polygon };

/// What two closed triangles have in common.
struct CommonSet {
  CommonSetKind kind = CommonSetKind::none;
  std::vector<RationalPoint> extreme_points;  ///< of a polygon in cyclic order
  bool coplanar = false;                      ///< all six vertices lie in one plane
  bool crossing = false;                      ///< the relative interiors meet and the six vertices are not coplanar
};

/// Oracle of `intersect` and, by its kind, of `overlap` for triangles. Clips a by the half-spaces that bound b.
CommonSet common_set(const RationalTriangle& a, const RationalTriangle& b);

/// Oracle of `overlap` for triangles: the kind of their common set is not none.
bool overlap(const RationalTriangle& a, const RationalTriangle& b);

}  // namespace toccata::oracle
