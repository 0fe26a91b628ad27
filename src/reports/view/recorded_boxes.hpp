#pragma once

#include "toccata/reports/pages.hpp"

namespace toccata::io {

/// Widens `around` by what is finite of the box; an empty one changes nothing.
void widen(Aabb& around, const Aabb& box);

/// Around what is finite of all boxes; where nothing is, a point.
[[nodiscard]] Aabb bounds_of(const CrowdRecording& recording);

}  // namespace toccata::io
