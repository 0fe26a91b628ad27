#include "shapes/hull_faces.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "toccata/math/predicates.hpp"
#include "toccata/shapes/primitives.hpp"

namespace toccata {
namespace {

double greatest_coordinate_of(std::span<const Vec3> points) {
  double greatest = 0;
  for (const Vec3& p : points)
    for (int axis = 0; axis < 3; ++axis) greatest = std::max(greatest, std::fabs(p[axis]));
  return greatest;
}

/// The points times a power of two, so that differences and products stay far from overflow and underflow; empty when
/// that is needless, or would lose a bit. The exact signs need no such thing, but are slow out there.
std::vector<Vec3> scaled_to_middle(std::span<const Vec3> points) {
  const double greatest = greatest_coordinate_of(points);
  if (greatest == 0 || (greatest < 0x1p200 && greatest > 0x1p-200)) return {};
  const int exponent = -std::ilogb(greatest);
  std::vector<Vec3> result;
  result.reserve(points.size());
  for (const Vec3& p : points) {
    Vec3 scaled;
    for (int axis = 0; axis < 3; ++axis) {
      scaled[axis] = std::ldexp(p[axis], exponent);
      if (std::ldexp(scaled[axis], -exponent) != p[axis]) return {};
    }
    result.push_back(scaled);
  }
  return result;
}

/// The number of the first greatest value; of what is not comparable, any.
template <class Value>
Index first_greatest(std::size_t count, const Value& value) {
  Index best = 0;
  double greatest = value(0);
  for (Index i = 1; i < count; ++i) {
    const double v = value(i);
    if (!(v > greatest)) continue;
    best = i;
    greatest = v;
  }
  return best;
}

template <class Wanted>
std::optional<Index> first_that(std::size_t count, const Wanted& wanted) {
  for (Index i = 0; i < count; ++i)
    if (wanted(i)) return i;
  return std::nullopt;
}

/// A point off the line of a and b, far from it if rounding permits; the first of those equal to it.
std::optional<Index> point_off_line(std::span<const Vec3> points, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const Index far = first_greatest(points.size(), [&](Index i) {
    const Vec3 n = cross(along, points[i] - a);
    return dot(n, n);
  });
  const auto off = [&](Index i) { return has_area({{a, b, points[i]}}); };
  // What rounding made the farthest need not be off the line; then all are asked exactly.
  return off(far) ? far : first_that(points.size(), off);
}

std::optional<Index> point_off_plane(std::span<const Vec3> points, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = cross(b - a, c - a);
  const Index far = first_greatest(points.size(), [&](Index i) { return std::fabs(dot(normal, points[i] - a)); });
  const auto off = [&](Index i) { return orient3d(a, b, c, points[i]) != Sign::zero; };
  return off(far) ? far : first_that(points.size(), off);
}

/// Points that span the hull, as many as that takes: one, two on a line, three in a plane, or four.
std::vector<Index> spanning_points(std::span<const Vec3> points) {
  const auto least = std::min_element(points.begin(), points.end(), lexicographically_less);
  const auto greatest = std::max_element(points.begin(), points.end(), lexicographically_less);
  const Index a = static_cast<Index>(least - points.begin()), b = static_cast<Index>(greatest - points.begin());
  if (*least == *greatest) return {a};
  const std::optional<Index> c = point_off_line(points, points[a], points[b]);
  if (!c) return {a, b};
  const std::optional<Index> d = point_off_plane(points, points[a], points[b], points[*c]);
  if (!d) return {a, b, *c};
  return {a, b, *c, *d};
}

HullFaces faces_of(std::span<const Vec3> points) {
  const std::vector<Index> span = spanning_points(points);
  if (span.size() == 1) return {0, span, {0}};
  if (span.size() == 2) return {1, span, {0, 2}};
  if (span.size() == 3) return flat_hull_faces(points, {span[0], span[1], span[2]});
  return merged_faces(points, quickhull(points, {span[0], span[1], span[2], span[3]}));
}

}  // namespace

std::vector<HullTriangle> hull_triangles(std::span<const Vec3> points) {
  const std::vector<Vec3> scaled = scaled_to_middle(points);
  if (!scaled.empty()) points = scaled;
  const std::vector<Index> span = spanning_points(points);
  if (span.size() < 4) return {};
  return quickhull(points, {span[0], span[1], span[2], span[3]});
}

HullFaces hull_faces(std::span<const Vec3> points) {
  const std::vector<Vec3> scaled = scaled_to_middle(points);
  return faces_of(scaled.empty() ? points : scaled);
}

}  // namespace toccata
