#pragma once

#include <optional>

#include "query/posed_shape.hpp"
#include "query/search_scratch.hpp"
#include "toccata/narrow/convex_convex.hpp"
#include "toccata/query/contacts.hpp"
#include "trees/near_walk.hpp"

// Distances of a posed mesh or height field (docs/methods/mesh-distance.md). Elements and faces are those of the
// meshes.
namespace toccata {

[[nodiscard]] Distance distance(const PosedTriangles& a, const PosedTriangles& b, SearchScratch& scratch);
[[nodiscard]] Distance distance(const PosedTriangles& a, const PosedPolytope& b, SearchScratch& scratch);
[[nodiscard]] Distance distance(const PosedTriangles& a, const PosedHalfSpace& b, SearchScratch& scratch);
/// The status is that of quadrics.hpp: undecided when some triangle is and none is proved to meet the shape.
[[nodiscard]] Distance distance(const PosedTriangles& a, const PosedQuadric& b, SearchScratch& scratch);

/// A distance, and whether the exact one is at most a cutoff; of a quadric, whether it may be.
struct Nearby {
  Distance distance;
  bool is_within;
};

[[nodiscard]] inline std::optional<Nearby> flipped(const std::optional<Nearby>& found) {
  return found ? std::optional(Nearby{flipped(found->distance), found->is_within}) : std::nullopt;
}

// The same bits where the distance is at most the cutoff, and where only its interval reaches above it. Nothing where
// it certainly is more, by more than 4 · 10⁻¹² of it.
[[nodiscard]] std::optional<Nearby> nearby(const PosedTriangles& a, const PosedTriangles& b, double cutoff,
                                           SearchScratch& scratch);
[[nodiscard]] std::optional<Nearby> nearby(const PosedTriangles& a, const PosedPolytope& b, double cutoff,
                                           SearchScratch& scratch);
[[nodiscard]] std::optional<Nearby> nearby(const PosedTriangles& a, const PosedHalfSpace& b, double cutoff,
                                           SearchScratch& scratch);
[[nodiscard]] std::optional<Nearby> nearby(const PosedTriangles& a, const PosedQuadric& b, double cutoff,
                                           SearchScratch& scratch);

// What these are made of, for two meshes.

/// The walk that looks for what is nearest.
[[nodiscard]] NearWalk near_walk(const PosedMesh& a, const PosedMesh& b);

/// Of the surfaces alone; elements are told, and faces are not.
[[nodiscard]] std::optional<Nearby> surfaces_nearby(const PosedMesh& a, const PosedMesh& b, double cutoff,
                                                    SearchScratch& scratch);

/// Of surfaces that meet: at the least pair of triangles that do.
[[nodiscard]] Distance at_contact(const PosedMesh& a, const PosedMesh& b, SearchScratch& scratch);

/// A connected part of one mesh that lies within the other, a solid: its first triangle.
struct PartInside {
  bool of_a;
  Index triangle;
};

/// Of meshes whose surfaces do not meet: the first such part, of a if there is one.
[[nodiscard]] std::optional<PartInside> inner_part(const PosedTriangles& a, const PosedTriangles& b);
[[nodiscard]] Distance at_inner_part(const PartInside& part, const PosedMesh& a, const PosedMesh& b);

/// The faces of its elements told as well.
[[nodiscard]] Distance with_faces(Distance d, const PosedMesh& a, const PosedMesh& b);

// The exact distance is at most `tolerance`, which is finite and not negative. Ends at the first triangles that are.
[[nodiscard]] bool is_within(const PosedTriangles& a, const PosedTriangles& b, double tolerance,
                             SearchScratch& scratch);
[[nodiscard]] bool is_within(const PosedTriangles& a, const PosedPolytope& b, double tolerance, SearchScratch& scratch);
[[nodiscard]] bool is_within(const PosedTriangles& a, const PosedHalfSpace& b, double tolerance,
                             SearchScratch& scratch);
/// False is proved; true where the tolerance lies within the interval.
[[nodiscard]] bool is_within(const PosedTriangles& a, const PosedQuadric& b, double tolerance, SearchScratch& scratch);

}  // namespace toccata
