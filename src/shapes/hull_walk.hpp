#pragma once

#include <vector>

#include "toccata/shapes/convex_hull.hpp"

namespace toccata {

/// A vertex of the hull that is highest above the plane of a, b, c, on the side from which they turn counter-clockwise;
/// exact. It walks from `start` to higher neighbours: where none is higher, no vertex is, because the hull is convex.
/// From one plane to one nearby a few steps are enough.
[[nodiscard]] Index highest_vertex(const ConvexHull& hull, const Vec3& a, const Vec3& b, const Vec3& c, Index start);

/// A face, and a neighbour that is visited before it; the first face has itself.
struct FaceVisit {
  Index face = 0;
  Index before = 0;
};

/// All faces, once each. A walk that starts where the one for the face before has ended is short.
[[nodiscard]] std::vector<FaceVisit> faces_by_neighbours(const HullTopology& topology);

}  // namespace toccata
