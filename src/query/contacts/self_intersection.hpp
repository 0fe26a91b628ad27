#pragma once

#include "toccata/narrow/triangle_triangle.hpp"

namespace toccata {

/// What two world triangles of one mesh have in common when that is more than the hull of the vertices that they share
/// (equal coordinates), or when their vertices are the same; none otherwise.
[[nodiscard]] Intersection self_intersection(const Triangle& a, const Triangle& b);

/// Whether it is not none.
[[nodiscard]] bool self_meet(const Triangle& a, const Triangle& b);

}  // namespace toccata
