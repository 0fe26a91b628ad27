#include "narrow/convex/core_distance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "math/constants.hpp"
#include "narrow/convex/gjk.hpp"
#include "narrow/convex/nearest_weights.hpp"
#include "narrow/exact/exact_distance.hpp"
#include "narrow/exact/exact_nearest.hpp"
#include "narrow/exact/intersection_certificate.hpp"
#include "narrow/exact/nearest_certificate.hpp"

namespace toccata {
namespace {

/// What the simplex proves. The lengths are rounded sums, taken one place further.
std::optional<Sign> certain_order(const PosedPolytope& a, const PosedPolytope& b, double x, double y,
                                  const VertexPairs& simplex) {
  const double length = x + y;
  if (simplex.size == 0) return std::nullopt;
  if (simplex.size == 4) {
    if (!contains_origin(a, b, simplex)) return std::nullopt;
    return length > 0 ? Sign::negative : Sign::zero;  // a rounded sum has the sign of the sum
  }
  if (length > 0 && certainly_nearer(a, b, simplex, std::nextafter(length, 0))) return Sign::negative;
  return std::nullopt;
}

CoreDistanceOrder exact_order(const PosedPolytope& a, const PosedPolytope& b, double x, double y, VertexPairs start) {
  if (start.size == 0) start.append(0, 0);
  const ExactNearest nearest = exact_nearest(a, b, start);
  return {compare_core_distance(nearest, x, y), true, nearest.simplex};
}

}  // namespace

// The weights are not negative and add up to 1 within
// 2^-52, so the rounded point is off a point of the simplex by less than eight roundings of the sum of magnitudes.
bool certainly_nearer(const PosedPolytope& a, const PosedPolytope& b, const VertexPairs& simplex, double length) {
  std::array<Vec3, 4> points;
  for (std::size_t i = 0; i < simplex.size; ++i) points[i] = a.vertex(simplex.a[i]) - b.vertex(simplex.b[i]);
  const auto weights = nearest_weights(points, simplex.size);
  Vec3 nearest;
  double magnitude = 0;
  for (std::size_t i = 0; i < simplex.size; ++i) {
    nearest = nearest + weights[i] * points[i];
    magnitude += (std::fabs(points[i].x) + std::fabs(points[i].y)) + std::fabs(points[i].z);
  }
  const double distance = std::hypot(nearest.x, nearest.y, nearest.z);
  return distance + (0x1p-48 * (magnitude + distance) + 0x1p-1000) < length;
}

CoreDistanceOrder compare_core_distance(const PosedPolytope& a, const PosedPolytope& b, double x, double y,
                                        const VertexPairs& start) {
  const SupportKernels kernels = support_kernels();
  const SupportSearch search_a(a, kernels), search_b(b, kernels);
  const GjkEnd end = search_nearest(search_a, search_b, start, {std::numeric_limits<double>::quiet_NaN()});
  const VertexPairs& simplex = end.simplex.pairs;
  if (const auto sign = certain_order(a, b, x, y, simplex)) return {*sign, false, simplex};
  const double more = std::nextafter(x + y, infinity);
  if (!end.inside && certainly_farther(search_a, search_b, end.nearest, more)) return {Sign::positive, false, simplex};
  return exact_order(a, b, x, y, simplex);
}

CoreDistanceOrder compare_core_distance_at(const PosedPolytope& a, const PosedPolytope& b, double x, double y,
                                           const VertexPairs& simplex) {
  if (const auto sign = certain_order(a, b, x, y, simplex)) return {*sign, false, simplex};
  return compare_core_distance(a, b, x, y, simplex);
}

}  // namespace toccata
