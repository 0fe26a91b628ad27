#include "narrow/closed_forms.hpp"

#include <algorithm>
#include <optional>

#include "narrow/box_axes.hpp"
#include "narrow/rigid_box_axes.hpp"

namespace toccata {
namespace {

double least_of(double a, double b) { return a < b ? a : b; }

/// The least product with d of the points p + [0, 1] · edge.
double least_along(const Vec3& d, const Vec3& p, const Vec3& edge) { return dot(p, d) + least_of(0, dot(edge, d)); }

struct SegmentWeights {
  double s = 0;
  double t = 0;
};

/// Of the nearest points p + s · u and q + t · v, given the difference p − q; section 5.1.9.
SegmentWeights nearest_weights_of_segments(const Vec3& difference, const Vec3& u, const Vec3& v) {
  const double uu = dot(u, u), vv = dot(v, v), uv = dot(u, v);
  const double along_u = dot(u, difference), along_v = dot(v, difference);
  const double determinant = uu * vv - uv * uv;
  // Parallel or nearly: any s will do, and that of the first end is taken. A segment without length has 0 / 0.
  double s = determinant > 0 ? clamped((uv * along_v - along_u * vv) / determinant, 0, 1) : 0;
  double t = (uv * s + along_v) / vv;
  if (!(t > 0 && t < 1)) {
    t = t >= 1 ? 1 : 0;
    s = clamped((uv * t - along_u) / uu, 0, 1);
  }
  return {s, t};
}

Triangle triangle_of(const PosedConvex& shape) { return {{shape.vertex(0), shape.vertex(1), shape.vertex(2)}}; }

/// A sphere or a point against what has a formula.
Nearness nearness_of_point_shape(const Vec3& p, const PosedConvex& b, double reach) {
  switch (b.vertex_count()) {
    case 1:
      return nearness_of_points(p, b.vertex(0), reach);
    case 2:
      return nearness_of_point_segment(p, b.vertex(0), b.vertex(1), reach);
    case 3:
      return nearness_of_point_triangle(p, triangle_of(b), reach);
    default:
      return is_box(b) ? nearness_of_point_corners(p, {b.along(0), b.along(1), b.along(2)}, reach) : Nearness::unknown;
  }
}

}  // namespace

Nearness nearness_of_points(const Vec3& p, const Vec3& q, double reach) {
  const Vec3 d = p - q;
  const double squared = dot(d, d);
  return judge(squared, squared, reach, 0);
}

Nearness nearness_of_point_segment(const Vec3& p, const Vec3& start, const Vec3& end, double reach) {
  const Vec3 edge = end - start, from = start - p;
  const double t = clamped(-dot(from, edge) / dot(edge, edge), 0, 1);
  const Vec3 d = from + t * edge;
  return judge(least_along(d, from, edge), dot(d, d), reach, sum_of_magnitudes(from) + sum_of_magnitudes(edge));
}

Nearness nearness_of_segments(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s, double reach) {
  const Vec3 u = q - p, v = s - r, difference = p - r;
  const SegmentWeights at = nearest_weights_of_segments(difference, u, v);
  const Vec3 d = (difference + at.s * u) - at.t * v;
  const double gap = least_along(d, difference, u) - std::max(0.0, dot(v, d));
  return judge(gap, dot(d, d), reach, (sum_of_magnitudes(difference) + sum_of_magnitudes(u)) + sum_of_magnitudes(v));
}

// Each region's planes are tests of the six products; a sign that one region has found serves the next. Section 5.1.5.
TriangleWeights nearest_weights(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a;
  const double d1 = -dot(ab, a), d2 = -dot(ac, a);
  if (d1 <= 0 && d2 <= 0) return {0, 0};
  const double d3 = -dot(ab, b), d4 = -dot(ac, b);
  if (d3 >= 0 && d4 <= d3) return {1, 0};
  const double d5 = -dot(ab, c), d6 = -dot(ac, c);
  if (d6 >= 0 && d5 <= d6) return {0, 1};
  const double weight_c = d1 * d4 - d3 * d2;
  if (weight_c <= 0 && d1 >= 0 && d3 <= 0) return {d1 / (d1 - d3), 0};
  const double weight_b = d5 * d2 - d1 * d6;
  if (weight_b <= 0 && d2 >= 0 && d6 <= 0) return {0, d2 / (d2 - d6)};
  const double weight_a = d3 * d6 - d5 * d4;
  if (weight_a <= 0 && d4 >= d3 && d5 >= d6) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {1 - w, w};
  }
  const double whole = 1 / (weight_a + weight_b + weight_c);
  return {weight_b * whole, weight_c * whole};
}

