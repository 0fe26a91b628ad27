#pragma once

#include "toccata/bounds/hull_bound.hpp"
#include "toccata/bounds/volume.hpp"

namespace toccata {

/// How well a volume fits, rounded, in the units of its points.
struct Tightness {
  double volume = 0;
  double surface = 0;
  /// The part of its volume that the convex hull of what it holds takes up; 1 at best, 0 for flat things.
  double fill = 0;
};

template <BoundingVolume V>
[[nodiscard]] Tightness tightness(const V& volume, const ConvexHull& held) {
  const double size = measure(volume);
  return {size, surface_area(volume), size > 0 ? measure(held) / size : 0};
}

}  // namespace toccata
