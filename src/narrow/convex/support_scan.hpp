#pragma once

#include <span>

#include "toccata/narrow/posed_polytope.hpp"

namespace toccata {

/// The vertices that are scanned, and along what. Each kernel reads all of them once.
struct SupportScan {
  const double* x = nullptr;  ///< as PosedPolytope::along, padded to a multiple of eight
  const double* y = nullptr;
  const double* z = nullptr;
  Index padded_count = 0;
  Vec3 direction;
  /// What each coordinate of a vertex lets its height be off by; not used by `least`.
  Vec3 spread;
  Index count = 0;  ///< of vertices that are no padding; used by `close` only
};

/// The kernels for the SIMD level in use; asked for once a question. The height of a vertex is
/// ((direction.x · x + direction.y · y) + direction.z · z), never fused, the same bits at every level; its depth is its
/// height less ((spread.x · |x| + spread.y · |y|) + spread.z · |z|).
struct SupportKernels {
  /// The vertex of the least height, of several the first; some vertex where heights are NaN.
  Index (*least)(const SupportScan&) = nullptr;
  /// The least depth; NaN where one is.
  double (*least_depth)(const SupportScan&) = nullptr;
  /// Writes the first `capacity` vertices whose depth is not above `bound`, ascending, and returns how many there are;
  /// leaves out padding, and the vertices in `own`.
  Index (*close)(const SupportScan&, double bound, std::span<const Index> own, std::span<Index> found) = nullptr;
};

[[nodiscard]] SupportKernels support_kernels();

}  // namespace toccata
