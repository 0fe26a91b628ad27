#pragma once

#include <optional>

#include "narrow/convex/core_separation.hpp"

namespace toccata {

/// A facet of the Minkowski difference of two cores, with the origin's foot inside, computed with double-words.
struct PreciseFacet {
  /// The separation as if the facet were the nearest: the bounds, neighbouring doubles, are those of its distance from
  /// the origin.
  CoreSeparation separation;
  double inner_radius = 0;  ///< no border of the features' triangle or parallelogram is nearer to the foot
};

/// The facet of the vertices of a face of one and a vertex of the other, or an edge of each, or others that are reached
/// from them by exchanging a few; nothing where it cannot be proved to be a facet.
[[nodiscard]] std::optional<PreciseFacet> precise_facet(const PosedPolytope& a, const PosedPolytope& b,
                                                        const VertexPairs& corners);

/// No facet is nearer: then its bounds are those of the depth. It is told where the facet is large for its distance, as
/// mostly that of a shallow contact is; no says nothing.
[[nodiscard]] bool is_certainly_nearest(const PosedPolytope& a, const PosedPolytope& b, const PreciseFacet& facet);

}  // namespace toccata
