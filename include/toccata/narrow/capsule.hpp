#pragma once

#include "toccata/narrow/sphere.hpp"

// A capsule is all that is near a segment: its questions are about nearest points of the segment. Exact as for spheres.
// Segments and triangles are in world coordinates.
namespace toccata {

[[nodiscard]] bool overlap(const PosedCapsule& a, const PosedCapsule& b);
[[nodiscard]] bool overlap(const PosedCapsule& a, const Segment& b);
[[nodiscard]] bool overlap(const PosedCapsule& a, const Triangle& b);
[[nodiscard]] bool overlap(const PosedCapsule& a, const PosedBox& b);

[[nodiscard]] Distance distance(const PosedCapsule& a, const PosedCapsule& b);
[[nodiscard]] Distance distance(const PosedCapsule& a, const Segment& b);
[[nodiscard]] Distance distance(const PosedCapsule& a, const Triangle& b);
[[nodiscard]] Distance distance(const PosedCapsule& a, const PosedBox& b);

}  // namespace toccata
