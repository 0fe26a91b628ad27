#pragma once

#include <span>
#include <vector>

#include "toccata/core/index.hpp"
#include "toccata/shapes/primitives.hpp"

namespace toccata {

/// A line on a triangle along which a contact runs.
struct ContactSegment {
  Vec3 from;
  Vec3 to;
  Index contact = 0;
};

/// A face of the other mesh that lies on the triangle, as the polygon that they have in common.
struct FaceOnTriangle {
  std::vector<Vec3> outline;
  bool same_side = false;  ///< both solids are on one side of it
};

/// A convex piece of a triangle that no contact cuts.
struct TrianglePart {
  std::vector<Vec3> points;
  std::vector<int> corners;         ///< the triangle's own, else −1
  Index contact = 0;                ///< near which it lies
  const FaceOnTriangle* face = {};  ///< that it lies on
};

/// Twice the area of a closed polygon along its normal.
[[nodiscard]] Vec3 twice_area_of(std::span<const Vec3> points);

[[nodiscard]] Vec3 middle_of(std::span<const Vec3> points);

/// Cuts a triangle along segments on it, which are at least one, by a plane through one of them or, while there are
/// many, one that has half of them on either side. In doubles: pieces of less than a 2⁻⁴⁸th are left out.
[[nodiscard]] std::vector<TrianglePart> cut_triangle(const Triangle& triangle, std::vector<ContactSegment> segments,
                                                     std::span<const FaceOnTriangle> faces);

}  // namespace toccata
