#pragma once

#include "query/relation/relation_samples.hpp"
#include "toccata/narrow/triangle_triangle.hpp"

namespace toccata {

/// What is seen at a few points of doubles between two triangles that cross in `intersect`: where they are it is told
/// exactly, by winding numbers; that they are in the four quadrants between the planes is likely. Where it is so, all
/// there is to see is seen, without a rational number.
[[nodiscard]] RegionsSeen sample_quadrants(const SolidPair& pair, const Triangle& a, const Triangle& b,
                                           const Intersection& intersection);

}  // namespace toccata
