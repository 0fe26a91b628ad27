#pragma once

#include <optional>
#include <span>
#include <vector>

#include "toccata/narrow/voronoi_regions.hpp"

namespace toccata {

/// The planes as the walk reads them. All lengths are in the shape's own frame.
struct VoronoiRegions::Parts {
  /// An edge as its vertex sees it: the vertex–edge plane.
  struct Spoke {
    RegionPlane plane;
    double length = 0;
    Index half_edge = 0;
  };
  /// A half-edge as its face sees it: the edge–face plane; and what shows quickly that no other vertex is low.
  struct Rim {
    RegionPlane plane;
    /// From its start to the vertex of the face after its end.
    Vec3 into{};
    /// With heights measured from the plane of the other face at the edge: that of the lowest vertex not in that plane
    /// is at least so much of the height of the vertex which `into` leads to; 0 where nothing is certain.
    double least_share = 0;
  };
  struct Side {
    RegionPlane plane;
    /// No vertex that is not of the face lies less far below its plane; 0 where nothing is certain.
    double clearance = 0;
    double error = 0;  ///< of each coordinate of the normal
  };

  std::optional<ConvexHull> hull;  // keeps what the topology refers to
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

/// It is a face of more than three.
[[nodiscard]] inline bool has_more_corners(const VoronoiRegions::Parts& parts, const ConvexFeature& feature) {
  const HullTopology& t = parts.topology;
  return feature.kind == ConvexFeature::Kind::face && t.face_start[feature.index + 1] - t.face_start[feature.index] > 3;
}

}  // namespace toccata
