#pragma once

#include "convex_library.hpp"
#include "judge.hpp"

namespace toccata::bench {

/// What a library answered, how long it took, and how right it was.
struct ConvexResult {
  Description who;
  double median_ns = 0;
  double mean_ns = 0;
  double p99_ns = 0;
  double bytes_per_vertex = 0;
  std::size_t disagreements = 0;  ///< as of `Result`
  std::size_t wrong = 0;
  /// The largest difference to Toccata's distance or depth, also to that of a quadric pair's manifold.
  double worst_error = 0;
  std::vector<ConvexAnswer> answers{};
};

/// How far a peer's distance or depth may be off; the shapes have a size of about 1.
inline constexpr double convex_tolerance = 1e-4;

/// Counts disagreements and wrong answers into the results, of which the first is Toccata's. Toccata's intervals have
/// to hold the exact number, the depths of its manifolds of quadric pairs to be within 2⁻²⁰ of it; a peer's number has
/// to be within the tolerance of it, and its direction has to part the shapes.
void judge(const ConvexWork& work, Judged judged, std::vector<ConvexResult>& results);

}  // namespace toccata::bench
