#pragma once

#include <optional>

#include "query/decomposition/solid_frame.hpp"
#include "query/inside/side_search.hpp"
#include "query/nearest/nearest_search.hpp"
#include "toccata/query/model.hpp"
#include "toccata/shapes/convex_hull.hpp"

namespace toccata {

/// The greatest distance of a point of a hull from a solid lies within.
struct Concavity {
  double lower = 0;
  double upper = 0;
};

/// A solid in its place, made ready for many questions about hulls. It refers to the model and the frame.
class ConcaveSolid {
 public:
  /// `frame` is the solid's: in it ways are measured, so that their squares neither over- nor underflow.
  ConcaveSolid(const Model& solid, const SolidFrame& frame);

  /// Proved by branch and bound over tetrahedra: the distance changes by no more than the way one goes, and is no more
  /// than that from any point of the solid. `upper` is 0 where the hull lies within the solid, else the interval is
  /// narrowed to `resolution` or a twentieth, or until `limit` is not in it, or some thousand distances have been asked
  /// for.
  [[nodiscard]] Concavity concavity_of(const ConvexHull& hull, double resolution, std::optional<double> limit) const;

 private:
  const Model& solid_;
  const SolidFrame& frame_;
  NearestSearch nearest_;
  SideSearch sides_;
};

}  // namespace toccata
