#pragma once

#include "toccata/narrow/triangle_triangle.hpp"

namespace toccata {

/// The meeting of any two triangles, by trying every pair of features: slower than intervals, and without a case that
/// it leaves out. Decides triangles without area; elsewhere an oracle.
[[nodiscard]] Intersection feature_intersection(const Triangle& a, const Triangle& b);

/// Whether it is not empty.
[[nodiscard]] bool features_overlap(const Triangle& a, const Triangle& b);

}  // namespace toccata
