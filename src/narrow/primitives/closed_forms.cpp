#include "narrow/primitives/closed_forms.hpp"

#include <algorithm>
#include <optional>

#include "narrow/boxes/box_axes.hpp"
#include "narrow/boxes/rigid_box_axes.hpp"

namespace toccata {
namespace {

Triangle triangle_of(const PosedPolytope& shape) { return {{shape.vertex(0), shape.vertex(1), shape.vertex(2)}}; }

/// A sphere or a point against what has a formula.
Nearness nearness_of_point_shape(const Vec3& p, const PosedPolytope& b, double reach) {
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

Nearness nearness_of_boxes(const PosedPolytope& a, const PosedPolytope& b) {
  const Nearness nearness = nearness_of_rigid_boxes(view_of(a), view_of(b));
  if (nearness != Nearness::unknown) return nearness;
  const std::optional<bool> meet = BoxAxes(a, b).meet();
  if (!meet) return Nearness::unknown;
  return *meet ? Nearness::meet : Nearness::apart;
}

Nearness nearness_by_formula(const PosedPolytope& a, const PosedPolytope& b) {
  const double reach = a.radius() + b.radius();
  if (a.vertex_count() == 1) return nearness_of_point_shape(a.vertex(0), b, reach);
  if (b.vertex_count() == 1) return nearness_of_point_shape(b.vertex(0), a, reach);
  if (a.vertex_count() == 2 && b.vertex_count() == 2)
    return nearness_of_segments(a.vertex(0), a.vertex(1), b.vertex(0), b.vertex(1), reach);
  if (reach == 0 && is_box(a) && is_box(b)) return nearness_of_boxes(a, b);
  return Nearness::unknown;
}

}  // namespace toccata
