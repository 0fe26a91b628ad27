#pragma once

#include <memory>

#include "toccata/narrow/posed_polytope.hpp"

namespace toccata {

/// All points within a distance of a convex solid, asked in the ways of point-in-offset-solid tests: the lecture's one
/// by planes that are moved outwards, the same with bevels, and the exact one. World coordinates and units. Immutable;
/// copies share all.
class OffsetSolid {
 public:
  /// Its own hull is kept: `solid` need not outlive it. Throws Error when it is a surface or has a radius itself, has
  /// been flattened by rounding, or the distance is negative or not finite.
  OffsetSolid(const PosedPolytope& solid, double distance);

  // All three throw Error when the point is not finite.

  /// Behind all face planes, each moved outwards by the distance: exact as that, but accepts more than the offset
  /// solid. Where two faces meet at the inner angle α it reaches 1 / sin(α / 2) times as far as it should, at a box's
  /// corner √3 times; at sharp edges any number of times.
  [[nodiscard]] bool in_moved_planes(const Vec3& point) const;

  /// Behind these and behind one more plane across each edge and each corner, which touches the offset solid there:
  /// still accepts all of it, and less beside it. Of a box the error is at most 13 % of the distance instead of 73 %.
  /// The planes of bevels are rounded, to the accepting side.
  [[nodiscard]] bool in_beveled_planes(const Vec3& point) const;

  /// At most that far from the solid. Exact.
  [[nodiscard]] bool contains(const Vec3& point) const;

 private:
  struct Parts;
  std::shared_ptr<const Parts> parts_;
};

}  // namespace toccata
