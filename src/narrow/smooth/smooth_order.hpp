#pragma once

#include "toccata/narrow/convex_convex.hpp"
#include "toccata/narrow/posed_smooth.hpp"

namespace toccata {

/// A total order of posed smooth shapes, so that a pair is always seen in the same one.
[[nodiscard]] bool comes_before(const PosedSmooth& a, const PosedSmooth& b);

// The answer about (B, A) made of that about (A, B).
[[nodiscard]] Distance exchanged(const Distance& d);
[[nodiscard]] Relation exchanged(const Relation& r);
[[nodiscard]] Penetration exchanged(const Penetration& p);

}  // namespace toccata
