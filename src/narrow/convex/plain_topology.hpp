#pragma once

#include "toccata/shapes/convex_hull.hpp"
#include "toccata/shapes/primitives.hpp"

// The topologies that many shapes have in common. They last for ever.
namespace toccata {

[[nodiscard]] HullTopology point_topology();

/// The topology of the vertices 0 and 1.
[[nodiscard]] HullTopology segment_topology();

/// The topology of a world triangle: as posed_polytope.hpp says where it has no area.
[[nodiscard]] HullTopology triangle_topology(const Triangle& triangle);

/// Vertices as numbered by `Box::corner`; faces: −x, +x, −y, +y, −z, +z.
[[nodiscard]] HullTopology box_topology();

}  // namespace toccata
