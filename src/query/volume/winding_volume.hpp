#pragma once

#include <optional>
#include <span>
#include <vector>

#include "math/bounded_number.hpp"
#include "query/contacts/surface_within.hpp"
#include "query/meshes/posed_mesh.hpp"
#include "query/search_scratch.hpp"

namespace toccata {

/// What two closed meshes have in common, by their surfaces.
struct WindingVolume {
  BoundedNumber integral;       ///< over all space, of the product of the two winding numbers
  std::size_t curve_count = 0;  ///< closed curves along which the surfaces cross, after one of them was moved a little
  std::optional<Vec3> middle;   ///< of the corners of these curves
};

/// The volume by the divergence theorem over the pieces of each surface in the other solid. Which pieces there are is
/// exact, by the signs of perturbed_pair.hpp, and nothing is cut: a piece of a triangle is given by the segments around
/// it (docs/methods/overlap-volume.md). What is rounded is the sum alone. `first` and `second` are not to be exchanged.
[[nodiscard]] WindingVolume winding_volume(const PosedMesh& first, const PosedMesh& second, SearchScratch& scratch);

/// The triangles with area that meet the region, ascending.
[[nodiscard]] std::vector<Index> triangles_in_region(const PosedMesh& mesh, const Aabb& region);

/// The winding number that a closed mesh has in the region, besides 0: 0 where it has no other, and nothing where there
/// are several or it could not be proved that there are not.
[[nodiscard]] std::optional<int> only_winding_in(const PosedMesh& mesh, const Aabb& region, SearchScratch& scratch);

/// What two boxes that overlap have in common.
[[nodiscard]] Aabb common_box(const Aabb& a, const Aabb& b);

}  // namespace toccata
