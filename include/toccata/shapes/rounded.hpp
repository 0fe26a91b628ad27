#pragma once

#include <variant>

#include "toccata/shapes/box.hpp"
#include "toccata/shapes/convex_hull.hpp"
#include "toccata/shapes/point.hpp"
#include "toccata/shapes/segment.hpp"
#include "toccata/shapes/triangle.hpp"

namespace toccata {

/// A bounded convex shape of flat faces grown by a ball: all points within `radius` of the core. Solid. Its pose may
/// not deform it (docs/truth.md). Around a point it is a sphere, around a segment a capsule.
class Rounded {
 public:
  using Core = std::variant<Point, Segment, Triangle, Box, ConvexHull>;

  /// Throws Error when the radius is not positive, or a number is not finite.
  Rounded(Core core, double radius);

  [[nodiscard]] const Core& core() const { return core_; }
  [[nodiscard]] double radius() const { return radius_; }

 private:
  Core core_;
  double radius_;
};

}  // namespace toccata
