#pragma once

#include <span>

#include "query/posed_shape.hpp"
#include "query/search_scratch.hpp"
#include "toccata/narrow/smooth.hpp"
#include "toccata/query/relation.hpp"

// A posed mesh or height field against a shape that needs no tree. The tree finds the triangles near it; every pair of
// a triangle and the shape is decided exactly, or, where the shape is smooth, proved or undecided (docs/truth.md); of
// solid meshes winding numbers tell the rest.
namespace toccata {

[[nodiscard]] bool overlap(const PosedTriangles& a, const PosedConvex& b);
[[nodiscard]] bool overlap(const PosedTriangles& a, const PosedHalfSpace& b);
[[nodiscard]] bool overlap(const PosedTriangles& a, const PosedSmooth& b);

/// Contact when some triangle is proved to meet the shape, or it is a solid that holds the shape; else undecided when
/// some triangle is.
[[nodiscard]] SmoothContact smooth_contact(const PosedTriangles& a, const PosedSmooth& b);

// A world point of the shape, exactly; of a smooth one the middle.
[[nodiscard]] inline Vec3 some_point_of(const PosedConvex& shape) { return shape.vertex(0); }
[[nodiscard]] inline const Vec3& some_point_of(const PosedSmooth& shape) { return shape.pose().offset; }

/// The triangles that meet the shape, ascending; they lie in the scratch.
[[nodiscard]] std::span<const Index> triangles_meeting(const PosedMesh& a, const PosedConvex& b,
                                                       SearchScratch& scratch);
[[nodiscard]] std::span<const Index> triangles_meeting(const PosedMesh& a, const PosedHalfSpace& b,
                                                       SearchScratch& scratch);
/// What is undecided counts.
[[nodiscard]] std::span<const Index> triangles_meeting(const PosedMesh& a, const PosedSmooth& b,
                                                       SearchScratch& scratch);

[[nodiscard]] Relation relation(const PosedTriangles& a, const PosedConvex& b);
[[nodiscard]] Relation relation(const PosedTriangles& a, const PosedHalfSpace& b);
/// All but touching is proved, and that has the status undecided. So has an answer whose kind is proved where it is not
/// decided whether one contains the other: then no containment is told.
[[nodiscard]] Relation relation(const PosedTriangles& a, const PosedSmooth& b);

}  // namespace toccata
