#pragma once

#include <cstdint>

#include "narrow/convex/gjk.hpp"
#include "narrow/voronoi/region_parts.hpp"

namespace toccata {

enum class Others : std::uint8_t {
  clear,    ///< none is close to the feature
  unknown,  ///< a look at all has to tell
  lower,    ///< some seem to be lower than the feature
};

/// Whether vertices that are not of the feature are close to it, as `SupportSearch::close` would find by looking at
/// all: from the planes around the feature alone, whatever the number of vertices. `clear` is certain. `first` is a
/// vertex of the feature, and `first_in_world` that in the world.
[[nodiscard]] Others other_vertices(const SupportSearch& shape, const VoronoiRegions::Parts& parts,
                                    const ConvexFeature& feature, Index first, const Vec3& first_in_world,
                                    const Vec3& direction, double slack);

}  // namespace toccata
