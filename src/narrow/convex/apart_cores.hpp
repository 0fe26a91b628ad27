#pragma once

#include <optional>

#include "narrow/convex/convex_separation.hpp"

namespace toccata {

/// The separation of two grown cores that are apart, or of such shapes: of radii that reach farther than the cores are
/// apart it is what they reach farther, and else 0, the direction being one along which they are apart. Proved by that
/// direction, or with double-words from the nearest features; nothing when these do not tell that the cores are apart,
/// or how the radii reach.
[[nodiscard]] std::optional<ConvexSeparation> part_apart_cores(const PosedPolytope& a, const PosedPolytope& b);

}  // namespace toccata
