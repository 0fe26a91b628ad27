#pragma once

#include <span>

#include "narrow/quadrics/distance/quadric_search.hpp"
#include "narrow/quadrics/quadric_body.hpp"

namespace toccata {

/// GJK ends where the origin lies on a face of its simplex, so for doubles: a triangle or an edge through the origin
/// tells as little of shapes that touch as of symmetric ones that overlap. The triangle and the farthest points of
/// A − B on both sides of it, or the edge and those all around it, make a polytope of triangles; when the origin
/// certainly sees all of these from within, the bodies certainly have a common inner point.
[[nodiscard]] bool is_surrounded(const QuadricBody& a, const QuadricBody& b,
                                 std::span<const QuadricSearch::Corner> corners);

}  // namespace toccata
