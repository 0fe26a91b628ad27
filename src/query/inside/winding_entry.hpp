#pragma once

#include <cstddef>
#include <vector>

namespace toccata {

/// A block of a tree whose part of a winding number is told by its moments.
struct WindingEntry {
  double value;
  double bound;
  std::size_t block;
};

/// Memory of a search.
using WindingEntries = std::vector<WindingEntry>;

}  // namespace toccata
