#pragma once

#include <atomic>

namespace toccata {

/// Whether the SIMD level in use has an operation that multiplies and adds with one rounding, as all have from AVX2 on.
/// It is asked for in the middle of formulas that are compiled for every processor.
extern std::atomic<bool> has_fused_products;

}  // namespace toccata
