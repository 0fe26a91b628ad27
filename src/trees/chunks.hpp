#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

namespace toccata {

/// A run that is cut into pieces of a fixed size, each a task for one thread: what is made does not depend on the
/// number of threads.
struct Chunks {
  std::size_t count;
  std::size_t piece;

  [[nodiscard]] std::size_t size() const { return (count + piece - 1) / piece; }
  [[nodiscard]] std::size_t first(std::size_t chunk) const { return chunk * piece; }

  template <typename Value>
  [[nodiscard]] std::span<Value> of(std::span<Value> all, std::size_t chunk) const {
    return all.subspan(first(chunk), std::min(piece, count - first(chunk)));
  }
};

}  // namespace toccata
