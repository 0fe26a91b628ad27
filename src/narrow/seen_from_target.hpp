#pragma once

#include "toccata/narrow/casts.hpp"

namespace toccata {

/// The cast of what stood, towards what moved: they meet at the same time, where the other has come to by then.
/// `motion` is that of the one that moves now, opposite to that of the cast.
[[nodiscard]] inline std::optional<Cast> seen_from_target(std::optional<Cast> cast, const Vec3& motion) {
  if (!cast) return cast;
  cast->point = cast->point + cast->lower * motion;
  cast->normal = -cast->normal;
  return cast;
}

}  // namespace toccata
