#pragma once

#include <array>
#include <cstddef>

#include "toccata/core/index.hpp"

namespace toccata {

/// Vertices of the Minkowski difference of two shapes, up to four: each is a vertex of A less a vertex of B.
struct VertexPairs {
  std::array<Index, 4> a{};
  std::array<Index, 4> b{};
  std::size_t size = 0;

  void append(Index vertex_a, Index vertex_b) {
    a[size] = vertex_a;
    b[size] = vertex_b;
    ++size;
  }
};

/// What a search may begin with: those of two shapes always have these.
inline VertexPairs first_vertices() {
  VertexPairs pairs;
  pairs.append(0, 0);
  return pairs;
}

}  // namespace toccata
