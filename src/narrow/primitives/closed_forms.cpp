#include "narrow/primitives/closed_forms.hpp"

#include <algorithm>
#include <optional>

#include "narrow/boxes/box_axes.hpp"
#include "narrow/boxes/rigid_box_axes.hpp"

namespace toccata {
namespace {

Triangle triangle_of(const PosedPolytope& shape) { return {{shape.vertex(0), shape.vertex(1), shape.vertex(2)}}; }

/// The nearest points of a segment and a box along the segment: the box's edges are nearly at right angles, so that for
/// each point of the segment the weights of the edges are told one by one.
class SegmentBesideBox {
 public:
  /// `from` is the way from the segment's start to the box's origin.
  SegmentBesideBox(const Vec3& from, const Vec3& way, const std::array<Vec3, 3>& edge)
      : along_(dot(way, from)), squared_(dot(way, way)) {
    for (std::size_t i = 0; i < 3; ++i) {
      way_[i] = dot(way, edge[i]);
      from_[i] = dot(from, edge[i]);
      inverse_[i] = 1 / dot(edge[i], edge[i]);
    }
  }

  [[nodiscard]] double weight(std::size_t i, double t) const {
    return clamped((t * way_[i] - from_[i]) * inverse_[i], 0, 1);
  }

  /// The square of the distance is a convex function of t: where its slope is 0, by Newton's method within a bracket.
  [[nodiscard]] double nearest() const {
    if (!(slope_at(0) < 0)) return 0;
    if (!(slope_at(1) > 0)) return 1;
    double lower = 0, upper = 1, t = 0.5;
    for (int round = 0; round < most_rounds; ++round) {
      const double slope = slope_at(t);
      if (slope == 0) break;
      (slope > 0 ? upper : lower) = t;
      const double step = t - slope / bend_at(t);
      const double next = step > lower && step < upper ? step : 0.5 * (lower + upper);
      if (next == t) break;
      t = next;
    }
    return t;
  }

 private:
  static constexpr int most_rounds = 12;

  /// Half of the first derivative, and of the second.
  [[nodiscard]] double slope_at(double t) const {
    return ((t * squared_ - along_) - weight(0, t) * way_[0]) - (weight(1, t) * way_[1] + weight(2, t) * way_[2]);
  }
  [[nodiscard]] double bend_at(double t) const {
    double bend = squared_;
    for (std::size_t i = 0; i < 3; ++i) {
      const double at = weight(i, t);
      if (at > 0 && at < 1) bend -= way_[i] * way_[i] * inverse_[i];
    }
    return bend;
  }

  double along_, squared_;
  std::array<double, 3> way_, from_, inverse_;
};

/// A box by its corners, numbered as a box's are, seen from a point.
struct SeenBox {
  const std::array<const double*, 3>& corners;
  Vec3 from;
  Vec3 origin;
  std::array<Vec3, 3> edge;

  SeenBox(const std::array<const double*, 3>& box, const Vec3& point) : corners(box), from(point) {
    origin = corner(0);
    edge = {corner(1) - origin, corner(2) - origin, corner(4) - origin};
    origin = origin - from;
  }

  [[nodiscard]] Vec3 corner(std::size_t i) const { return {corners[0][i], corners[1][i], corners[2][i]}; }

  [[nodiscard]] double magnitude() const {
    double magnitude = sum_of_magnitudes(origin);
    for (const Vec3& e : edge) magnitude += sum_of_magnitudes(e);
    return magnitude;
  }

  /// The least product of a corner with d, and how far a corner lies beside where the edges have it at most.
  struct Bounds {
    double gap = HUGE_VAL;
    double bend = 0;
  };
  [[nodiscard]] Bounds bounds(const Vec3& d) const {
    Bounds bounds;
    for (std::size_t i = 0; i < 8; ++i) {
      const Vec3 seen = corner(i) - from;
      bounds.gap = least_of(bounds.gap, dot(seen, d));
      Vec3 rest = seen - origin;
      for (std::size_t axis = 0; axis < 3; ++axis)
        if ((i >> axis & 1) != 0) rest = rest - edge[axis];
      bounds.bend = std::max(bounds.bend, sum_of_magnitudes(rest));
    }
    return bounds;
  }
};

Nearness nearness_of_segment_corners(const PosedPolytope& segment, const std::array<const double*, 3>& corners,
                                     double reach) {
  const Vec3 start = segment.vertex(0), way = segment.vertex(1) - start;
  const SeenBox box(corners, start);
  const SegmentBesideBox beside(box.origin, way, box.edge);
  const double t = beside.nearest();
  Vec3 d = box.origin - t * way;
  for (std::size_t i = 0; i < 3; ++i) d = d + beside.weight(i, t) * box.edge[i];
  const auto [gap, bend] = box.bounds(d);
  return judge(gap - std::max(0.0, dot(way, d)), dot(d, d), reach, 2 * (box.magnitude() + sum_of_magnitudes(way)),
               bend);
}

Nearness nearness_of_segment_shape(const PosedPolytope& segment, const PosedPolytope& b, double reach) {
  if (b.vertex_count() == 2)
    return nearness_of_segments(segment.vertex(0), segment.vertex(1), b.vertex(0), b.vertex(1), reach);
  if (reach == 0 || !is_box(b)) return Nearness::unknown;
  return nearness_of_segment_corners(segment, {b.along(0), b.along(1), b.along(2)}, reach);
}

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
  const SeenBox box(corners, p);
  Vec3 d = box.origin;
  for (const Vec3& e : box.edge) d = d + clamped(-dot(box.origin, e) / dot(e, e), 0, 1) * e;
  const auto [gap, bend] = box.bounds(d);
  return judge(gap, dot(d, d), reach, 2 * box.magnitude(), bend);
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
  if (a.vertex_count() == 2) return nearness_of_segment_shape(a, b, reach);
  if (b.vertex_count() == 2) return nearness_of_segment_shape(b, a, reach);
  if (reach == 0 && is_box(a) && is_box(b)) return nearness_of_boxes(a, b);
  return Nearness::unknown;
}

}  // namespace toccata
