#pragma once

#include <optional>

#include "toccata/narrow/posed_polytope.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {

// The unit normal, from A to B, of a plane through a point of both which, by exact signs, has A behind it and B before
// it: then the shapes no more than touch. Looked at are the planes that touch either shape at the point, those along
// the axes of the world, and the one across the line between the middles; where a shape has many at the point, as at a
// rim or a corner, a few of them.
[[nodiscard]] std::optional<Vec3> separating_normal(const PosedQuadric& a, const PosedQuadric& b, const Vec3& point);
[[nodiscard]] std::optional<Vec3> separating_normal(const PosedQuadric& a, const PosedPolytope& b, const Vec3& point);

}  // namespace toccata
