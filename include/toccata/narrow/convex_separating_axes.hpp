#pragma once

#include "toccata/narrow/convex_convex.hpp"

namespace toccata {

/// Do they have a point in common? By separating axes of polyhedra: the normals of the faces of both, and the cross
/// products of those pairs of edges whose arcs cross on the Gauss map (D. Gregorius, "The Separating Axis Test between
/// Convex Polyhedra", 2013; of two boxes the fifteen axes of S. Gottschalk, M. C. Lin, D. Manocha, "OBBTree", 1996).
/// Exact: where the rounded axes leave a doubt, and about radii, `overlap` decides. The axis kept in the workspace is
/// tried first. The cost grows with the product of the numbers of edges.
[[nodiscard]] bool overlap_by_separating_axes(const PosedPolytope& a, const PosedPolytope& b,
                                              SimplexCache* workspace = nullptr);

/// Penetration as the least overlap along one of these axes, without iteration. [lower, upper] is as narrow as that of
/// `penetration_by_expansion`, which takes over where rounding makes the axes' bracket wider. Throws Error when one of
/// the shapes is a surface.
[[nodiscard]] Penetration penetration_by_separating_axes(const PosedPolytope& a, const PosedPolytope& b);

}  // namespace toccata
