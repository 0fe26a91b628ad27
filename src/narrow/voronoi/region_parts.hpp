#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "toccata/narrow/voronoi_regions.hpp"

namespace toccata {

/// The regions as the walk reads them. What is read of a feature that is looked at for the first time comes from far
/// away: it is one line of the cache, besides coordinates, which are those of the hull itself. All lengths are in the
/// shape's own frame.
struct VoronoiRegions::Parts {
  /// An edge as its vertex sees it.
  struct Spoke {
    Index vertex = 0;  ///< its other end
    Index half_edge = 0;
  };
  /// An edge, with what shows quickly that no other vertex is low.
  struct alignas(64) Edge {
    /// In either face, from the start of its half-edge there towards the vertex of the face after its end, so much of
    /// the way that, with heights measured from the plane of the other face, no vertex is lower that is not in that
    /// plane; 0 where nothing is certain.
    std::array<Vec3, 2> into{};
    double lean = 0;                ///< four times the extent by the length
    std::array<Index, 2> vertex{};  ///< its ends, ascending
  };
  struct alignas(64) Side {
    Vec3 normal;  ///< outwards, unit
    /// No vertex that is not of the face lies less far below its plane; 0 where nothing is certain.
    double clearance = 0;
    double error = 0;                 ///< of each coordinate of the normal
    std::array<Index, 3> triangle{};  ///< of a face of three, its vertices, ascending
    Index corner_count = 0;
  };

  std::optional<ConvexHull> hull;  // keeps what the topology and the coordinates refer to
  std::vector<double> own;         // the coordinates of what is no hull
  HullTopology topology;
  int dimension = 0;
  double extent = 0;  // the greatest magnitude of a coordinate
  Vec3 middle;        // of the vertices, but for rounding
  Index vertex_count = 0;
  std::array<Index, 3> numbers{};        // of vertices, half-edges, faces: those of features are below
  std::array<const double*, 3> along{};  // coordinates of vertices along each axis
  std::vector<Index> first_spoke;        // of each vertex, and one more
  std::vector<Spoke> spokes;
  std::vector<Index> edge_number;  // of each half-edge, where its edge is
  std::vector<Edge> edges;
  std::vector<RegionPlane> rims;  // of each half-edge: the edge–face plane
  std::vector<Side> sides;

  [[nodiscard]] Vec3 vertex(Index i) const { return {along[0][i], along[1][i], along[2][i]}; }
  [[nodiscard]] std::span<const Spoke> spokes_at(Index vertex) const {
    return std::span(spokes).subspan(first_spoke[vertex], first_spoke[vertex + 1] - first_spoke[vertex]);
  }
  /// From the start of a half-edge to its end.
  [[nodiscard]] Vec3 way(Index half_edge) const {
    return vertex(topology.target(half_edge)) - vertex(topology.origin[half_edge]);
  }
  [[nodiscard]] const Edge& edge(Index half_edge) const { return edges[edge_number[half_edge]]; }
  [[nodiscard]] bool has_faces() const { return dimension >= 2; }
  /// An end, where there are any: not a corner of a triangle that lies between the others.
  [[nodiscard]] Index any_vertex() const { return topology.origin.empty() ? 0 : topology.origin[0]; }
  [[nodiscard]] Index edge_of(Index half_edge) const { return std::min(half_edge, topology.twin[half_edge]); }
};

/// The vertices of a face, in its order.
[[nodiscard]] inline std::span<const Index> corners_of_face(const HullTopology& t, Index face) {
  return t.origin.subspan(t.face_start[face], t.face_start[face + 1] - t.face_start[face]);
}

/// There is such a feature, which may be anything.
[[nodiscard]] inline bool has_feature(const VoronoiRegions::Parts& parts, const ConvexFeature& feature) {
  const auto kind = static_cast<std::size_t>(feature.kind);
  return kind < parts.numbers.size() && feature.index < parts.numbers[kind];
}

/// It is a face of more than three.
[[nodiscard]] inline bool has_more_corners(const VoronoiRegions::Parts& parts, const ConvexFeature& feature) {
  return feature.kind == ConvexFeature::Kind::face && parts.sides[feature.index].corner_count > 3;
}

}  // namespace toccata
