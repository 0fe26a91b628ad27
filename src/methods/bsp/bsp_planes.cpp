#include "methods/bsp/bsp_planes.hpp"

#include <algorithm>
#include <limits>

#include "query/inside/inside_point.hpp"

namespace toccata {
namespace {

Integer inner_product(const IntegerRow& u, const IntegerRow& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

IntegerRow outer_product(const IntegerRow& u, const IntegerRow& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

IntegerRow row_difference(const IntegerRow& u, const IntegerRow& v) { return {u[0] - v[0], u[1] - v[1], u[2] - v[2]}; }

Integer height_of(const IntegerRow& point, const IntegerPlane& plane) {
  return inner_product(plane.normal, point) - plane.offset;
}

IntegerPoint with_positive_weight(IntegerPoint p) {
  if (p.weight > 0) return p;
  for (Integer& coordinate : p.point) coordinate = -coordinate;
  p.weight = -p.weight;
  return p;
}

}  // namespace

BspFrame::BspFrame(const Aabb& box) : box_(box), middle_(0.5 * box.lower + 0.5 * box.upper) {
  const double reach = std::max(largest_magnitude(box.lower - middle_), largest_magnitude(box.upper - middle_));
  // 2^1000 is more than enough for what is tiny, and does not overflow.
  if (reach > 0) to_unit_ = std::ldexp(1, -std::clamp(std::ilogb(reach) + 1, -1000, 1024));
}

BspPlanes::BspPlanes(const TriangleMesh& mesh, const BspFrame& frame) : mesh_(&mesh), frame_(&frame) {}

Triangle BspPlanes::triangle(Index number) const {
  const auto& [a, b, c] = mesh_->triangles()[number];
  const auto vertices = mesh_->vertices();
  return {vertices[a], vertices[b], vertices[c]};
}

BspPlane BspPlanes::add(const AxisPlane& plane) {
  axis_planes_.push_back(plane);
  return static_cast<BspPlane>(10 * triangle_count() + axis_planes_.size() - 1);
}

EdgePlane BspPlanes::edge_plane(BspPlane plane) const {
  const BspPlane number = plane - triangle_count();
  return {number / 9, number % 9 / 3, static_cast<int>(number % 3)};
}

BspPlane BspPlanes::through_edge(Index triangle_number, Index edge) const {
  const Vec3 normal = magnitudes(rounded(triangle_number).normal);
  int axis = normal.x >= normal.y ? 0 : 1;
  if (normal.z > normal[axis]) axis = 2;
  // Rounding may have made a normal of nothing; the triangle has an area.
  while (projected_orientation(triangle(triangle_number), axis) == Sign::zero) axis = (axis + 1) % 3;
  return triangle_count() + 9 * triangle_number + 3 * edge + static_cast<BspPlane>(axis);
}

RoundedBspPlane BspPlanes::rounded(BspPlane plane) const {
  if (is_axis(plane)) return rounded(axis_plane(plane));
  if (!is_triangle(plane)) return rounded(edge_plane(plane));
  const Triangle t = triangle(plane);
  const FilteredCross normal = filtered_cross(frame_->way(t[1] - t[0]), frame_->way(t[2] - t[0]));
  const double magnitude = sum_of_magnitudes(normal.magnitude);
  return {normal.value, dot(normal.value, frame_->local(t[0])), RoundedBspPlane::share * magnitude + filter::floor};
}

RoundedBspPlane BspPlanes::rounded(const AxisPlane& plane) const {
  RoundedBspPlane result;
  Vec3 on_plane = frame_->middle();
  on_plane[plane.axis] = plane.value;
  result.normal[plane.axis] = 1;
  result.offset = frame_->local(on_plane)[plane.axis];
  result.bound = RoundedBspPlane::share + filter::floor;
  return result;
}

RoundedBspPlane BspPlanes::rounded(const EdgePlane& plane) const {
  const auto [from, to] = edge_of(plane);
  const Vec3 way = frame_->way(to - from);
  const int first = (plane.axis + 1) % 3, second = (plane.axis + 2) % 3;
  RoundedBspPlane result;
  result.normal[first] = -way[second];
  result.normal[second] = way[first];
  result.offset = dot(result.normal, frame_->local(from));
  result.bound = RoundedBspPlane::share * sum_of_magnitudes(result.normal) + filter::floor;
  return result;
}

EdgeEnds BspPlanes::edge_of(const EdgePlane& plane) const {
  const Triangle t = triangle(plane.triangle);
  const int corner = static_cast<int>(plane.edge);
  return {t[corner], t[(corner + 1) % 3]};
}

Sign BspPlanes::side(const Vec3& point, BspPlane plane) const {
  if (is_axis(plane)) {
    const AxisPlane& across = axis_plane(plane);
    const double coordinate = point[across.axis];
    return static_cast<Sign>((coordinate > across.value) - (coordinate < across.value));
  }
  if (!is_triangle(plane)) {
    const EdgePlane through = edge_plane(plane);
    const auto [from, to] = edge_of(through);
    return projected_orientation({from, to, point}, through.axis);
  }
  const Triangle t = triangle(plane);
  return orient3d(t[0], t[1], t[2], point);
}

BspArithmetic::BspArithmetic(const BspPlanes& planes, const BspFrame& frame) : planes_(planes), frame_(frame) {
  for (int axis = 0; axis < 3; ++axis) {
    int least = common_exponent({frame.middle()[axis]});
    for (const Vec3& vertex : planes.mesh().vertices()) least = std::min(least, common_exponent({vertex[axis]}));
    exponent_[static_cast<std::size_t>(axis)] = least == std::numeric_limits<int>::max() ? 0 : least;
  }
  middle_ = on_grid(frame.middle());
}

IntegerPoint BspArithmetic::on_edge(const Vec3& from, const Vec3& to, BspPlane plane) {
  const IntegerPlane& cut = exact(plane);
  const IntegerRow p = on_grid(from), q = on_grid(to);
  const Integer above = height_of(p, cut), below = height_of(q, cut);
  const auto along = [&](std::size_t i) { return Integer(above * q[i] - below * p[i]); };
  return with_positive_weight({{along(0), along(1), along(2)}, above - below});
}

IntegerPoint BspArithmetic::where_meet(BspPlane p, BspPlane q, BspPlane r) {
  const IntegerPlane &a = exact(p), &b = exact(q), &c = exact(r);  // the map keeps them where they are
  const IntegerRow bc = outer_product(b.normal, c.normal), ca = outer_product(c.normal, a.normal),
                   ab = outer_product(a.normal, b.normal);
  // By Cramer's rule.
  const auto along = [&](std::size_t i) { return Integer(a.offset * bc[i] + b.offset * ca[i] + c.offset * ab[i]); };
  return with_positive_weight({{along(0), along(1), along(2)}, inner_product(a.normal, bc)});
}

Sign BspArithmetic::side(const IntegerPoint& point, BspPlane plane) {
  const IntegerPlane& beside = exact(plane);
  return sign_of(Integer(inner_product(beside.normal, point.point) - beside.offset * point.weight));
}

Vec3 BspArithmetic::place(const IntegerPoint& point) const {
  const auto from_middle = [&](std::size_t i) {
    return nearest_double(point.point[i] - point.weight * middle_[i], point.weight, exponent_[i]);
  };
  return frame_.way({from_middle(0), from_middle(1), from_middle(2)});
}

IntegerRow BspArithmetic::on_grid(const Vec3& point) const {
  return {scaled(point.x, exponent_[0]), scaled(point.y, exponent_[1]), scaled(point.z, exponent_[2])};
}

IntegerPlane BspArithmetic::made(BspPlane plane) const {
  if (planes_.is_axis(plane)) {
    const AxisPlane& across = planes_.axis_plane(plane);
    const auto axis = static_cast<std::size_t>(across.axis);
    // Its value may be finer than the grid: then the equation is multiplied by a power of two.
    const int exponent = std::min(exponent_[axis], common_exponent({across.value}));
    IntegerPlane result;
    result.normal[axis] = Integer(1) << static_cast<unsigned>(exponent_[axis] - exponent);
    result.offset = scaled(across.value, exponent);
    return result;
  }
  if (!planes_.is_triangle(plane)) return made(planes_.edge_plane(plane));
  const Triangle t = planes_.triangle(plane);
  const IntegerRow a = on_grid(t[0]);
  const IntegerRow normal = outer_product(row_difference(on_grid(t[1]), a), row_difference(on_grid(t[2]), a));
  return {normal, inner_product(normal, a)};
}

IntegerPlane BspArithmetic::made(const EdgePlane& plane) const {
  const auto [from, to] = planes_.edge_of(plane);
  const IntegerRow a = on_grid(from), way = row_difference(on_grid(to), a);
  const auto first = static_cast<std::size_t>((plane.axis + 1) % 3);
  const auto second = static_cast<std::size_t>((plane.axis + 2) % 3);
  IntegerPlane result;
  result.normal[first] = -way[second];
  result.normal[second] = way[first];
  result.offset = inner_product(result.normal, a);
  return result;
}

const IntegerPlane& BspArithmetic::exact(BspPlane plane) {
  const auto found = known_.find(plane);
  return found != known_.end() ? found->second : known_.emplace(plane, made(plane)).first->second;
}

}  // namespace toccata
