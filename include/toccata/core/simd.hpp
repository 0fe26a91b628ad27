#pragma once

#include <string_view>
#include <vector>

namespace toccata {

/// How wide the machine's vector instructions are taken to be. It changes how fast an answer comes, and no bit of it.
enum class SimdLevel { scalar, sse4, avx2, avx512 };

/// "scalar", "sse4", "avx2" or "avx512".
[[nodiscard]] std::string_view name_of(SimdLevel level);

/// The levels that this machine has and the library was compiled for, ascending.
[[nodiscard]] std::vector<SimdLevel> simd_levels();

/// The level in use: the highest, unless another was asked for.
[[nodiscard]] SimdLevel simd_level();

/// Uses this level in the whole process from now on; for tests and measurements. Questions that run meanwhile may use
/// either. Throws Error when it is not one of `simd_levels`.
void use_simd_level(SimdLevel level);

}  // namespace toccata
