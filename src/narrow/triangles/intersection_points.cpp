#include <optional>
#include <utility>

#include "math/exact.hpp"
#include "math/scaled_integer.hpp"
#include "narrow/triangles/likely_intersection_points.hpp"
#include "narrow/triangles/triangle_features.hpp"

namespace toccata {
namespace {

IntegerRow operator-(const IntegerRow& u, const IntegerRow& v) { return {u[0] - v[0], u[1] - v[1], u[2] - v[2]}; }

/// The vertices of two triangles as whole numbers, those of each axis over a power of two of its own. A ratio of two
/// determinants does not change when an axis is scaled, so the axes need not be comparable.
class WholeNumbers {
 public:
  WholeNumbers(const Triangle& a, const Triangle& b) {
    for (int axis = 0; axis < 3; ++axis)
      exponent_[static_cast<std::size_t>(axis)] =
          common_exponent({a[0][axis], a[1][axis], a[2][axis], b[0][axis], b[1][axis], b[2][axis]});
  }

  [[nodiscard]] IntegerRow of(const Vec3& v) const {
    return {scaled(v.x, exponent_[0]), scaled(v.y, exponent_[1]), scaled(v.z, exponent_[2])};
  }

  /// The point at n / d of the way from p to q, rounded to the nearest.
  [[nodiscard]] Vec3 nearest_between(const IntegerRow& p, const IntegerRow& q, Integer n, Integer d) const {
    if (d < 0) {
      n = -n;
      d = -d;
    }
    const Integer rest = d - n;
    Vec3 result;
    for (std::size_t axis = 0; axis < 3; ++axis)
      result[static_cast<int>(axis)] = nearest_double(p[axis] * rest + q[axis] * n, d, exponent_[axis]);
    return result;
  }

 private:
  std::array<int, 3> exponent_{};
};

// The features that the functions below are given meet in a single point, so no denominator is zero.

/// Where edge i of t meets the plane of `plane`.
Vec3 edge_and_plane(const WholeNumbers& whole, const Triangle& t, int i, const Triangle& plane) {
  const IntegerRow p = whole.of(edge_start(t, i)), q = whole.of(edge_end(t, i)), origin = whole.of(plane[0]);
  const IntegerRow u = whole.of(plane[1]) - origin, v = whole.of(plane[2]) - origin;
  const Integer height = determinant(u, v, p - origin);
  return whole.nearest_between(p, q, height, height - determinant(u, v, q - origin));
}

/// Where edge i of a meets edge j of b, in one plane and not parallel.
Vec3 edge_and_edge(const WholeNumbers& whole, const Triangle& a, int i, const Triangle& b, int j) {
  const IntegerRow p = whole.of(edge_start(a, i)), q = whole.of(edge_end(a, i)), r = whole.of(edge_start(b, j));
  const IntegerRow along_a = q - p, along_b = whole.of(edge_end(b, j)) - r, between = r - p;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t y = (k + 1) % 3, z = (k + 2) % 3;
    const Integer turn = along_a[y] * along_b[z] - along_a[z] * along_b[y];
    if (turn != 0) return whole.nearest_between(p, q, between[y] * along_b[z] - between[z] * along_b[y], turn);
  }
  return edge_start(a, i);  // parallel after all
}

/// Makes −0 to 0: the two are one value, and a shared vertex may be written with either.
Vec3 with_positive_zeros(const Vec3& v) { return {v.x + 0.0, v.y + 0.0, v.z + 0.0}; }

Vec3 exact_coordinates(const IntersectionPoint& point, const Triangle& a, const Triangle& b) {
  const Feature &on_a = point.on_a, &on_b = point.on_b;
  const WholeNumbers whole(a, b);
  if (on_b.kind == FeatureKind::face) return edge_and_plane(whole, a, on_a.index, b);
  if (on_a.kind == FeatureKind::face) return edge_and_plane(whole, b, on_b.index, a);
  return edge_and_edge(whole, a, on_a.index, b, on_b.index);
}

std::optional<Vec3> likely_intersection_points(const IntersectionPoint& point, const Triangle& a, const Triangle& b) {
  const Feature &on_a = point.on_a, &on_b = point.on_b;
  if (on_b.kind == FeatureKind::face) return likely_edge_and_plane(a, on_a.index, b);
  if (on_a.kind == FeatureKind::face) return likely_edge_and_plane(b, on_b.index, a);
  return likely_edge_and_edge(a, on_a.index, b, on_b.index);
}

Vec3 coordinates_of(const IntersectionPoint& point, const Triangle& a, const Triangle& b) {
  if (point.on_a.kind == FeatureKind::vertex) return with_positive_zeros(a[point.on_a.index]);
  if (point.on_b.kind == FeatureKind::vertex) return with_positive_zeros(b[point.on_b.index]);
  if (const std::optional<Vec3> likely = likely_intersection_points(point, a, b)) return *likely;
  return exact_coordinates(point, a, b);
}

}  // namespace

IntersectionPoints intersection_points(const Intersection& m, const Triangle& a, const Triangle& b) {
  IntersectionPoints result;
  result.count = m.count;
  for (std::size_t i = 0; i < m.count; ++i) result.points[i] = coordinates_of(m.points[i], a, b);
  return result;
}

}  // namespace toccata
