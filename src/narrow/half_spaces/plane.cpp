#include "toccata/narrow/plane.hpp"

#include "math/exact.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

/// Each coordinate of (b − a) × (c − a) is the orientation of the projection along that axis.
bool are_collinear(const Vec3& a, const Vec3& b, const Vec3& c) {
  for (int axis = 0; axis < 3; ++axis)
    if (orient2d(drop_axis(a, axis), drop_axis(b, axis), drop_axis(c, axis)) != Sign::zero) return false;
  return true;
}

RationalPoint exact_normal(const Plane& plane) {
  const RationalPoint a = to_rational(plane.a());
  return cross(to_rational(plane.b()) - a, to_rational(plane.c()) - a);
}

/// The normal's product with the vector from a to the point: positive on the positive side.
Rational height(const Plane& plane, const RationalPoint& normal, const RationalPoint& point) {
  return dot(normal, point - to_rational(plane.a()));
}

/// Where the line through p and q, which is not parallel to the plane, meets it.
Vec3 intersection_point(const Plane& plane, const Vec3& p, const Vec3& q) {
  const RationalPoint normal = exact_normal(plane), from = to_rational(p), to = to_rational(q);
  const Rational height_from = height(plane, normal, from), height_to = height(plane, normal, to);
  return nearest_doubles(from + (height_from / (height_from - height_to)) * (to - from));
}

}  // namespace

Plane::Plane(const Vec3& a, const Vec3& b, const Vec3& c) : a_(a), b_(b), c_(c) {
  if (!is_finite(a) || !is_finite(b) || !is_finite(c))
    throw Error("a point of the plane has a coordinate that is not finite");
  if (are_collinear(a, b, c))
    throw Error("the three points lie on one line, so they span no plane; give another point");
}

Sign side(const Plane& plane, const Vec3& point) { return orient3d(plane.a(), plane.b(), plane.c(), point); }

Vec3 normal(const Plane& plane) { return nearest_doubles(exact_normal(plane)); }

PlaneCut cut_segment(const Plane& plane, const Vec3& p, const Vec3& q) {
  const Sign from = side(plane, p), to = side(plane, q);
  if (from == Sign::zero && to == Sign::zero) return {p == q ? PlaneCutKind::point : PlaneCutKind::whole, p};
  if (from == Sign::zero) return {PlaneCutKind::point, p};
  if (to == Sign::zero) return {PlaneCutKind::point, q};
  if (from == to) return {};
  return {PlaneCutKind::point, intersection_point(plane, p, q)};
}

PlaneCut cut_line(const Plane& plane, const Vec3& p, const Vec3& q) {
  if (p == q) throw Error("a line needs two different points");
  const Sign along = triple_product_sign({plane.b(), plane.a()}, {plane.c(), plane.a()}, {q, p});
  if (along != Sign::zero) return {PlaneCutKind::point, intersection_point(plane, p, q)};
  return side(plane, p) == Sign::zero ? PlaneCut{PlaneCutKind::whole, p} : PlaneCut{};
}

}  // namespace toccata
