#pragma once

#include "toccata/bounds/aabb.hpp"
#include "toccata/shapes/triangle.hpp"

namespace toccata {

/// Do the closed box and the closed triangle have a point in common? Exact for all finite doubles, for boxes that are
/// flat and triangles without area too: the separating axes of both, with exact signs (T. Akenine-Möller, "Fast 3D
/// triangle-box overlap testing", 2001, decides the same by rounded numbers). An empty box meets nothing.
[[nodiscard]] bool overlap(const Aabb& box, const Triangle& triangle);

}  // namespace toccata
