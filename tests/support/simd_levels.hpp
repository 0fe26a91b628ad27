#pragma once

#include "toccata/core/simd.hpp"

namespace toccata::test {

/// Calls `test(level)` with every level of this machine forced, and leaves the highest in use.
template <class Test>
void at_every_simd_level(const Test& test) {
  const std::vector<SimdLevel> levels = simd_levels();
  for (const SimdLevel level : levels) {
    use_simd_level(level);
    test(level);
  }
  use_simd_level(levels.back());
}

}  // namespace toccata::test
