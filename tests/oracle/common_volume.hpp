#pragma once

#include <vector>

#include "oracle/rational.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata::oracle {

/// A bounded convex polyhedron by its faces, each a polygon that turns counter-clockwise seen from outside.
using ConvexFaces = std::vector<std::vector<RationalPoint>>;

/// The tetrahedron with corners in any order.
ConvexFaces tetrahedron_faces(const RationalPoint& p, const RationalPoint& q, const RationalPoint& r,
                              const RationalPoint& s);

/// Six times the volume of what two tetrahedra have in common; corners as above.
Rational six_common_volumes(const std::vector<RationalPoint>& a, const std::vector<RationalPoint>& b);

/// The volume of what two closed meshes have in common, whose winding numbers are 0 and 1: each is the sum of the
/// signed tetrahedra over its triangles from a vertex.
Rational common_volume(const std::vector<Triangle>& a, const std::vector<Triangle>& b);

}  // namespace toccata::oracle
