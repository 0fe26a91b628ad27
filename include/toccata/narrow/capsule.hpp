#pragma once

#include "toccata/narrow/sphere.hpp"

// A capsule is all that is near a segment: its questions are about nearest points of the segment. Exact as for spheres.
// Segments and triangles are in world coordinates.
namespace toccata {

[[nodiscard]] bool overlap(const PosedCapsule& a, const PosedCapsule& b);
[[nodiscard]] bool overlap(const PosedCapsule& a, const Segment& b);
[[nodiscard]] bool overlap(const PosedCapsule& a, const Triangle& b);
[[nodiscard]] bool overlap(const PosedCapsule& a, const PosedBox& b);

/// Of two capsules and their poses; throws Error as the posed ones do.
[[nodiscard]] bool overlap(const Capsule& a, const Pose& pose_a, const Capsule& b, const Pose& pose_b);

[[nodiscard]] Distance distance(const PosedCapsule& a, const PosedCapsule& b);
[[nodiscard]] Distance distance(const Capsule& a, const Pose& pose_a, const Capsule& b, const Pose& pose_b);
[[nodiscard]] Distance distance(const PosedCapsule& a, const Segment& b);
[[nodiscard]] Distance distance(const PosedCapsule& a, const Triangle& b);
[[nodiscard]] Distance distance(const PosedCapsule& a, const PosedBox& b);

}  // namespace toccata
