#pragma once

#include "toccata/narrow/casts.hpp"
#include "toccata/narrow/quadrics.hpp"

// Straight casts at and of cylinders, cones and ellipsoids.
namespace toccata {

// The exact first time in [0, 1] lies in [lower, upper]; a miss is proved. Status: exact, when upper − lower is at most
// 2⁻⁴⁰ and both ends are proved; undecided, when the way grazes and whether they meet could not be proved: hit is true
// then, and [lower, upper] is where they would; not_converged, when the interval holds but is wider. A ray goes from
// `origin` to `origin + motion`; of two shapes A moves and B stands. Throws Error when a number is not finite, or the
// motion of a ray is zero.
[[nodiscard]] Cast cast_ray(const Vec3& origin, const Vec3& motion, const PosedQuadric& target);

[[nodiscard]] Cast cast_shape(const PosedQuadric& a, const Vec3& motion, const PosedQuadric& b);
[[nodiscard]] Cast cast_shape(const PosedQuadric& a, const Vec3& motion, const PosedPolytope& b);
[[nodiscard]] Cast cast_shape(const PosedPolytope& a, const Vec3& motion, const PosedQuadric& b);
[[nodiscard]] Cast cast_shape(const PosedQuadric& a, const Vec3& motion, const PosedHalfSpace& b);
[[nodiscard]] Cast cast_shape(const PosedHalfSpace& a, const Vec3& motion, const PosedQuadric& b);

}  // namespace toccata
