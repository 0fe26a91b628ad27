#pragma once

#include <memory>

#include "toccata/trees/walk.hpp"

namespace toccata {

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
