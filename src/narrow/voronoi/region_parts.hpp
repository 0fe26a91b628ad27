#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "toccata/narrow/voronoi_regions.hpp"

namespace toccata {

/// The planes as the walk reads them. All lengths are in the shape's own frame.
struct VoronoiRegions::Parts {
  /// An edge as its vertex sees it: the way along it, which is the normal of the vertex–edge plane.
  struct Spoke {
    Vec3 along;
    double per_length = 0;  ///< 1 by its length
    Index half_edge = 0;
  };
  /// A half-edge as its face sees it: the edge–face plane; and what shows quickly that no other vertex is low.
  struct Rim {
    RegionPlane plane;
    /// From its start towards the vertex of the face after its end, so much of the way that, with heights measured from
    /// the plane of the other face at the edge, no vertex is lower that is not in that plane; 0 where nothing is
    /// certain.
    Vec3 into{};
    double per_length = 0;  ///< 1 by the length of the edge
  };
  struct Side {
    RegionPlane plane;
    /// No vertex that is not of the face lies less far below its plane; 0 where nothing is certain.
    double clearance = 0;
    double error = 0;                 ///< of each coordinate of the normal
    std::array<Index, 3> triangle{};  ///< of a face of three, its vertices, ascending
    Index corner_count = 0;
  };

  std::optional<ConvexHull> hull;  // keeps what the topology refers to
  const double* stored = nullptr;  // the hull's own coordinates, by which a shape made of it is known
  HullTopology topology;
  int dimension = 0;
  double extent = 0;  // the greatest magnitude of a coordinate
  std::vector<Vec3> vertices;
  std::vector<Index> first_spoke;  // of each vertex, and one more
  std::vector<Spoke> spokes;
  std::vector<Index> spoke_of;  // each half-edge
  std::vector<Rim> rims;
  std::vector<Side> sides;

  [[nodiscard]] std::span<const Spoke> spokes_at(Index vertex) const {
    return std::span(spokes).subspan(first_spoke[vertex], first_spoke[vertex + 1] - first_spoke[vertex]);
  }
  [[nodiscard]] bool has_faces() const { return dimension >= 2; }
  /// An end, where there are any: not a corner of a triangle that lies between the others.
  [[nodiscard]] Index any_vertex() const { return topology.origin.empty() ? 0 : topology.origin[0]; }
  [[nodiscard]] Index edge_of(Index half_edge) const {
    return half_edge < topology.twin[half_edge] ? half_edge : topology.twin[half_edge];
  }
};

/// The vertices of a face, in its order.
[[nodiscard]] inline std::span<const Index> corners_of_face(const HullTopology& t, Index face) {
  return t.origin.subspan(t.face_start[face], t.face_start[face + 1] - t.face_start[face]);
}

/// It is a face of more than three.
[[nodiscard]] inline bool has_more_corners(const VoronoiRegions::Parts& parts, const ConvexFeature& feature) {
  return feature.kind == ConvexFeature::Kind::face && parts.sides[feature.index].corner_count > 3;
}

}  // namespace toccata
