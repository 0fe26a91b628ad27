#pragma once

#include "toccata/core/simd.hpp"

namespace toccata::test {

/// Calls `test(level)` with every level of this machine forced.
template <class Test>
void at_every_simd_level(const Test& test) {
  const SimdLevel before = simd_level();
  for (const SimdLevel level : simd_levels()) {
    use_simd_level(level);
    test(level);
  }
  use_simd_level(before);
}

}  // namespace toccata::test
