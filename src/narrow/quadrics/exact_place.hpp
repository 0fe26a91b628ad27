#pragma once

#include <array>

#include "math/wide_integer.hpp"
#include "toccata/narrow/convex_convex.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {

/// The images of a quadric's half axes and a point as seen from its middle, exactly, over one unit.
struct ExactPlace {
  std::array<IntegerVector, 3> axis;
  IntegerVector point;
};

[[nodiscard]] ExactPlace exact_place(const PosedQuadric& shape, const Vec3& point);

/// A point along the half axes by Cramer's rule: it is at u = along / volume.
struct UnitPlace {
  std::array<WideInteger, 3> along;
  WideInteger volume;                ///< positive
  std::array<IntegerVector, 3> row;  ///< the planes of the half axes: the gradients of `along`
};

[[nodiscard]] UnitPlace unit_place(const ExactPlace& place);

// The sign of the least height of a shape above the plane through the point; the normal need not be a unit vector.
[[nodiscard]] Sign exact_sign_of_height(const PosedQuadric& shape, const Vec3& point, const Vec3& normal);
[[nodiscard]] Sign exact_sign_of_height(const PosedQuadric& shape, const Vec3& point, const IntegerVector& normal);
[[nodiscard]] Sign exact_sign_of_height(const PosedPolytope& shape, const Vec3& point, const IntegerVector& normal);

// Does the other shape contain the middle of this one, by exact signs? Then it meets the interior.
[[nodiscard]] bool is_middle_in(const PosedQuadric& shape, const PosedQuadric& other);
[[nodiscard]] bool is_middle_in(const PosedQuadric& shape, const PosedPolytope& other);

}  // namespace toccata
