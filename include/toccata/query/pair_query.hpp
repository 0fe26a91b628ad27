#pragma once

#include <memory>

#include "toccata/core/parallel.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/shapes/scene.hpp"
#include "toccata/trees/walk.hpp"

namespace toccata {

/// How a question about two models is asked: where each is, and what each is taken for. Both poses are general 3×3
/// matrices with a translation; (A, B) under (P, Q) and under (I, P⁻¹Q) are different inputs (docs/truth.md).
struct PairQuery {
  Pose pose_a{};
  Pose pose_b{};
  Solid solid_a = Solid::automatic;
  Solid solid_b = Solid::automatic;
  int threads = own_thread;  ///< for `contacts`
};

struct SearchScratch;

/// Scratch memory that questions about two models need, for a caller who asks many: kept from call to call, it is
/// allocated once. It changes no answer. One thread may use it at a time.
class Workspace {
 public:
  Workspace();
  ~Workspace();
  Workspace(Workspace&&) noexcept;
  Workspace& operator=(Workspace&&) noexcept;

  /// What the last search that used it cost: boxes compared and pairs of triangles decided. The same at every SIMD
  /// level; on several threads the sum.
  [[nodiscard]] const WalkCounts& counts() const;

  /// For the library itself.
  [[nodiscard]] SearchScratch& scratch() { return *scratch_; }

 private:
  std::unique_ptr<SearchScratch> scratch_;
};

}  // namespace toccata
