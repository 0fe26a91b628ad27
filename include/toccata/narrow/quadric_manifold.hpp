#pragma once

#include "toccata/narrow/quadrics.hpp"

// Where cylinders, cones and ellipsoids touch or overlap other convex shapes.
namespace toccata {

// Empty exactly when the shapes are apart (`quadric_contact`). The normal is the direction of the penetration, told of
// surfaces too, or of touching. Along it each shape has a face, a line or a point: a face where one turns to the normal
// within two degrees (a cap, a polygon), a line where one lies across it as closely (an edge, a line of a round side),
// else the farthest point. The points are up to four of what the two have in common when seen along the normal, a gap
// of 2⁻¹⁰ of its extent included: the deepest first, then such that they span it. A face and a face have up to four (a
// standing cylinder: four points of its rim), a line with a line along it or with a face two (a lying cylinder),
// everything else one.
//
// Each position is half way between a point of A and one of B that are |depth| apart along the normal; both are off
// from their shapes by at most 10⁻¹¹ of the size of the pair (of the quadric, and how far the other reaches from
// its middle), and mostly by 10⁻¹⁵. No point is deeper than the shapes are along the normal, and the first is as deep
// as that, but for 2⁻²⁰ of it.
//
// The features of a quadric, for `ConvexFeature`:
//   cylinder   face 0 the cap at −z, 1 that at +z, 2 the side; edges 0 to 3 the quarters of the rim at −z, from the
//              local +x on to +y, 4 to 7 those of the rim at +z
//   cone       face 0 the cap, 1 the side; edges 0 to 3 the quarters of the rim; vertex 0 the tip
//   ellipsoid  face 0
//
// Exchanging the shapes turns the normal round, exchanges the features and changes no other bit. Of two equal shapes at
// one place both orders are the same question, and have the same answer.
[[nodiscard]] Manifold manifold(const PosedQuadric& a, const PosedQuadric& b);
[[nodiscard]] Manifold manifold(const PosedQuadric& a, const PosedPolytope& b);
[[nodiscard]] Manifold manifold(const PosedPolytope& a, const PosedQuadric& b);
[[nodiscard]] Manifold manifold(const PosedQuadric& a, const PosedHalfSpace& b);
[[nodiscard]] Manifold manifold(const PosedHalfSpace& a, const PosedQuadric& b);

}  // namespace toccata
