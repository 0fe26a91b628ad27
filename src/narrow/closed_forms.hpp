#pragma once

#include <array>

#include "narrow/nearness.hpp"
#include "toccata/narrow/posed_convex.hpp"
#include "toccata/narrow/posed_shapes.hpp"
#include "toccata/shapes/triangle.hpp"

// Formulas for pairs of simple cores, each grown by a radius; `reach` is the sum of the radii. They answer in nearly
// all cases; the rest is left to the search and to exact arithmetic.
// After C. Ericson, "Real-Time Collision Detection", 2005, sections 5.1.2 to 5.1.9; the proofs are ours.
namespace toccata {

[[nodiscard]] Nearness nearness_of_points(const Vec3& p, const Vec3& q, double reach);
[[nodiscard]] Nearness nearness_of_point_segment(const Vec3& p, const Vec3& start, const Vec3& end, double reach);
[[nodiscard]] Nearness nearness_of_segments(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s, double reach);
[[nodiscard]] Nearness nearness_of_point_triangle(const Vec3& p, const Triangle& t, double reach);
[[nodiscard]] Nearness nearness_of_point_box(const Vec3& p, const PosedBox& box, double reach);

/// A point and the hull of eight corners numbered as a box's are; the formula takes it for a parallelepiped.
[[nodiscard]] Nearness nearness_of_point_corners(const Vec3& p, const std::array<const double*, 3>& corners,
                                                 double reach);

/// For two shapes, if there is a formula for the pair.
[[nodiscard]] Nearness nearness_by_formula(const PosedConvex& a, const PosedConvex& b);

/// The weights of the triangle's point that is nearest to the origin, by Voronoi regions: v of b, w of c.
struct TriangleWeights {
  double v = 0;
  double w = 0;
};

[[nodiscard]] TriangleWeights nearest_weights(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace toccata
