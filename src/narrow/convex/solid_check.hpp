#pragma once

#include "toccata/narrow/convex_convex.hpp"

namespace toccata {

/// Throws Error when one is a surface: penetration is not defined.
void require_solids(const PosedPolytope& a, const PosedPolytope& b);

/// The answer where one of them is flattened: solids that touch at most have no depth.
[[nodiscard]] Penetration without_depth(const PosedPolytope& a, const PosedPolytope& b);

}  // namespace toccata
