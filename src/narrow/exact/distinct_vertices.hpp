#pragma once

#include <array>
#include <cstddef>

#include "toccata/core/index.hpp"

namespace toccata {

/// The vertices of a shape among pairs of vertices, each once.
struct DistinctVertices {
  std::array<Index, 3> vertex{};
  std::size_t count = 0;
};

}  // namespace toccata
