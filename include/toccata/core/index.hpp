#pragma once

#include <compare>
#include <cstdint>

namespace toccata {

/// The index type of vertices, triangles, faces and objects. Numbers start at 0.
using Index = std::uint32_t;

/// Two different objects, first < second.
struct IndexPair {
  Index first;
  Index second;
  friend constexpr auto operator<=>(const IndexPair&, const IndexPair&) = default;
};

}  // namespace toccata
