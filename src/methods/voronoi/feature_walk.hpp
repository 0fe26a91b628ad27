#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "math/world_vertex.hpp"
#include "methods/voronoi/region_parts.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/methods/voronoi.hpp"

namespace toccata {

/// A polytope at its place, as the walk sees it.
struct WalkBody {
  const VoronoiRegions::Parts* parts;
  const Pose* pose;

  /// In the world.
  [[nodiscard]] Vec3 vertex(Index i) const { return point(parts->vertex(i)); }
  /// In the world, of the shape's own frame.
  [[nodiscard]] Vec3 point(const Vec3& own) const { return world_vertex(*pose, own); }
  /// A direction of the world, along which heights are the same in the shape's own frame but for the offset.
  [[nodiscard]] Vec3 own(const Vec3& direction) const {
    const Mat3& r = pose->linear;
    return direction.x * r[0] + direction.y * r[1] + direction.z * r[2];
  }
};

/// A feature of each shape and the nearest points of the two, inside both, as far as doubles tell.
struct FeaturesNear {
  std::array<ConvexFeature, 2> feature;
  std::array<Vec3, 2> on;  ///< in the world
  Vec3 between;            ///< on[0] − on[1]
  double squared = 0;      ///< between · between
};

struct FeatureWalk {
  FeaturesNear near;
  WalkEnd end = WalkEnd::nearest;
  std::uint64_t steps = 0;
};

/// Walks from a vertex, an edge or a face of each, not two faces nor a face and an edge, to the nearest features; after
/// B. Mirtich, "V-Clip: Fast and Robust Polyhedral Collision Detection", 1998. Every step leads through a plane that is
/// violated to a feature of one dimension more, and from there to whatever of its boundary is nearest; it counts only
/// when the distance has become less. So it ends, whatever rounding does. The way is recorded where it is asked for.
[[nodiscard]] FeatureWalk walk_features(const WalkBody& a, const WalkBody& b, const ConvexFeature& on_a,
                                        const ConvexFeature& on_b, VoronoiPath* path = nullptr);

}  // namespace toccata
