#pragma once

#include "toccata/core/status.hpp"
#include "toccata/math/predicates.hpp"
#include "toccata/narrow/posed_quadric.hpp"

// Where points lie to cylinders, cones and ellipsoids, all affine images included. World coordinates and units; the
// point is finite.
namespace toccata {

/// Negative in the interior, zero on the boundary, positive outside. Exact.
[[nodiscard]] Sign side_of(const Vec3& point, const PosedQuadric& shape);

/// The point of a shape's boundary that is nearest to a given one.
struct BoundaryPoint {
  Sign side = Sign::positive;  ///< as `side_of`
  /// The exact distance lies in [lower, upper]. Both are 0 exactly on the boundary.
  double lower = 0;
  double upper = 0;
  Vec3 point{};  ///< rounded; of several that are as near one
  /// exact: upper − lower is at most 10⁻¹² · upper. not_converged: it is more, as within some 10⁻¹⁵ of the size of the
  /// shape from its boundary, and of shapes that are nearly flat.
  Status status = Status::exact;
  friend bool operator==(const BoundaryPoint&, const BoundaryPoint&) = default;
};

/// Also from within.
[[nodiscard]] BoundaryPoint boundary_point(const Vec3& point, const PosedQuadric& shape);

}  // namespace toccata
