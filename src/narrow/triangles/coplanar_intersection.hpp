#pragma once

#include "toccata/narrow/triangle_triangle.hpp"

namespace toccata {

/// The meeting of two triangles with area in one plane.
[[nodiscard]] Intersection coplanar_intersection(const Triangle& a, const Triangle& b);

/// Whether it is not empty.
[[nodiscard]] bool coplanar_overlap(const Triangle& a, const Triangle& b);

}  // namespace toccata
