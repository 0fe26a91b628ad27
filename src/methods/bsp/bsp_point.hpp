#pragma once

#include <array>

#include "methods/bsp/bsp_parts.hpp"

namespace toccata {

/// A point on its way down the tree. It is within the box of the mesh, which is all that the tree looks at.
class BspPointWalk {
 public:
  BspPointWalk(const BspTree::Parts& parts, const Vec3& point)
      : parts_(parts), point_(point), local_(parts.frame.local(point)), floats_(as_floats(local_)) {}

  /// The leaf below, or the first node in whose plane the point lies.
  [[nodiscard]] BspChild descend(BspChild at) const;

  /// Exact.
  [[nodiscard]] Sign side_of(BspPlane plane) const;

 private:
  const BspTree::Parts& parts_;
  Vec3 point_;
  Vec3 local_;
  std::array<float, 3> floats_;
};

/// The location of a point on no face.
[[nodiscard]] inline PointLocation located_by(int winding) {
  return {winding != 0 ? Side::inside : Side::outside, winding};
}

}  // namespace toccata