Nearness nearness_of_point_triangle(const Vec3& p, const Triangle& t, double reach) {
  const Vec3 a = t[0] - p, b = t[1] - p, c = t[2] - p;
  const TriangleWeights at = nearest_weights(a, b, c);
  // The weights may leave the triangle by their rounding, which the bound covers once they are in [0, 1].
  if (!(at.v >= 0 && at.w >= 0 && at.v + at.w <= 1 + 0x1p-50)) return Nearness::unknown;
  const Vec3 d = (a + at.v * (b - a)) + at.w * (c - a);
  const double gap = least_of(least_of(dot(a, d), dot(b, d)), dot(c, d));
  return judge(gap, dot(d, d), reach, (sum_of_magnitudes(a) + sum_of_magnitudes(b)) + sum_of_magnitudes(c));
}

Nearness nearness_of_point_box(const Vec3& p, const PosedBox& box, double reach) {
  const Vec3 w = p - box.centre;
  const Vec3 &x = box.half_axis[0], &y = box.half_axis[1], &z = box.half_axis[2];
  const double s = clamped(dot(w, x) * box.inverse_squared.x, -1, 1);
  const double t = clamped(dot(w, y) * box.inverse_squared.y, -1, 1);
  const double u = clamped(dot(w, z) * box.inverse_squared.z, -1, 1);
  const Vec3 d = (w - s * x) - (t * y + u * z);
  const double gap = dot(w, d) - ((std::fabs(dot(x, d)) + std::fabs(dot(y, d))) + std::fabs(dot(z, d)));
  return judge(gap, dot(d, d), reach, sum_of_magnitudes(w) + box.size, box.corner_slack);
}

Nearness nearness_of_point_corners(const Vec3& p, const std::array<const double*, 3>& corners, double reach) {
  const auto corner = [&](std::size_t i) { return Vec3{corners[0][i], corners[1][i], corners[2][i]}; };
  const Vec3 origin = corner(0), w = origin - p;
  const std::array<Vec3, 3> edge = {corner(1) - origin, corner(2) - origin, corner(4) - origin};
  Vec3 d = w;
  double magnitude = sum_of_magnitudes(w);
  for (const Vec3& e : edge) {
    d = d + clamped(-dot(w, e) / dot(e, e), 0, 1) * e;
    magnitude += sum_of_magnitudes(e);
  }
  double gap = HUGE_VAL, bend = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    const Vec3 from = corner(i) - p;
    gap = least_of(gap, dot(from, d));
    Vec3 rest = from - w;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if ((i >> axis & 1) != 0) rest = rest - edge[axis];
    bend = std::max(bend, sum_of_magnitudes(rest));
  }
  return judge(gap, dot(d, d), reach, 2 * magnitude, bend);
}

Nearness nearness_of_boxes(const PosedConvex& a, const PosedConvex& b) {
  const Nearness nearness = nearness_of_rigid_boxes(view_of(a), view_of(b));
  if (nearness != Nearness::unknown) return nearness;
  const std::optional<bool> meet = BoxAxes(a, b).meet();
  if (!meet) return Nearness::unknown;
  return *meet ? Nearness::meet : Nearness::apart;
}

Nearness nearness_by_formula(const PosedConvex& a, const PosedConvex& b) {
  const double reach = a.radius() + b.radius();
  if (a.vertex_count() == 1) return nearness_of_point_shape(a.vertex(0), b, reach);
  if (b.vertex_count() == 1) return nearness_of_point_shape(b.vertex(0), a, reach);
  if (a.vertex_count() == 2 && b.vertex_count() == 2)
    return nearness_of_segments(a.vertex(0), a.vertex(1), b.vertex(0), b.vertex(1), reach);
  if (reach == 0 && is_box(a) && is_box(b)) return nearness_of_boxes(a, b);
  return Nearness::unknown;
}

}  // namespace toccata
