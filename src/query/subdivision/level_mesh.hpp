#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/no_index.hpp"
#include "toccata/query/subdivision.hpp"

namespace toccata {

/// An edge of a level, and the one or two sides of faces that lie along it.
struct LevelEdge {
  std::array<Index, 2> ends{};
  std::array<Index, 2> sides{no_index, no_index};
  double sharpness = 0;
};

/// A cage refined some times, or what of it is of interest: faces that are `whole`, and around them at least all faces
/// that touch these. Side s runs from corners[s] to the next corner of its face; face f has the sides
/// [first_side[f], first_side[f + 1]).
struct LevelMesh {
  SubdivisionScheme scheme = SubdivisionScheme::catmull_clark;
  int level = 0;
  /// Each coordinate of each point is off by no more than this from what it were without rounding.
  double rounding = 0;
  double largest_coordinate = 0;  ///< of the cage
  Index most_neighbours = 0;      ///< the greatest valence or number of corners of the cage

  std::vector<Vec3> points;
  std::vector<double> vertex_sharpness;
  std::vector<Index> first_side{0};
  std::vector<Index> corners;
  std::vector<Index> cage_face;
  std::vector<char> whole;

  // Found by `connect`.
  std::vector<Index> face_of_side;
  std::vector<Index> edge_of_side;
  std::vector<LevelEdge> edges;
  std::vector<Index> first_of_vertex;
  std::vector<Index> sides_of_vertex;  ///< those that begin at it, by the vertex where they end

  // What of the next level they became, no_index where nothing; empty before `subdivided`.
  std::vector<Vec3> face_points;  ///< of Catmull–Clark
  std::vector<Index> point_of_vertex;
  std::vector<Index> point_of_edge;
  std::vector<Index> child_of_side;  ///< the face at the corner where the side begins

  [[nodiscard]] Index face_count() const { return static_cast<Index>(first_side.size() - 1); }
  [[nodiscard]] Index corner_count(Index face) const { return first_side[face + 1] - first_side[face]; }
  [[nodiscard]] std::span<const Index> face(Index face) const {
    return std::span(corners).subspan(first_side[face], corner_count(face));
  }
  [[nodiscard]] std::span<const Index> sides_at(Index vertex) const {
    return std::span(sides_of_vertex)
        .subspan(first_of_vertex[vertex], first_of_vertex[vertex + 1] - first_of_vertex[vertex]);
  }
  [[nodiscard]] Index next(Index side) const {
    const Index face = face_of_side[side];
    return side + 1 == first_side[face + 1] ? first_side[face] : side + 1;
  }
  [[nodiscard]] Index previous(Index side) const {
    const Index face = face_of_side[side];
    return side == first_side[face] ? first_side[face + 1] - 1 : side - 1;
  }
  [[nodiscard]] Index end_of(Index side) const { return corners[next(side)]; }
  /// The side of another face along the same edge, or no_index.
  [[nodiscard]] Index twin(Index side) const {
    const std::array<Index, 2>& sides = edges[edge_of_side[side]].sides;
    return sides[0] == side ? sides[1] : sides[0];
  }
  /// The number of the side from `from` to `to`, or no_index.
  [[nodiscard]] Index side_between(Index from, Index to) const;
  /// The edge between them, or no_index.
  [[nodiscard]] Index edge_between(Index a, Index b) const;

  /// Finds edges and what surrounds each vertex.
  void connect();
};

inline bool is_for_ever(double sharpness) { return sharpness >= sharp_for_ever; }

/// The edges at a vertex all of whose faces are present.
struct Spokes {
  std::vector<Index> edges;
  std::vector<Index> ends;
  std::vector<double> sharpness;

  void gather(const LevelMesh& mesh, Index vertex);
  [[nodiscard]] Index count() const { return static_cast<Index>(ends.size()); }
};

/// The cage with its edges and their sharpness; all faces are whole.
[[nodiscard]] LevelMesh cage_level(const SubdivisionCage& cage);

/// The next level of the faces that `refined` marks, which must be whole. They become whole faces; around them is what
/// their rules need.
[[nodiscard]] LevelMesh subdivided(LevelMesh& parent, std::span<const char> refined);

/// The level at which bounds begin: that of the cage for Loop, for Catmull–Clark the next, where faces are quadrangles.
[[nodiscard]] LevelMesh first_level(const SubdivisionCage& cage);

}  // namespace toccata
