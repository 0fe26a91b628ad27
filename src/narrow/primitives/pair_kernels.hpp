#pragma once

#include <cstddef>
#include <cstdint>

namespace toccata {

/// Columns of two arrays (pair_arrays.hpp), from row `first` on.
struct PairColumns {
  const double* const* a = nullptr;
  const double* const* b = nullptr;
  std::size_t count = 0;
};

/// What a kernel says of a pair.
enum KernelAnswer : std::uint8_t { pair_apart = 0, pair_meets = 1, pair_unknown = 2 };

/// Looks at as many pairs from the first on as fill whole vectors, writes a state of each, and returns how many.
using PairKernel = std::size_t (*)(const PairColumns& pairs, std::uint8_t* states);

struct PairKernels {
  PairKernel sphere_sphere = nullptr;
  PairKernel sphere_triangle = nullptr;
  PairKernel sphere_box = nullptr;
  PairKernel capsule_capsule = nullptr;
  PairKernel box_box = nullptr;
};

/// The kernels of the SIMD level in use.
[[nodiscard]] PairKernels pair_kernels();

}  // namespace toccata
