#pragma once

#include "narrow/convex/gjk.hpp"
#include "narrow/voronoi/region_parts.hpp"

namespace toccata {

/// No vertex but those of the feature is close to it, as `SupportSearch::close` would find by looking at all: shown
/// from the planes around the feature alone, whatever the number of vertices. `first` is a vertex of the feature, in
/// the world. Sometimes no where a scan says yes.
[[nodiscard]] bool others_clear(const SupportSearch& shape, const VoronoiRegions::Parts& parts,
                                const ConvexFeature& feature, Index first, const Vec3& direction, double slack);

}  // namespace toccata
