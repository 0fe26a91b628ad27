#pragma once

#include <optional>

#include "narrow/exact/vertex_pairs.hpp"
#include "toccata/core/status.hpp"
#include "toccata/narrow/posed_polytope.hpp"

namespace toccata {

/// The shortest translation after which the interiors of two cores do not meet, seen as the hulls of their vertices.
struct CoreSeparation {
  enum class Kind {
    flat,   ///< the cores lie in parallel planes, lines or points: the difference has no interior
    apart,  ///< the interiors do not meet: nothing to part; the cores may touch
    deep,
  } kind = Kind::apart;
  /// Deep: the length lies in [lower, upper].
  double lower = 0;
  double upper = 0;
  Vec3 direction{};  ///< unit, from A to B; apart: along it the cores do not overlap, as far as rounding can tell
  Vec3 on_a{};       ///< deep or touching: the deepest points, on_a − on_b along the direction
  Vec3 on_b{};
  VertexPairs pairs;  ///< whose hulls hold the points
  Status status = Status::exact;
};

/// How narrow a bracket is, relative to the depth: the width of [lower, upper] is at most this times
/// (upper + the sum of the radii).
inline constexpr double relative_width_of_depth = 0x1p-40;

/// Parts the cores by expanding a polytope within the Minkowski difference (G. van den Bergen, "Proximity queries and
/// penetration depth computation on 3D game objects", 2001): quickly, or else exactly. `reach`: the sum of the radii by
/// which the shapes are grown; `width`: the bracket's, relative, at most.
[[nodiscard]] CoreSeparation part_cores_by_expansion(const PosedPolytope& a, const PosedPolytope& b, double reach,
                                                     double width = relative_width_of_depth);

/// In doubles; nothing when rounding leaves a doubt.
[[nodiscard]] std::optional<CoreSeparation> part_cores_fast(const PosedPolytope& a, const PosedPolytope& b,
                                                            double reach, double width = relative_width_of_depth);

/// Parts the cores with exact signs and from any start: the origin may be outside.
[[nodiscard]] CoreSeparation part_cores_exactly(const PosedPolytope& a, const PosedPolytope& b, double reach);

}  // namespace toccata
