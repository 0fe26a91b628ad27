#pragma once

#include <cstddef>
#include <optional>

#include "math/bounded_number.hpp"
#include "query/contacts/surface_within.hpp"
#include "query/meshes/posed_mesh.hpp"
#include "query/search_scratch.hpp"
#include "query/volume/crossed_surfaces.hpp"

namespace toccata {

/// What two closed meshes have in common, by their surfaces.
struct WindingVolume {
  BoundedNumber integral;       ///< over all space, of the product of the two winding numbers
  std::size_t curve_count = 0;  ///< closed curves along which the surfaces cross, after one of them was moved a little
  std::optional<Vec3> middle;   ///< of the corners of these curves
};

/// The volume by the divergence theorem over the pieces of each surface in the other solid. Which pieces there are is
/// exact, by the signs of perturbed_pair.hpp, and nothing is cut: a piece of a triangle is given by the segments around
/// it (docs/methods/overlap-volume.md). What is rounded is the sum alone. The two are not to be exchanged.
[[nodiscard]] WindingVolume winding_volume(CrossedSurfaces& surfaces);

/// The winding number that a closed mesh has in the region, besides 0: 0 where it has no other, and nothing where there
/// are several or it could not be proved that there are not.
[[nodiscard]] std::optional<int> only_winding_in(const PosedMesh& mesh, const Aabb& region, SearchScratch& scratch);

/// There are inner points of a closed mesh beside its triangle, no farther than that from a point of it, which is known
/// up to rounding: exact, whatever else is there. A triangle has outside on both sides where another lies on it that
/// turns the other way. Also false where rounding hides it.
[[nodiscard]] bool has_inside_beside(const PosedMesh& mesh, Index triangle, const Vec3& point, double at_most);

}  // namespace toccata
