#pragma once

#include "toccata/narrow/quadrics.hpp"

// How cylinders, cones and ellipsoids lie to other convex shapes, and how far they overlap.
namespace toccata {

// Apart and overlapping (crossing: a surface) are proved, and containment. Touching is exact where a point of doubles
// in both and a plane between them prove it, as along the axes, and against half-spaces; else it has the status
// undecided, and stands for what QuadricContact calls so, or for a contact without such a plane. Of two that overlap,
// undecided says: within 10⁻¹² of the size of one holding the other; not_converged: a search ended, near a capsule or a
// rounded shape. Containment is none then.
[[nodiscard]] Relation relation(const PosedQuadric& a, const PosedQuadric& b);
[[nodiscard]] Relation relation(const PosedQuadric& a, const PosedPolytope& b);
[[nodiscard]] Relation relation(const PosedPolytope& a, const PosedQuadric& b);
[[nodiscard]] Relation relation(const PosedQuadric& a, const PosedHalfSpace& b);
[[nodiscard]] Relation relation(const PosedHalfSpace& a, const PosedQuadric& b);

// The exact depth lies in [lower, upper]: both ends are proved, upper by the plane that is left between the shapes when
// B has moved by upper · direction, lower by a polytope, round at its corners, within the Minkowski difference. The
// status is exact where upper − lower is at most 10⁻¹² · upper, as it mostly is, else not_converged: where the depth is
// less than 10⁻⁴ of the size, rounding of the direction alone may be more; and where the shapes are as deep in ever so
// many directions (balls around one centre, bars along one axis), lower is at least 0.9 · upper. A depth below 10⁻¹² of
// the size may have the lower end 0. Both are 0 when the shapes are apart; when touching is exact, with the normal of
// the plane between them for direction; and, with the status undecided, within the bound of touching. Throws Error when
// one is a surface.
[[nodiscard]] Penetration penetration(const PosedQuadric& a, const PosedQuadric& b);
[[nodiscard]] Penetration penetration(const PosedQuadric& a, const PosedPolytope& b);
[[nodiscard]] Penetration penetration(const PosedPolytope& a, const PosedQuadric& b);
/// As narrow as a distance.
[[nodiscard]] Penetration penetration(const PosedQuadric& a, const PosedHalfSpace& b);
[[nodiscard]] Penetration penetration(const PosedHalfSpace& a, const PosedQuadric& b);

}  // namespace toccata
