#pragma once

#include <memory>
#include <mutex>

#include "query/search_scratch.hpp"
#include "toccata/narrow/convex_convex.hpp"
#include "toccata/query/nearest.hpp"

namespace toccata {

/// The boundary of a convex shape at its place, which points may be within too. A shape without an interior is its own.
/// It refers to the shape, which has to outlive it. Many threads may ask.
class ConvexBoundary {
 public:
  explicit ConvexBoundary(const PosedPolytope& shape) : shape_(shape) {}

  /// Its point that is nearest to a finite one; element and face stay 0. The upper end is that of an interval of at
  /// most 0.993 · 10⁻¹² of it, and 0 only on the boundary.
  [[nodiscard]] SurfacePoint nearest(const Vec3& point, SearchScratch& scratch) const;

 private:
  struct Core;

  /// Made when a point within is first asked about.
  [[nodiscard]] const Core& core() const;
  [[nodiscard]] SurfacePoint from_within(const Vec3& point, SearchScratch& scratch) const;
  [[nodiscard]] SurfacePoint from_core(const Vec3& point, SearchScratch& scratch) const;

  const PosedPolytope& shape_;
  mutable std::once_flag once_;
  mutable std::shared_ptr<const Core> core_;
};

/// The same of the plane that bounds a half-space.
[[nodiscard]] SurfacePoint nearest_of_boundary(const Vec3& point, const PosedHalfSpace& shape);

}  // namespace toccata
