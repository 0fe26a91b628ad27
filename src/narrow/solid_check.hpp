#pragma once

#include "toccata/narrow/posed_convex.hpp"

namespace toccata {

/// Throws Error when one is a surface: penetration is not defined.
void require_solids(const PosedConvex& a, const PosedConvex& b);

}  // namespace toccata
