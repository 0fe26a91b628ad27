#pragma once

#include <optional>

#include "narrow/near.hpp"
#include "query/posed_shape.hpp"
#include "query/search_scratch.hpp"

// What models that are the union of parts ask of two of these, for callers who keep the parts at their places.
namespace toccata {

/// Have they a point in common? Throws Error for what the table of pairs does not define.
[[nodiscard]] bool parts_overlap(const PosedPart& a, const PosedPart& b, SearchScratch& scratch);

/// How near they are; elements and faces are counted from where those of the parts begin.
[[nodiscard]] std::optional<Nearby> nearby(const PosedPart& a, const PosedPart& b, const WantedDistance& wanted,
                                           SearchScratch& scratch);

}  // namespace toccata
