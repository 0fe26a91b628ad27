#pragma once

#include "toccata/reports/pages.hpp"

namespace toccata::io {

/// By what is finite of the box; by nothing of an empty one.
void widen(Aabb& around, const Aabb& box);

/// Around what is finite of all boxes; where nothing is, a point.
[[nodiscard]] Aabb bounds_of(const CrowdRecording& recording);

}  // namespace toccata::io
