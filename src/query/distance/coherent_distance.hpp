#pragma once

#include <optional>

#include "query/distance/mesh_distance.hpp"
#include "query/posed_shape.hpp"
#include "query/search_scratch.hpp"
#include "toccata/query/distance_cache.hpp"
#include "trees/near_front.hpp"

namespace toccata {

/// What a DistanceCache holds.
struct CoherentState {
  std::optional<Model> a;
  std::optional<Model> b;
  Workspace workspace;
  DistanceCacheCounts counts;

  Pose pose_a;  ///< of the last question
  Pose pose_b;
  bool solid_a = false;
  bool solid_b = false;

  Vec3 quadric_direction;  ///< of two convex shapes of which one is a quadric; zero: nothing is kept

  NearFront front;
  bool moved_little = true;  ///< at the last step: a front is worth its while
  SimplexCache nearest_pair;

  /// The surfaces are at least so far apart, and what lies within what is known; 0: nothing is known.
  double clearance = 0;
  std::optional<PartInside> inner;

  // A front that is soon worn out is not worth making: so many questions are answered without, twice as many each time.
  std::size_t age = 0;   ///< questions that this front has answered
  std::size_t rest = 0;  ///< questions until the next one is made
  std::size_t next_rest = 0;
};

/// The distance of two shapes of which one is a quadric and the other convex; nothing of others.
[[nodiscard]] std::optional<Distance> coherent_quadric_distance(const PosedShape& a, const PosedShape& b,
                                                                Vec3& direction);

/// The distance of two meshes (mesh_distance.hpp), to the last bit.
[[nodiscard]] Distance coherent_distance(const PosedTriangles& a, const PosedTriangles& b, CoherentState& state);

}  // namespace toccata
