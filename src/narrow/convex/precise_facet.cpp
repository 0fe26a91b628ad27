#include "narrow/convex/precise_facet.hpp"

#include <algorithm>
#include <cmath>

#include "math/constants.hpp"
#include "math/vec3_measures.hpp"
#include "narrow/convex/gjk.hpp"
#include "narrow/convex/rounded_depth.hpp"
#include "narrow/exact/nearest_certificate.hpp"

// A facet that is large for its distance is the nearest of all. With h(m) for how far D reaches along a unit vector m,
// p = d n for the foot and r for the inner radius, D has all points of the disc around p; so that for m at the angle φ
// with n
//
//   h(m) ≥ d cos φ + r sin φ, which is no less than d as long as tan(φ / 2) ≤ r / d.
//
// What is left are directions at angles β with −n, tan(β / 2) < t = d / r. Let q be any point of D, H = −n · q:
//
//   h(m) ≥ m · q ≥ H cos β − |q| sin β ≥ (1 − 2 t²) H − 2 t |q|.
//
// Nothing else need be known of D: one plane and one point prove the depth.
namespace toccata {
namespace {

/// The corners, in turn, of the triangle or the parallelogram in the difference that the pairs span: those of a face of
/// one and a vertex of the other, or (0, 0), (1, 0) and (0, 1) of the ends of two edges.
struct DifferenceFace {
  std::array<Vec3, 4> corner;
  std::size_t count = 3;

  DifferenceFace(const PosedPolytope& a, const PosedPolytope& b, const VertexPairs& pairs) {
    for (std::size_t k = 0; k < 3; ++k) corner[k] = a.vertex(pairs.a[k]) - b.vertex(pairs.b[k]);
    const bool of_edges = pairs.a[0] != pairs.a[1] && pairs.b[0] != pairs.b[2];
    if (!of_edges) return;
    corner[3] = corner[2];
    corner[2] = a.vertex(pairs.a[1]) - b.vertex(pairs.b[2]);
    count = 4;
  }

  /// How far a point of the plane, but for rounding, is certainly from all borders.
  [[nodiscard]] double inner_radius(const Vec3& foot) const {
    double least = infinity, extent = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const Vec3 edge = corner[(k + 1) % count] - corner[k], aside = cross(foot - corner[k], edge);
      least = std::min(least, std::sqrt(dot(aside, aside) / dot(edge, edge)));
      extent = std::max(extent, largest_magnitude(corner[k]));
    }
    // Corners and the foot are off by 2^-51 of the extent, and products by less than 2^-49 of it times the edge.
    return std::max(0.0, least - 0x1p-46 * extent);
  }
};

/// The two doubles around a number; where it does not show on which side of one it is, those beside that one.
DoubleBracket bracket_around(const BoundedNumber& number) {
  if (const std::optional<DoubleBracket> found = bracket(number)) return *found;
  const double high = number.value.high;
  return {std::nextafter(high, 0), std::nextafter(high, infinity)};
}

}  // namespace

std::optional<PreciseFacet> precise_facet(const PosedPolytope& a, const PosedPolytope& b, const VertexPairs& corners) {
  const SupportKernels kernels = support_kernels();
  const std::optional<CertainNearest> found =
      certain_facet(SupportSearch(a, kernels), SupportSearch(b, kernels), corners);
  if (!found) return {};
  const Vec3 way = high_parts(found->difference);
  const double squared = dot(way, way);
  // The error has to be far less than the place of a double.
  const bool is_plain = squared > 0x1p-600 && squared < 0x1p600;
  if (!is_plain || !(found->distance.error <= 0x1p-60 * found->distance.value.high)) return {};
  const DoubleBracket depth = bracket_around(found->distance);
  PreciseFacet result;
  CoreSeparation& separation = result.separation;
  separation.kind = CoreSeparation::Kind::deep;
  separation.lower = depth.lower;
  separation.direction = (1 / std::sqrt(squared)) * way;
  separation.upper = enough_along(separation.direction, depth.upper);
  separation.on_a = high_parts(found->on_a);
  separation.on_b = high_parts(found->on_b);
  separation.pairs = found->pairs;
  result.inner_radius = DifferenceFace(a, b, found->pairs).inner_radius(way);
  return result;
}

bool is_certainly_nearest(const PosedPolytope& a, const PosedPolytope& b, const PreciseFacet& facet) {
  const SupportKernels kernels = support_kernels();
  const Vec3& n = facet.separation.direction;
  const Vec3 opposite = a.vertex(SupportSearch(a, kernels).least(n)) - b.vertex(SupportSearch(b, kernels).least(-n));
  const double depth = facet.separation.upper, size = plain_length(opposite), slope = depth / facet.inner_radius;
  const double height = -dot(n, opposite) - 0x1p-45 * size;
  return slope <= 0.5 && (1 - 2 * slope * slope) * height - 2 * slope * size >= 1.01 * depth;
}

}  // namespace toccata
