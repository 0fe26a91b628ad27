#pragma once

#include <span>

#include "narrow/triangles/triangle_features.hpp"
#include "toccata/narrow/triangle_triangle.hpp"

namespace toccata {

/// What is known besides the extreme points.
struct IntersectionFrame {
  bool coplanar = false;
  Feature whole_a = face_feature();  ///< the features whose relative interiors are the triangles'
  Feature whole_b = face_feature();
};

/// The meeting with these extreme points, distinct and in any order, put into the order that Intersection promises.
[[nodiscard]] Intersection intersection_from_points(std::span<const IntersectionPoint> points,
                                                    const IntersectionFrame& frame);

}  // namespace toccata
