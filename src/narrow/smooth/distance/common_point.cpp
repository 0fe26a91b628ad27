#include "narrow/smooth/distance/common_point.hpp"

#include <cmath>

#include "toccata/narrow/convex_convex.hpp"
#include "toccata/narrow/smooth_boundary.hpp"
#include "toccata/shapes/point.hpp"

namespace toccata {
namespace {

bool holds(const PosedSmooth& shape, const Vec3& point) { return side_of(point, shape) != Sign::positive; }
bool holds(const PosedConvex& shape, const Vec3& point) { return overlap(PosedConvex(Point(point)), shape); }

/// What is off by roundings of the search is put back to the multiple of `grid` it came from.
Vec3 rounded(const Vec3& v, double grid) {
  return {grid * std::nearbyint(v.x / grid), grid * std::nearbyint(v.y / grid), grid * std::nearbyint(v.z / grid)};
}

template <class B>
std::optional<Vec3> point_of_both(const PosedSmooth& a, const B& b, const SmoothNearest& found,
                                  const PairFrame& frame) {
  // A few thousand roundings of a pair of size 1.
  const double grid = 0x1p-40 / frame.factor;
  for (const Vec3& near : {found.on_a, found.on_b}) {
    const Vec3 point = frame.back(near);
    for (const Vec3& candidate : {point, rounded(point, grid)})
      if (is_finite(candidate) && holds(a, candidate) && holds(b, candidate)) return candidate;
  }
  return {};
}

}  // namespace

std::optional<Vec3> common_point(const PosedSmooth& a, const PosedSmooth& b, const SmoothNearest& found,
                                 const PairFrame& frame) {
  return point_of_both(a, b, found, frame);
}
std::optional<Vec3> common_point(const PosedSmooth& a, const PosedConvex& b, const SmoothNearest& found,
                                 const PairFrame& frame) {
  return point_of_both(a, b, found, frame);
}

}  // namespace toccata
