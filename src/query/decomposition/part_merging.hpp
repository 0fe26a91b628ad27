#pragma once

#include <functional>
#include <vector>

#include "toccata/core/index.hpp"
#include "toccata/shapes/convex_hull.hpp"

namespace toccata {

/// A hull on its way to a part.
struct GrowingPart {
  ConvexHull hull;
  std::vector<Vec3> corners;  ///< the hull's, local (SolidFrame), those taken as one that are nearly so
  double volume = 0;          ///< of the hull, local
  double solid_volume = 0;    ///< of what it was put around, local
  std::vector<Index> faces;   ///< of triangles, ascending
};

/// Makes two parts one, the two whose hull grows least: while there are more than `most`, then while `allowed`.
[[nodiscard]] std::vector<GrowingPart> merged_parts(std::vector<GrowingPart> parts, std::size_t most, int threads,
                                                    const std::function<bool(const GrowingPart&)>& allowed);

/// The points on a grid of 2⁻³⁰, each once.
[[nodiscard]] std::vector<Vec3> snapped(std::vector<Vec3> points);

}  // namespace toccata
