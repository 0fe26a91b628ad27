#pragma once

#include "toccata/narrow/convex_convex.hpp"
#include "toccata/narrow/plane.hpp"
#include "toccata/narrow/posed_shapes.hpp"

// A sphere against anything is a question about the point nearest to its centre: the squared distance is compared with
// the squared radius. All answers are exact; touching counts, and so does a centre inside. Formulas in doubles answer
// nearly always, with a proof (src/narrow/primitives/nearness.hpp), in a few nanoseconds; else the general search does.
// After C. Ericson, "Real-Time Collision Detection", 2005, chapter 5. Triangles are in world coordinates.
namespace toccata {

[[nodiscard]] bool overlap(const PosedSphere& a, const PosedSphere& b);
[[nodiscard]] bool overlap(const PosedSphere& a, const Triangle& b);
[[nodiscard]] bool overlap(const PosedSphere& a, const PosedBox& b);
[[nodiscard]] bool overlap(const PosedSphere& a, const PosedCapsule& b);
[[nodiscard]] bool overlap(const PosedSphere& a, const Plane& b);

// The same of shapes and poses, of which only what is needed is computed: faster than to pose them for one question.
// Throw Error as the posed shapes do.
[[nodiscard]] bool overlap(const Sphere& a, const Pose& pose_a, const Sphere& b, const Pose& pose_b);
/// The triangle in its own frame.
[[nodiscard]] bool overlap(const Sphere& a, const Pose& pose_a, const Triangle& b, const Pose& pose_b);
[[nodiscard]] bool overlap(const Sphere& a, const Pose& pose_a, const Box& b, const Pose& pose_b);
[[nodiscard]] bool overlap(const Sphere& a, const Pose& pose_a, const Capsule& b, const Pose& pose_b);

/// The distance with the nearest points, as for any two convex shapes.
[[nodiscard]] Distance distance(const PosedSphere& a, const PosedSphere& b);
[[nodiscard]] Distance distance(const PosedSphere& a, const Triangle& b);
[[nodiscard]] Distance distance(const PosedSphere& a, const PosedBox& b);
[[nodiscard]] Distance distance(const PosedSphere& a, const PosedCapsule& b);

// The same bits, of shapes and poses, as for overlap.
[[nodiscard]] Distance distance(const Sphere& a, const Pose& pose_a, const Sphere& b, const Pose& pose_b);
/// The triangle in its own frame.
[[nodiscard]] Distance distance(const Sphere& a, const Pose& pose_a, const Triangle& b, const Pose& pose_b);
[[nodiscard]] Distance distance(const Sphere& a, const Pose& pose_a, const Box& b, const Pose& pose_b);
[[nodiscard]] Distance distance(const Sphere& a, const Pose& pose_a, const Capsule& b, const Pose& pose_b);

/// A plane against any bounded convex shape: has it vertices on both sides, or one nearer than its radius? Exact.
[[nodiscard]] bool overlap(const PosedPolytope& a, const Plane& b);

/// The nearest points of a shape and a plane, from whichever side; in exact arithmetic, so in microseconds. Where the
/// shape reaches the plane, a point of both.
[[nodiscard]] Distance distance(const PosedSphere& a, const Plane& b);
[[nodiscard]] Distance distance(const PosedPolytope& a, const Plane& b);

}  // namespace toccata

// A capsule is all that is near a segment: its questions are about nearest points of the segment. Exact as for spheres.
// Segments and triangles are in world coordinates.
namespace toccata {

[[nodiscard]] bool overlap(const PosedCapsule& a, const PosedCapsule& b);
[[nodiscard]] bool overlap(const PosedCapsule& a, const Segment& b);
[[nodiscard]] bool overlap(const PosedCapsule& a, const Triangle& b);
[[nodiscard]] bool overlap(const PosedCapsule& a, const PosedBox& b);

/// The same for two capsules and their poses; throws Error as making the posed capsules does.
[[nodiscard]] bool overlap(const Capsule& a, const Pose& pose_a, const Capsule& b, const Pose& pose_b);

[[nodiscard]] Distance distance(const PosedCapsule& a, const PosedCapsule& b);
[[nodiscard]] Distance distance(const Capsule& a, const Pose& pose_a, const Capsule& b, const Pose& pose_b);
[[nodiscard]] Distance distance(const PosedCapsule& a, const Segment& b);
[[nodiscard]] Distance distance(const PosedCapsule& a, const Triangle& b);
[[nodiscard]] Distance distance(const PosedCapsule& a, const PosedBox& b);

}  // namespace toccata

// Depths and contact points of two round shapes, as for any two convex shapes and with the same bits, from a formula
// that proves itself nearly always. With twice the digits where they overlap; where they are apart, a depth is 0, and
// its direction and points are those of the gap, rounded.
namespace toccata {

[[nodiscard]] Penetration penetration(const PosedSphere& a, const PosedSphere& b);
[[nodiscard]] Penetration penetration(const PosedSphere& a, const PosedCapsule& b);
[[nodiscard]] Penetration penetration(const PosedSphere& a, const PosedBox& b);
[[nodiscard]] Penetration penetration(const PosedCapsule& a, const PosedCapsule& b);
[[nodiscard]] Penetration penetration(const PosedCapsule& a, const PosedBox& b);

[[nodiscard]] Manifold manifold(const PosedSphere& a, const PosedSphere& b);
[[nodiscard]] Manifold manifold(const PosedSphere& a, const PosedCapsule& b);
[[nodiscard]] Manifold manifold(const PosedSphere& a, const PosedBox& b);
[[nodiscard]] Manifold manifold(const PosedCapsule& a, const PosedCapsule& b);
[[nodiscard]] Manifold manifold(const PosedCapsule& a, const PosedBox& b);

// The same of shapes and poses: faster than to pose them for one question. Throw Error as the posed shapes do.
[[nodiscard]] Penetration penetration(const Sphere& a, const Pose& pose_a, const Sphere& b, const Pose& pose_b);
[[nodiscard]] Penetration penetration(const Sphere& a, const Pose& pose_a, const Capsule& b, const Pose& pose_b);
[[nodiscard]] Penetration penetration(const Sphere& a, const Pose& pose_a, const Box& b, const Pose& pose_b);
[[nodiscard]] Penetration penetration(const Capsule& a, const Pose& pose_a, const Capsule& b, const Pose& pose_b);
[[nodiscard]] Penetration penetration(const Capsule& a, const Pose& pose_a, const Box& b, const Pose& pose_b);

[[nodiscard]] Manifold manifold(const Sphere& a, const Pose& pose_a, const Sphere& b, const Pose& pose_b);
[[nodiscard]] Manifold manifold(const Sphere& a, const Pose& pose_a, const Capsule& b, const Pose& pose_b);
[[nodiscard]] Manifold manifold(const Sphere& a, const Pose& pose_a, const Box& b, const Pose& pose_b);
[[nodiscard]] Manifold manifold(const Capsule& a, const Pose& pose_a, const Capsule& b, const Pose& pose_b);
[[nodiscard]] Manifold manifold(const Capsule& a, const Pose& pose_a, const Box& b, const Pose& pose_b);

/// The same for a capsule and a box that have not been posed yet.
[[nodiscard]] bool overlap(const Capsule& a, const Pose& pose_a, const Box& b, const Pose& pose_b);
[[nodiscard]] Distance distance(const Capsule& a, const Pose& pose_a, const Box& b, const Pose& pose_b);

}  // namespace toccata
