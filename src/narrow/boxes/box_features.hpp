#pragma once

#include <array>
#include <cstddef>

#include "toccata/narrow/convex_convex.hpp"

// The features of a box by the numbers of its corners, as box_topology() has them.
namespace toccata {

inline constexpr std::array<std::array<Index, 4>, 6> corners_of_box_face = {
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

/// The lesser of the two half-edges between two corners, four to a face, as box_topology() has them.
constexpr Index edge_between(Index p, Index q) {
  for (Index h = 0; h < 24; ++h) {
    const auto& corners = corners_of_box_face[h / 4];
    const Index from = corners[h % 4], to = corners[(h + 1) % 4];
    if ((from == p && to == q) || (from == q && to == p)) return h;
  }
  return 24;
}

/// [axes along which it extends, a bit for each][corner]: a corner, an edge or a face; nothing of use for all three.
inline constexpr std::array<std::array<ConvexFeature, 8>, 8> box_feature_at = [] {
  using Kind = ConvexFeature::Kind;
  std::array<std::array<ConvexFeature, 8>, 8> table{};
  for (Index corner = 0; corner < 8; ++corner) {
    table[0][corner] = {Kind::vertex, corner};
    for (Index axis = 0; axis < 3; ++axis) {
      table[1U << axis][corner] = {Kind::edge, edge_between(corner, corner ^ 1U << axis)};
      table[7U ^ 1U << axis][corner] = {Kind::face, 2 * axis + (corner >> axis & 1U)};
    }
  }
  return table;
}();

}  // namespace toccata
