#pragma once

#include <optional>

#include "toccata/narrow/quadrics.hpp"
#include "toccata/shapes/convex_hull.hpp"

namespace toccata {

/// A hull in the world of points of the surface, moved inwards until each is proved to lie within the shape; it lacks
/// about a hundredth of the radius between them. Nothing where that could not be proved, as of shapes so slim or so far
/// from the origin that no doubles are between.
[[nodiscard]] std::optional<ConvexHull> hull_within(const PosedQuadric& shape);

}  // namespace toccata
