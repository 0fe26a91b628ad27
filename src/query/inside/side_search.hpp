#pragma once

#include <memory>
#include <vector>

#include "query/inside/winding_search.hpp"
#include "query/posed_shape.hpp"
#include "query/search_scratch.hpp"
#include "toccata/query/signed_distance.hpp"

namespace toccata {

/// Where a point is that lies on no surface.
struct FoundSide {
  Side side = Side::outside;
  SignBy sign_by = SignBy::winding_number;
  Status status = Status::exact;
};

/// The side as a part of the answer about a distance to the surface.
[[nodiscard]] SignedDistance with_side(const SurfacePoint& nearest, const FoundSide& found);

/// On which side of a posed model points are: inside where some part holds them. It refers to the model, which has to
/// outlive it. Throws as signed_distance does of all but the point.
class SideSearch {
 public:
  SideSearch(const PosedModel& posed, SignBy asked);

  /// No point outside of the model's box is inside or undecided.
  [[nodiscard]] bool is_certain() const { return others_.empty(); }

  /// The side of a point on one of its surfaces. It is told to be by the generalised winding number where some mesh is
  /// asked by it.
  [[nodiscard]] FoundSide on_surface() const;

  /// The side of a finite point on none of its surfaces.
  [[nodiscard]] FoundSide side_of(const Vec3& point, SearchScratch& scratch) const;

 private:
  [[nodiscard]] bool held_for_certain(const Vec3& point) const;

  const PosedModel& posed_;
  std::vector<const PosedMesh*> closed_;
  std::vector<WindingSearch> others_;  ///< of meshes asked by the generalised winding number
};

}  // namespace toccata
