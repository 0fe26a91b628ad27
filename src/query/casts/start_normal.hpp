#pragma once

#include <concepts>
#include <optional>

#include "query/posed_shape.hpp"
#include "toccata/narrow/casts.hpp"
#include "toccata/narrow/convex_convex.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {

/// The normal of two convex sets that meet where they are: of length 1, from B to A, across what they touch in, and the
/// way in which they part soonest where they are deeper in each other. Zero where no such direction is told, as of a
/// quadric that is undecided. One of them is no half-space.
template <PosedConvexSet A, PosedConvexSet B>
[[nodiscard]] Vec3 start_normal(const A& a, const B& b) {
  // A difference leaves no −0 behind, as a sign would.
  if constexpr (std::same_as<A, PosedHalfSpace> && std::same_as<B, PosedPolytope>)
    return Vec3{} + manifold(b, a).normal;
  else
    return Vec3{} - manifold(a, b).normal;
}

/// The cast with it, if they are met at the start.
template <PosedConvexSet A, PosedConvexSet B>
[[nodiscard]] std::optional<Cast> with_start_normal(std::optional<Cast> cast, const A& a, const B& b) {
  if (cast && cast->upper == 0) cast->normal = start_normal(a, b);
  return cast;
}

}  // namespace toccata
