#pragma once

#include "toccata/narrow/convex_convex.hpp"

// The ways to the penetration of two convex shapes, each for itself. `penetration` chooses among them; they agree in
// what they promise, and each is a test of the others. All throw Error when one of the shapes is a surface.
namespace toccata {

/// By expanding a polytope within the Minkowski difference of the cores (G. van den Bergen, "Proximity queries and
/// penetration depth computation on 3D game objects", 2001), with exact signs: for shapes of any size. The width of
/// [lower, upper] is at most 2^-40 · upper.
[[nodiscard]] Penetration penetration_by_expansion(const PosedPolytope& a, const PosedPolytope& b);

}  // namespace toccata
