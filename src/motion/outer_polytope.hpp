#pragma once

#include <vector>

#include "toccata/math/vec3.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {

/// Corners of a polytope that contains a quadric, in the quadric's own frame.
struct OuterPolytope {
  std::vector<Vec3> corners;
  /// Stretched so that the quadric is that of its kind within |x|, |y|, |z| ≤ 1, each point of the polytope is a point
  /// of the quadric times this at most, its z or not.
  double stretch = 1;
};

[[nodiscard]] OuterPolytope outer_polytope(const PosedQuadric& quadric);

}  // namespace toccata
