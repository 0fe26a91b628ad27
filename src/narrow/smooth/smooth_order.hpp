#pragma once

#include "toccata/narrow/flipped.hpp"
#include "toccata/narrow/posed_smooth.hpp"

namespace toccata {

/// A total order of posed smooth shapes, so that a pair is always seen in the same one.
[[nodiscard]] bool comes_before(const PosedSmooth& a, const PosedSmooth& b);

}  // namespace toccata
