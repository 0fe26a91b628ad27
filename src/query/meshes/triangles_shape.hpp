#pragma once

#include <optional>
#include <span>

#include "query/posed_shape.hpp"
#include "query/search_scratch.hpp"
#include "toccata/narrow/quadrics.hpp"
#include "toccata/query/relation.hpp"

// A posed mesh or height field against a shape that needs no tree. The tree finds the triangles near it; every pair of
// a triangle and the shape is decided exactly, or, where the shape is a quadric, proved or undecided (docs/truth.md);
// of solid meshes winding numbers tell the rest.
namespace toccata {

[[nodiscard]] bool overlap(const PosedTriangles& a, const PosedPolytope& b);
[[nodiscard]] bool overlap(const PosedTriangles& a, const PosedHalfSpace& b);
[[nodiscard]] bool overlap(const PosedTriangles& a, const PosedQuadric& b);

/// Contact when some triangle is proved to meet the shape, or it is a solid that holds the shape; else undecided when
/// some triangle is.
[[nodiscard]] QuadricContact quadric_contact(const PosedTriangles& a, const PosedQuadric& b);

// A world point of the shape, exactly; of a quadric the middle.
[[nodiscard]] inline Vec3 some_point_of(const PosedPolytope& shape) { return shape.vertex(0); }
[[nodiscard]] inline const Vec3& some_point_of(const PosedQuadric& shape) { return shape.pose().offset; }

/// One of the triangles that meet the shape, always the same; of a quadric one that is proved to, if any is.
[[nodiscard]] std::optional<Index> some_triangle_meeting(const PosedMesh& a, const PosedPolytope& b);
[[nodiscard]] std::optional<Index> some_triangle_meeting(const PosedMesh& a, const PosedHalfSpace& b);
[[nodiscard]] std::optional<Index> some_triangle_meeting(const PosedMesh& a, const PosedQuadric& b);

/// The triangles that meet the shape, ascending; they lie in the scratch.
[[nodiscard]] std::span<const Index> triangles_intersecting(const PosedMesh& a, const PosedPolytope& b,
                                                            SearchScratch& scratch);
[[nodiscard]] std::span<const Index> triangles_intersecting(const PosedMesh& a, const PosedHalfSpace& b,
                                                            SearchScratch& scratch);
/// What is undecided counts.
[[nodiscard]] std::span<const Index> triangles_intersecting(const PosedMesh& a, const PosedQuadric& b,
                                                            SearchScratch& scratch);

[[nodiscard]] Relation relation(const PosedTriangles& a, const PosedPolytope& b);
[[nodiscard]] Relation relation(const PosedTriangles& a, const PosedHalfSpace& b);
/// All but touching is proved, and that has the status undecided. So has an answer whose kind is proved where it is not
/// decided whether one contains the other: then no containment is told.
[[nodiscard]] Relation relation(const PosedTriangles& a, const PosedQuadric& b);

}  // namespace toccata
