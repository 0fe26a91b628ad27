#pragma once

#include "toccata/narrow/convex_convex.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {

/// A total order of posed quadrics, so that a pair is always seen in the same one.
[[nodiscard]] bool comes_before(const PosedQuadric& a, const PosedQuadric& b);

}  // namespace toccata
