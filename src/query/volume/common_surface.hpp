#pragma once

#include <array>
#include <optional>
#include <vector>

#include "query/volume/crossed_surfaces.hpp"

namespace toccata {

/// A closed mesh: each edge is used as often in one direction as in the other.
struct ClosedSurface {
  std::vector<Vec3> vertices;
  std::vector<std::array<Index, 3>> triangles;
};

/// The boundary of what two closed meshes have in common, whose only winding numbers besides 0 are these, 1 or −1: the
/// parts of each surface that lie in the other solid, cut into triangles, outwards. Which parts these are is exact, as
/// for `winding_volume`; the points at which edges pass through triangles are rounded. Pieces without thickness, as
/// where the two merely touch, are left out, and all that there is may be such. Nothing where rounding left faces that
/// cannot be cut, or meshes have triangles without area where they cross.
[[nodiscard]] std::optional<ClosedSurface> common_surface(CrossedSurfaces& surfaces, int winding_of_first,
                                                          int winding_of_second);

/// What the surface encloses, rounded, and by how much the rounding of its vertices and of the sum may have changed it.
struct EnclosedVolume {
  double volume = 0;
  double error = 0;
};
[[nodiscard]] EnclosedVolume enclosed_volume(const ClosedSurface& surface);

}  // namespace toccata
