#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "toccata/methods/voronoi.hpp"

namespace toccata {

/// The regions as the walk reads them. What is read of a feature that is looked at for the first time comes from far
/// away: it is one line of the cache. All lengths are in the shape's own frame.
struct VoronoiRegions::Parts {
  struct alignas(32) Vertex {
    Vec3 at;
    Index first_spoke = 0;
    Index end_of_spokes = 0;
  };
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
    float lean = 0;                 ///< four times the extent by the length, or a little more
    Index half_edge = 0;            ///< the lesser of its two, which names it
    std::array<Index, 2> vertex{};  ///< its ends, ascending
  };
  struct alignas(64) Side {
    Vec3 normal;  ///< outwards, unit
    /// No vertex that is not of the face lies less far below its plane; 0 where nothing is certain.
    double clearance = 0;
    double error = 0;                 ///< of each coordinate of the normal
    std::array<Index, 3> triangle{};  ///< of a face of three, its vertices, ascending
    Index corner_count = 0;
    Index first = 0;         ///< its first half-edge, which starts at its least vertex
    bool is_turned = false;  ///< of a face of three: the greatest vertex comes before the middle one
  };

  std::optional<ConvexHull> hull;  // keeps what the topology refers to
  const double* stored = nullptr;  // the hull's own coordinates, by which a shape made of it is known
  HullTopology topology;
  int dimension = 0;
  double extent = 0;  // the greatest magnitude of a coordinate
  Vec3 middle;        // of the vertices, but for rounding
  Index vertex_count = 0;
  std::array<Index, 3> numbers{};  // of vertices, half-edges, faces: those of features are below
  std::vector<Vertex> vertices;
  std::vector<Spoke> spokes;
  std::vector<Index> edge_number;  // of each half-edge, where its edge is
  std::vector<Edge> edges;
  /// For each edge, the face in which it leads to its greater end, and the other.
  std::vector<std::array<Index, 2>> faces_at;
  std::vector<RegionPlane> rims;  // of each half-edge: the edge–face plane
  std::vector<Side> sides;

  [[nodiscard]] const Vec3& vertex(Index i) const { return vertices[i].at; }
  [[nodiscard]] std::span<const Spoke> spokes_at(Index vertex) const {
    const Vertex& v = vertices[vertex];
    return std::span(spokes).subspan(v.first_spoke, v.end_of_spokes - v.first_spoke);
  }
  /// The way from the start of a half-edge to its end.
  [[nodiscard]] Vec3 way(Index half_edge) const {
    return vertex(topology.target(half_edge)) - vertex(topology.origin[half_edge]);
  }
  [[nodiscard]] const Edge& edge(Index half_edge) const { return edges[edge_number[half_edge]]; }
  [[nodiscard]] bool has_faces() const { return dimension >= 2; }
  /// An end, where there are any: not a corner of a triangle that lies between the others.
  [[nodiscard]] Index any_vertex() const { return topology.origin.empty() ? 0 : topology.origin[0]; }
  [[nodiscard]] Index edge_of(Index half_edge) const { return edge(half_edge).half_edge; }
};

using RegionParts = VoronoiRegions::Parts;

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
