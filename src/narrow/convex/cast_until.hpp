#pragma once

#include <optional>

#include "toccata/narrow/casts.hpp"

namespace toccata {

/// What `cast_shape` tells; or nothing, where they are proved to meet not until `limit` of the way (0 to 1), or never.
/// Where many are asked for the first, most are told apart by one plane.
[[nodiscard]] std::optional<Cast> cast_shape_until(const PosedPolytope& a, const Vec3& motion, const PosedPolytope& b,
                                                   double limit, SimplexCache& workspace);

}  // namespace toccata
