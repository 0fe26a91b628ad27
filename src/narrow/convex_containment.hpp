#pragma once

#include "toccata/narrow/posed_convex.hpp"

namespace toccata {

/// The world vertices span space, or there is a radius; exactly.
[[nodiscard]] bool has_interior(const PosedConvex& shape);

/// Every point of A is a point of B; exactly. Both are solids with an interior.
[[nodiscard]] bool is_subset(const PosedConvex& a, const PosedConvex& b);

/// Every point of A lies in the interior of B; exactly. A has no radius, B has an interior.
[[nodiscard]] bool is_in_interior(const PosedConvex& a, const PosedConvex& b);

}  // namespace toccata
