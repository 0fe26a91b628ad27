#pragma once

#include <span>
#include <vector>

#include "toccata/math/vec3.hpp"

// How deep two solids are in each other where they are deepest: the greatest sum of a point's distances from the two
// surfaces over the points of both (docs/methods/penetration.md#how-deep-is-a-place). Slowly, in doubles.
namespace toccata::oracle {

/// The exact number lies between these, up to some last places of the coordinates.
struct LocalDepth {
  double lower = 0;
  double upper = 0;
};

/// A half-space that a convex polyhedron has a facet on: its points p have normal · p ≤ offset. The normal has
/// length 1.
struct FacetPlane {
  Vec3 normal;
  double offset = 0;
};

/// Of two convex polyhedra that have inner points in common. Within one, the distance from its surface is the least
/// height below the plane of a facet. So the depth is the greatest s + t for which some point is s below all planes of
/// A and t below all of B. That is a linear program of five unknowns: every five of its inequalities are tried, and
/// give the greatest sum that is possible at a corner, and the least that they prove.
LocalDepth local_depth_of_convex(std::span<const FacetPlane> a, std::span<const FacetPlane> b);

/// A box along the axes; of a surface a rectangle, flat along one of them.
struct AxisBox {
  Vec3 lower;
  Vec3 upper;
};

/// A solid that consists of cells, and the rectangles of its surface.
struct CellSolid {
  std::vector<AxisBox> cells;
  std::vector<AxisBox> surface;
};

/// Of two such solids, 0 where no cells have inner points in common. What two cells have in common is cut in halves,
/// the one with the greatest bound first. The distance from one rectangle is convex, and the distance from a surface is
/// no more: so the sum for a rectangle of either is greatest at a corner, and bounds the depth within. Ends when the
/// upper bound is more than the lower one by no more than this share of it.
LocalDepth local_depth_of_cells(const CellSolid& a, const CellSolid& b, double precision);

}  // namespace toccata::oracle
