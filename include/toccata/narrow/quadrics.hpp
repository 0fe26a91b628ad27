#pragma once

#include <cstdint>

#include "toccata/narrow/convex_half_space.hpp"
#include "toccata/narrow/posed_quadric.hpp"

// Cylinders, cones and ellipsoids (affine images included) against each other, every bounded convex shape, and
// half-spaces. Everything is in world coordinates and units, and about the real image of the shape.
namespace toccata {

/// Apart and contact are proved. Undecided: the sets meet, or lie within 10⁻¹² of the size of the quadric of
/// touching (of two, of the larger; docs/truth.md): its depth or its gap is no larger. It counts as contact. What
/// touches exactly is in contact where exact signs find a point of doubles in both, as along the axes. Against
/// half-spaces nothing is undecided: all their answers are exact in what they say of touching, and of lying within.
enum class QuadricContact : std::uint8_t { apart, contact, undecided };

[[nodiscard]] QuadricContact quadric_contact(const PosedQuadric& a, const PosedQuadric& b);
[[nodiscard]] QuadricContact quadric_contact(const PosedQuadric& a, const PosedPolytope& b);
[[nodiscard]] QuadricContact quadric_contact(const PosedPolytope& a, const PosedQuadric& b);
[[nodiscard]] QuadricContact quadric_contact(const PosedQuadric& a, const PosedHalfSpace& b);
[[nodiscard]] QuadricContact quadric_contact(const PosedHalfSpace& a, const PosedQuadric& b);

// Do they have a point in common? Touching counts, and what is undecided.
[[nodiscard]] bool overlap(const PosedQuadric& a, const PosedQuadric& b);
[[nodiscard]] bool overlap(const PosedQuadric& a, const PosedPolytope& b);
[[nodiscard]] bool overlap(const PosedPolytope& a, const PosedQuadric& b);
[[nodiscard]] bool overlap(const PosedQuadric& a, const PosedHalfSpace& b);
[[nodiscard]] bool overlap(const PosedHalfSpace& a, const PosedQuadric& b);

// The exact distance lies in [lower, upper]; on_a and on_b are points of the shapes, rounded, that are no farther apart
// than upper. Status:
//   exact          apart, upper − lower at most 10⁻¹² · upper; or 0 and 0, as the shapes certainly meet
//   undecided      see QuadricContact; lower is 0
//   not_converged  the interval holds, but is wider
// Exchanging the shapes exchanges the points and changes no other bit.
[[nodiscard]] Distance distance(const PosedQuadric& a, const PosedQuadric& b);
[[nodiscard]] Distance distance(const PosedQuadric& a, const PosedPolytope& b);
[[nodiscard]] Distance distance(const PosedPolytope& a, const PosedQuadric& b);
[[nodiscard]] Distance distance(const PosedQuadric& a, const PosedHalfSpace& b);
[[nodiscard]] Distance distance(const PosedHalfSpace& a, const PosedQuadric& b);

}  // namespace toccata
