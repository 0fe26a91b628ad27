#pragma once

#include <array>

#include "query/subdivision/refinement_rules.hpp"

namespace toccata {

/// Bounds on second differences of control points, which are 0 where these are those of a plane with even spacing:
/// a[0] across edges, a[1] of quadrangles (p0 − p1 + p2 − p3), a[2] along creases and borders (a + b − 2 v).
using SecondDifferences = std::array<double, 3>;

/// How second differences around a face grow from one level to the next at most (rows times differences), and how far
/// they move points (shift times differences).
struct DifferenceGrowth {
  std::array<SecondDifferences, 3> rows{};
  SecondDifferences shift{};

  /// Element by element the greater.
  void include(const DifferenceGrowth& other);
};

/// What of a vertex matters for it.
struct VertexKind {
  VertexRule rule = VertexRule::smooth;
  Index valence = 0;
  /// For vertices of creases: beside every edge that is not sharp there are the two that are, as on a border between
  /// two quadrangles.
  bool is_even = false;
  bool has_smooth_edge = true;
};

/// What a vertex of the kind contributes to the growth of each face at it. docs/methods/subdivision-surfaces.md derives
/// every number.
[[nodiscard]] DifferenceGrowth growth_at(SubdivisionScheme scheme, const VertexKind& kind);

/// What vertices contribute that come about within and on the borders of faces.
[[nodiscard]] DifferenceGrowth growth_at_new_vertices(SubdivisionScheme scheme, bool has_creases);

/// Bounds how far all levels together move a point, if that is finite; else infinity: g · differences with g such that
/// g ≥ shift + g · rows, which the sum of shift · rowsʲ over all j cannot exceed.
[[nodiscard]] double moved_by_all_levels(const DifferenceGrowth& growth, const SecondDifferences& differences);

}  // namespace toccata
