#pragma once

#include <memory_resource>
#include <vector>

#include "toccata/narrow/convex_convex.hpp"

// The faces of cores between which contacts lie.
namespace toccata {

/// What a core turns towards a direction: a face as a polygon, a segment or a point.
struct ContactFace {
  static constexpr Index none = ~Index{0};
  const PosedPolytope* shape = nullptr;
  Index face = none;   ///< none: the core is a point
  Index vertex = 0;    ///< the core's vertex that is farthest along the direction
  Vec3 normal{};       ///< outwards, unit; zero when it has no area
  double facing = -1;  ///< the cosine between normal and direction; −1 when there is no area
  double area = 0;     ///< twice the face's

  [[nodiscard]] Index first() const { return shape->topology().face_start[face]; }
  [[nodiscard]] Index last() const { return shape->topology().face_start[face + 1]; }
};

/// The face around the vertex farthest along the direction that turns most towards it.
[[nodiscard]] ContactFace facing_face(const PosedPolytope& shape, const Vec3& direction);

/// −1 when the pose mirrors, which turns every face round; else 1. The matrix may be of any size.
[[nodiscard]] double turn_of_faces(const Mat3& linear);

/// The half-edge that stands for an edge, whichever of its two faces it was reached from.
[[nodiscard]] inline Index edge_number(const HullTopology& topology, Index half_edge) {
  return half_edge < topology.twin[half_edge] ? half_edge : topology.twin[half_edge];
}

/// The least feature that has all these vertices, repeated ones among them: a vertex, an edge or a face.
[[nodiscard]] ConvexFeature feature_of(const PosedPolytope& shape, const std::array<Index, 4>& vertices,
                                       std::size_t count);

}  // namespace toccata
