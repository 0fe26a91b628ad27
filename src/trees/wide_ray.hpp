#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "toccata/core/function_ref.hpp"
#include "toccata/core/index.hpp"
#include "toccata/trees/wide_tree.hpp"

namespace toccata {

/// A ray in the units of a wide tree, from its origin: origin + t · motion for t from 0 to 1. Every coordinate of both
/// is at most 8 in magnitude. `pad` covers, along each axis, all that was rounded on the way to these numbers; what the
/// walk rounds itself is its own business (docs/design/rays.md).
struct WideRay {
  std::array<float, 3> origin{};
  std::array<float, 3> motion{};
  float pad = 0;
};

/// Calls `visit(place)` with items whose boxes the ray meets, told by their places in the tree's item order: that whose
/// box is met first first, as far as boxes tell. `visit` returns the greatest t that is still of interest; less than 0
/// ends the walk. No item whose box the ray meets at a t of interest is left out.
void walk_ray(const WideTree& tree, const WideRay& ray, FunctionRef<float(Index)> visit);

/// The same for many rays, of which a few walk at a time, a step each in turn: while one waits for memory, another is
/// worked on. Each is shown what it would be shown alone, as `visit(ray, place)`.
void walk_rays(const WideTree& tree, std::span<const WideRay> rays, FunctionRef<float(std::size_t, Index)> visit);

}  // namespace toccata
