#pragma once

#include <optional>

#include "query/decomposition/solid_frame.hpp"
#include "toccata/query/model.hpp"
#include "toccata/shapes/convex_hull.hpp"

namespace toccata {

/// The greatest distance of a point of a hull from a solid lies within.
struct Concavity {
  double lower = 0;
  double upper = 0;
};

/// Proved by branch and bound over tetrahedra: the distance changes by no more than the way one goes. `upper` is 0
/// where the hull lies within the solid, else the interval is narrowed to `resolution` or a twentieth, or until `limit`
/// is not in it, or some thousand distances have been asked for.
/// `frame` is the solid's: in it ways are measured, so that their squares neither over- nor underflow.
[[nodiscard]] Concavity concavity_of(const ConvexHull& hull, const Model& solid, const SolidFrame& frame,
                                     double resolution, std::optional<double> limit);

}  // namespace toccata
