#pragma once

#include <optional>

#include "toccata/narrow/convex_convex.hpp"
#include "toccata/narrow/posed_polytope.hpp"

namespace toccata {

/// Which of two shapes contains which; exactly. The queries count whether exact arithmetic was needed.
struct ContainmentAnswer {
  Containment containment = Containment::none;
  bool by_exact = false;
};

/// Whether one of two solids with an interior contains the other: every point of one is a point of the other.
[[nodiscard]] ContainmentAnswer containment_of_solids(const PosedPolytope& a, const PosedPolytope& b);

/// Every point of the surface A lies in the interior of the solid B: a_in_b, or none.
[[nodiscard]] ContainmentAnswer containment_in_interior(const PosedPolytope& a, const PosedPolytope& b);

/// The world vertices span space, or there is a radius; exactly.
[[nodiscard]] bool has_interior(const PosedPolytope& shape);

/// A solid that rounding has left without an interior at its place: others can touch it only.
[[nodiscard]] inline bool is_flattened(const PosedPolytope& shape) { return shape.solid() && !has_interior(shape); }

}  // namespace toccata
