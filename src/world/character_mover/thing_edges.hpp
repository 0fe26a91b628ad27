#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "world/character_mover/thing_planes.hpp"

namespace toccata {

/// The edges of a small polytope.
struct ThingEdges {
  /// By the numbers of its corners; a polytope of eight has no more edges.
  struct Ends {
    std::uint8_t from, to;
  };
  static constexpr std::size_t most = 18;

  FewCorners corners;  ///< none: of other sets
  std::array<Ends, most> edges{};
  std::size_t count = 0;
};

[[nodiscard]] ThingEdges edges_of(const LevelSet& set);

/// How far a point or a segment is from a thing, where the two are nearest at an edge of it.
struct EdgeGap {
  double distance = 0;  ///< of the two without radii: proved to be no more than the true one, and it but for rounding
  Vec3 normal{};        ///< unit, from the thing
  Vec3 foot{};          ///< on the edge
};

/// Nothing where that cannot be told in doubles: they are nearest elsewhere, or meet, or are nearly parallel.
[[nodiscard]] std::optional<EdgeGap> edge_gap(const FewCorners& core, const ThingEdges& thing);

}  // namespace toccata
