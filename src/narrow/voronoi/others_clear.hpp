#pragma once

#include <cstdint>

#include "narrow/voronoi/feature_walk.hpp"

namespace toccata {

enum class Others : std::uint8_t {
  clear,    ///< none is close to the feature
  unknown,  ///< a look at all has to tell
  lower,    ///< some are lower than the feature
};

/// Whether vertices that are not of the feature are close to it, as `SupportSearch::close` would find by looking at
/// all: from the planes around the feature alone, whatever the number of vertices. Each coordinate of the direction, in
/// the world, is off by the slack at most. `clear` is certain.
[[nodiscard]] Others other_vertices(const WalkBody& body, const ConvexFeature& feature, const Vec3& direction,
                                    double slack);

}  // namespace toccata
