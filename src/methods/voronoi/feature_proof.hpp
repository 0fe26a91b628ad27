#pragma once

#include <array>
#include <optional>

#include "methods/voronoi/feature_walk.hpp"
#include "narrow/exact/feature_pair.hpp"

namespace toccata {

/// Up to three vertices of a feature, ascending, that have a point of it between them.
struct FeatureCorners {
  std::array<Index, 3> vertex{};
  std::size_t count = 0;
};

/// A feature of each of two shapes that moved, and the vertices that stand for it.
struct FeaturesAsked {
  std::array<ConvexFeature, 2> feature;
  std::array<FeatureCorners, 2> corners;
};

/// The corners of a feature that is no face of more than three corners.
[[nodiscard]] inline FeatureCorners corners_of(const VoronoiRegions::Parts& parts, const ConvexFeature& feature) {
  if (feature.kind == ConvexFeature::Kind::edge) {
    const auto& ends = parts.edge(feature.index).vertex;
    return {{ends[0], ends[1], 0}, 2};
  }
  if (feature.kind == ConvexFeature::Kind::face) return {parts.sides[feature.index].triangle, 3};
  return {{feature.index, 0, 0}, 1};
}

[[nodiscard]] inline NearestFeatures features_of(const FeaturesAsked& asked) {
  const auto& [of_a, of_b] = asked.corners;
  return {of_a.vertex, of_b.vertex, of_a.count, of_b.count};
}

/// The distance of two shapes, as `distance_by_gjk` tells it, if the features are proved to be the only nearest ones.
/// The bodies are those of the shapes.
[[nodiscard]] std::optional<Distance> proved_distance(const PosedPolytope& a, const WalkBody& body_a,
                                                      const PosedPolytope& b, const WalkBody& body_b,
                                                      const FeaturesAsked& asked);

}  // namespace toccata
