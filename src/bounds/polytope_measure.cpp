#include "bounds/polytope_measure.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "toccata/math/mat3.hpp"

namespace toccata {
namespace {

/// A square of the plane that is larger than any polytope asked about.
std::vector<Vec3> large_square(const PlaneBound& plane) {
  constexpr double size = 16;
  const Mat3 axes = orthonormal_axes(plane.normal, {});
  const Vec3 foot = (plane.offset / dot(plane.normal, plane.normal)) * plane.normal;
  const Vec3 u = size * axes[1], v = size * axes[2];
  return {foot + u, foot + v, foot - u, foot - v};
}

/// The part of a polygon within a plane (I. E. Sutherland, G. W. Hodgman, "Reentrant polygon clipping", 1974).
std::vector<Vec3> clipped(const std::vector<Vec3>& polygon, const PlaneBound& plane) {
  std::vector<Vec3> inside;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3& p = polygon[i];
    const Vec3& q = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    const double height_p = dot(plane.normal, p) - plane.offset, height_q = dot(plane.normal, q) - plane.offset;
    if (height_p <= 0) inside.push_back(p);
    if ((height_p < 0 && height_q > 0) || (height_p > 0 && height_q < 0))
      inside.push_back(p + (height_p / (height_p - height_q)) * (q - p));
  }
  return inside;
}

double area_of(const std::vector<Vec3>& polygon) {
  Vec3 sum;
  for (std::size_t i = 2; i < polygon.size(); ++i)
    sum = sum + cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
  return 0.5 * std::sqrt(dot(sum, sum));
}

}  // namespace

PolytopeMeasure measure_within(std::span<const PlaneBound> planes) {
  PolytopeMeasure measure;
  for (std::size_t face = 0; face < planes.size(); ++face) {
    std::vector<Vec3> polygon = large_square(planes[face]);
    for (std::size_t i = 0; i < planes.size() && !polygon.empty(); ++i)
      if (i != face) polygon = clipped(polygon, planes[i]);
    const double area = area_of(polygon), length = std::sqrt(dot(planes[face].normal, planes[face].normal));
    measure.area += area;
    measure.volume += area * planes[face].offset / length / 3;
  }
  return measure;
}

std::vector<Vec3> corners_within(std::span<const PlaneBound> planes) {
  constexpr double slack = 1e-12, same = 1e-9;
  std::vector<Vec3> corners;
  for (std::size_t face = 0; face < planes.size(); ++face) {
    std::vector<Vec3> polygon = large_square(planes[face]);
    for (std::size_t i = 0; i < planes.size() && !polygon.empty(); ++i)
      if (i != face) polygon = clipped(polygon, {planes[i].normal, planes[i].offset + slack});
    for (const Vec3& corner : polygon)
      if (std::none_of(corners.begin(), corners.end(),
                       [&](const Vec3& other) { return dot(corner - other, corner - other) < same * same; }))
        corners.push_back(corner);
  }
  return corners;
}

}  // namespace toccata
