#include "narrow/triangles/gap_direction.hpp"

#include <algorithm>
#include <cmath>

#include "math/constants.hpp"

namespace toccata {
namespace {

/// The way from a point of a to one of b.
Vec3 difference(const Triangle& a, const Triangle& b, const TriangleGaps::Points& points) {
  const int features = static_cast<int>(points.features), i = features % 3;
  const double s = points.share, t = points.other_share;
  if (features < 9) {
    const int k = features / 3;
    const Vec3 of_a = a[k] + s * (a[(k + 1) % 3] - a[k]), of_b = b[i] + t * (b[(i + 1) % 3] - b[i]);
    return of_b - of_a;
  }
  if (features < 12) return b[0] + s * (b[1] - b[0]) + t * (b[2] - b[0]) - a[i];
  return b[i] - (a[0] + s * (a[1] - a[0]) + t * (a[2] - a[0]));
}

}  // namespace

GapDirection gap_direction(const Triangle& a, const Triangle& b, const TriangleGaps::Points& points) {
  GapDirection found{{}, -infinity};
  const Vec3 between = difference(a, b, points);
  const double length = std::sqrt(dot(between, between));
  if (!(length > 1e-150 && length < 1e150)) return found;
  found.direction = (1 / length) * between;
  const auto height = [&](const Vec3& v) { return dot(found.direction, v - a[0]); };
  const double top = std::max({0.0, height(a[1]), height(a[2])});
  const double bottom = std::min({height(b[0]), height(b[1]), height(b[2])});
  found.gap = bottom - top;
  return found;
}

}  // namespace toccata
