#pragma once

#include "toccata/narrow/posed_convex.hpp"
#include "toccata/narrow/posed_shapes.hpp"

// The shapes of the formulas as the general search sees them.
namespace toccata {

[[nodiscard]] inline PosedConvex convex_of(const PosedSphere& s) { return PosedConvex(Sphere(s.radius, s.centre)); }
[[nodiscard]] inline PosedConvex convex_of(const PosedCapsule& c) {
  return PosedConvex(Capsule(c.start, c.end, c.radius));
}
[[nodiscard]] inline PosedConvex convex_of(const PosedBox& b) { return PosedConvex(b.shape, b.pose); }
[[nodiscard]] inline PosedConvex convex_of(const Triangle& t) { return PosedConvex(t); }
[[nodiscard]] inline PosedConvex convex_of(const Segment& s) { return PosedConvex(s); }

}  // namespace toccata
