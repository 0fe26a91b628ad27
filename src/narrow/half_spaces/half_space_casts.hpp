#pragma once

#include "toccata/narrow/casts.hpp"

namespace toccata {

/// The half-space moves and the shape stands.
[[nodiscard]] std::optional<Cast> cast_shape(const PosedHalfSpace& a, const Vec3& motion, const PosedPolytope& b);

}  // namespace toccata
