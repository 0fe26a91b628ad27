#include "narrow/exact/exact_distance.hpp"
#include "toccata/narrow/primitives.hpp"

namespace toccata {
namespace {

/// The sign of (height of q) − (height of p) above the plane.
Sign rise_over_plane(const Plane& plane, const Vec3& p, const Vec3& q) {
  return triple_product_sign({plane.b(), plane.a()}, {plane.c(), plane.a()}, {q, p});
}

/// The nearest of vertices that all lie on one side; of equally near ones the lexicographically least.
Vec3 nearest_vertex(const PosedPolytope& a, const Plane& plane, Sign side) {
  Vec3 nearest = a.vertex(0);
  for (Index i = 1; i < a.vertex_count(); ++i) {
    const Vec3 vertex = a.vertex(i);
    const Sign higher = rise_over_plane(plane, nearest, vertex);
    if (higher == Sign::zero ? lexicographically_less(vertex, nearest) : higher != side) nearest = vertex;
  }
  return nearest;
}

/// A point that is not in the plane, and its foot.
ExactNearest point_and_foot(const Plane& plane, const Vec3& point) {
  const std::array points{plane.a(), plane.b(), plane.c(), point};
  ExactNearest nearest;
  nearest.exponent = common_exponent(points);
  const IntegerVector a = scaled_wide(plane.a(), nearest.exponent), p = scaled_wide(point, nearest.exponent);
  const IntegerVector normal =
      cross(scaled_wide(plane.b(), nearest.exponent) - a, scaled_wide(plane.c(), nearest.exponent) - a);
  const WideInteger height = dot(normal, p - a), squared = dot(normal, normal);
  nearest.on_a = {p, 1};
  nearest.on_b = {squared * p - height * normal, squared};
  nearest.direction = height > 0 ? normal : -normal;
  nearest.squared_numerator = height * height;
  nearest.squared_denominator = squared;
  return nearest;
}

Distance meeting_at(const Vec3& point) { return {0, 0, point, point, Status::exact}; }

}  // namespace

Distance distance(const PosedSphere& a, const Plane& b) {
  if (side(b, a.centre) == Sign::zero) return meeting_at(a.centre);
  return rounded_distance(point_and_foot(b, a.centre), a.radius, 0);
}

Distance distance(const PosedPolytope& a, const Plane& b) {
  const Sign first = side(b, a.vertex(0));
  if (first == Sign::zero) return meeting_at(a.vertex(0));
  for (Index i = 1; i < a.vertex_count(); ++i) {
    const Sign other = side(b, a.vertex(i));
    if (other == Sign::zero) return meeting_at(a.vertex(i));
    if (other != first) return meeting_at(cut_segment(b, a.vertex(0), a.vertex(i)).point);
  }
  return rounded_distance(point_and_foot(b, nearest_vertex(a, b, first)), a.radius(), 0);
}

}  // namespace toccata
