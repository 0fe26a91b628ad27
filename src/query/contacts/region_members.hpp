#pragma once

#include <optional>
#include <span>
#include <vector>

#include "query/contacts/surface_within.hpp"

namespace toccata {

/// What belongs to one region: its contacts, ascending, and the pieces of either surface within the other solid.
struct RegionMembers {
  std::vector<Index> contacts;
  std::vector<Index> pieces_of_a;
  std::vector<Index> pieces_of_b;
};

/// Collects the contacts of two meshes whose triangles are connected through vertices of both. The region with the
/// least contact comes first.
[[nodiscard]] std::vector<RegionMembers> regions_of_surfaces(std::span<const Contact> contacts, VertexGraph& a,
                                                             VertexGraph& b);

/// The same for two solids, where a part of one's surface within the other also joins contacts: through vertices
/// inside, or along a straight way within a triangle.
[[nodiscard]] std::vector<RegionMembers> regions_of_solids(std::span<const Contact> contacts, VertexGraph& a,
                                                           const SurfaceWithin& a_within, VertexGraph& b,
                                                           const SurfaceWithin& b_within);

/// Where the surfaces of two solids cross along several curves around one common part: the one whose surface leads from
/// curve to curve within the other, as a rod's does within a plate, while the plate's within the rod are lids. None
/// where neither does, or both, or one here and the other elsewhere.
[[nodiscard]] std::optional<ContactSide> side_that_pierces(std::span<const Contact> contacts, VertexGraph& a,
                                                           const SurfaceWithin& a_within, VertexGraph& b,
                                                           const SurfaceWithin& b_within);

}  // namespace toccata
