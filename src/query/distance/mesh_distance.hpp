#pragma once

#include <optional>

#include "narrow/near.hpp"
#include "query/posed_shape.hpp"
#include "query/search_scratch.hpp"
#include "toccata/query/contacts.hpp"
#include "trees/near_walk.hpp"

// Distances of a posed mesh or height field (docs/methods/mesh-distance.md). Elements and faces are those of the
// meshes.
namespace toccata {

// The nearest triangle where there are several, and its face. For a quadric the status is that of quadrics.hpp:
// undecided when some triangle is and none is proved to meet the shape. A search for what is near enough ends at the
// first triangles that are.
[[nodiscard]] std::optional<Nearby> nearby(const PosedTriangles& a, const PosedTriangles& b,
                                           const WantedDistance& wanted, SearchScratch& scratch);
[[nodiscard]] std::optional<Nearby> nearby(const PosedTriangles& a, const PosedPolytope& b,
                                           const WantedDistance& wanted, SearchScratch& scratch);
[[nodiscard]] std::optional<Nearby> nearby(const PosedTriangles& a, const PosedHalfSpace& b,
                                           const WantedDistance& wanted, SearchScratch& scratch);
[[nodiscard]] std::optional<Nearby> nearby(const PosedTriangles& a, const PosedQuadric& b, const WantedDistance& wanted,
                                           SearchScratch& scratch);

// What these are made of, for two meshes.

/// The walk that looks for what is nearest.
[[nodiscard]] NearWalk near_walk(const PosedMesh& a, const PosedMesh& b);

/// What is nearest of the surfaces alone; elements are told, and faces are not.
[[nodiscard]] std::optional<Nearby> surfaces_nearby(const PosedMesh& a, const PosedMesh& b,
                                                    const WantedDistance& wanted, SearchScratch& scratch);

/// For surfaces that meet: the distance at a pair of triangles that do, always the same pair.
[[nodiscard]] std::optional<Distance> at_contact(const PosedMesh& a, const PosedMesh& b, SearchScratch& scratch);

/// A connected part of one mesh that lies within the other, a solid: its first triangle.
struct PartInside {
  bool of_a;
  Index triangle;
};

/// For meshes whose surfaces do not meet: the first such part, one of a if there is one.
[[nodiscard]] std::optional<PartInside> inner_part(const PosedTriangles& a, const PosedTriangles& b);
[[nodiscard]] Distance at_inner_part(const PartInside& part, const PosedMesh& a, const PosedMesh& b);

/// The faces of its elements told as well.
[[nodiscard]] Distance with_faces(Distance d, const PosedMesh& a, const PosedMesh& b);

/// They meet, or lie within one that is taken as a solid.
[[nodiscard]] bool meshes_overlap(const PosedMesh& a, bool a_solid, const PosedMesh& b, bool b_solid,
                                  SearchScratch& scratch);

}  // namespace toccata
