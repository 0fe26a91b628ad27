#pragma once

#include <limits>

#include "toccata/narrow/convex_convex.hpp"
#include "toccata/narrow/posed_shapes.hpp"

// Depths, contact points and small distances of pairs of simple cores, each grown by a radius, from the cores' nearest
// features. Where these do not prove themselves nothing is told, and the general way answers. How they do:
// docs/design/primitive-depths.md. The same bits at every SIMD level.
namespace toccata {

[[nodiscard]] inline bool is_known(const Penetration& depth) { return depth.upper >= 0; }
[[nodiscard]] inline bool is_known(const Manifold& manifold) { return manifold.count >= 0; }

[[nodiscard]] inline Penetration unknown_depth() { return {.upper = std::numeric_limits<double>::quiet_NaN()}; }
[[nodiscard]] inline Manifold unknown_manifold() { return {.count = -1}; }

[[nodiscard]] Penetration formula_depth(const PosedSphere& a, const PosedSphere& b);
[[nodiscard]] Penetration formula_depth(const PosedSphere& a, const PosedCapsule& b);
[[nodiscard]] Penetration formula_depth(const PosedCapsule& a, const PosedCapsule& b);

/// The same for a box, grown or not.
[[nodiscard]] Penetration formula_depth(const PosedSphere& a, const PosedPolytope& box);
[[nodiscard]] Penetration formula_depth(const PosedCapsule& a, const PosedPolytope& box);

[[nodiscard]] Manifold formula_manifold(const PosedSphere& a, const PosedSphere& b);
[[nodiscard]] Manifold formula_manifold(const PosedSphere& a, const PosedCapsule& b);
[[nodiscard]] Manifold formula_manifold(const PosedCapsule& a, const PosedCapsule& b);
[[nodiscard]] Manifold formula_manifold(const PosedSphere& a, const PosedPolytope& box);
[[nodiscard]] Manifold formula_manifold(const PosedCapsule& a, const PosedPolytope& box);

/// The distance of a box and what is apart from it, however little.
[[nodiscard]] Distance close_formula_distance(const PosedSphere& a, const PosedPolytope& box);
[[nodiscard]] Distance close_formula_distance(const PosedCapsule& a, const PosedPolytope& box);
[[nodiscard]] Distance close_formula_distance(const PosedSphere& a, const PosedBox& b);
[[nodiscard]] Distance close_formula_distance(const Sphere& a, const Pose& pose_a, const Box& b, const Pose& pose_b);

/// For two shapes, if there is a formula for the pair and it proves itself.
[[nodiscard]] Penetration depth_of_primitives(const PosedPolytope& a, const PosedPolytope& b);
[[nodiscard]] Manifold manifold_of_primitives(const PosedPolytope& a, const PosedPolytope& b);

}  // namespace toccata
