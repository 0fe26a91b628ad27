#pragma once

#include "math/filter.hpp"
#include "math/wide_integer.hpp"
#include "toccata/narrow/convex_convex.hpp"

// Heights above the plane of a half-space, in units of its normal's length: what every question about one asks for.
namespace toccata {

/// (point − h.point) · h.normal, rounded, and what it may be off by.
///
/// A difference, a product and two sums: four factors 1 + δ, so that the bound of `filtered_orient2d` holds twice over
/// (math/filter.hpp); the floor stands for underflow.
[[nodiscard]] inline Filtered filtered_height(const PosedHalfSpace& h, const Vec3& point) {
  const Vec3 d = point - h.point;
  const double x = d.x * h.normal.x, y = d.y * h.normal.y, z = d.z * h.normal.z;
  const double magnitude = ((std::fabs(x) + std::fabs(y)) + std::fabs(z)) + filter::floor;
  return {(x + y) + z, 2 * filter::orient2d_bound * magnitude};
}

/// Positive above, where the normal points to. Exact.
[[nodiscard]] Sign height_sign(const PosedHalfSpace& h, const Vec3& point);

/// Which side of the plane a set reaches to.
enum class Reach { below, above };

/// The vertex that lies lowest (or highest) before the shape's radius is added; of equals the lexicographically least.
struct ExtremeVertex {
  Index index = 0;
  Vec3 position;
  Filtered height;
};

[[nodiscard]] ExtremeVertex extreme_vertex(const PosedPolytope& a, const PosedHalfSpace& h, Reach reach);

/// The sign of how far a ball reaches to that side of the plane. Exact.
[[nodiscard]] Sign reach_sign(const Vec3& centre, double radius, const PosedHalfSpace& h, Reach reach);

/// The height of a point exactly: height · 2^(length_exponent + normal_exponent).
struct ExactHeight {
  int length_exponent = 0;
  int normal_exponent = 0;
  IntegerVector point;   ///< in 2^length_exponent
  IntegerVector normal;  ///< in 2^normal_exponent
  WideInteger height;
  WideInteger normal_squared;
};

[[nodiscard]] ExactHeight exact_height(const PosedHalfSpace& h, const Vec3& point);

}  // namespace toccata
