#pragma once

#include "toccata/narrow/posed_polytope.hpp"
#include "toccata/narrow/posed_shapes.hpp"

// The shapes of the formulas as the general search sees them.
namespace toccata {

[[nodiscard]] inline PosedPolytope convex_of(const PosedSphere& s) { return PosedPolytope(Sphere(s.radius, s.centre)); }
[[nodiscard]] inline PosedPolytope convex_of(const PosedCapsule& c) {
  return PosedPolytope(Capsule(c.start, c.end, c.radius));
}
[[nodiscard]] inline PosedPolytope convex_of(const PosedBox& b) { return PosedPolytope(b.shape, b.pose); }
[[nodiscard]] inline PosedPolytope convex_of(const Triangle& t) { return PosedPolytope(t); }
[[nodiscard]] inline PosedPolytope convex_of(const Segment& s) { return PosedPolytope(s); }

}  // namespace toccata
