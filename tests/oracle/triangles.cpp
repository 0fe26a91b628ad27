#include "oracle/triangles.hpp"

#include <algorithm>

namespace toccata::oracle {
namespace {

/// u × v is zero. One coordinate after the other, because mostly the first tells already.
bool are_parallel(const RationalPoint& u, const RationalPoint& v) {
  return u.y * v.z == u.z * v.y && u.z * v.x == u.x * v.z && u.x * v.y == u.y * v.x;
}

/// p lies on the closed segment from a to b.
bool is_between(const RationalPoint& p, const RationalPoint& a, const RationalPoint& b) {
  return are_parallel(b - a, p - a) && dot(p - a, p - b) <= 0;
}

/// Convex corners in cyclic order without repetitions and without corners that lie between their neighbours.
std::vector<RationalPoint> without_flat_corners(std::vector<RationalPoint> corners) {
  for (std::size_t i = 0; corners.size() > 1 && i < corners.size();) {
    const std::size_t count = corners.size();
    const RationalPoint& before = corners[(i + count - 1) % count];
    const RationalPoint& after = corners[(i + 1) % count];
    // Where two corners are left, they are a segment's ends, each of which is both neighbours of the other.
    const bool superfluous = count == 2 ? before == corners[i] : is_between(corners[i], before, after);
    if (superfluous) {
      corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(i));
      i = 0;
    } else {
      ++i;
    }
  }
  return corners;
}

/// The plane and the edges' half-spaces of a triangle with area.
Bounding bounding_of_face(const std::vector<RationalPoint>& v) {
  const RationalPoint up = cross(v[1] - v[0], v[2] - v[0]);
  Bounding result{{half_space(v[0], up)}, {}};
  for (std::size_t i = 0; i < 3; ++i) {
    const RationalPoint outwards = cross(v[(i + 1) % 3] - v[i], up);
    result.sides.push_back(half_space(v[i], outwards));
  }
  return result;
}

/// Planes through the line, and the half-spaces at both ends, of a segment.
Bounding bounding_of_segment(const RationalPoint& p, const RationalPoint& q) {
  const RationalPoint along = q - p;
  Bounding result;
  // At least two of the three products with the axes are independent; the planes of all that are not zero are kept.
  for (const RationalPoint& axis : {RationalPoint{1, 0, 0}, RationalPoint{0, 1, 0}, RationalPoint{0, 0, 1}}) {
    const RationalPoint across = cross(along, axis);
    if (!is_zero(across)) result.containing.push_back(half_space(p, across));
  }
  result.sides = {half_space(p, -along), half_space(q, along)};
  return result;
}

Bounding bounding_of_point(const RationalPoint& p) {
  return {{half_space(p, {1, 0, 0}), half_space(p, {0, 1, 0}), half_space(p, {0, 0, 1})}, {}};
}

const Rational& least(const RationalTriangle& t, Rational RationalPoint::*axis) {
  return std::ranges::min_element(t.vertex, {}, axis)->*axis;
}

const Rational& greatest(const RationalTriangle& t, Rational RationalPoint::*axis) {
  return std::ranges::max_element(t.vertex, {}, axis)->*axis;
}

bool is_in_relative_interior(const RationalPoint& p, const Bounding& bounds) {
  return std::ranges::all_of(bounds.containing, [&](const HalfSpace& h) { return height_above(h, p).is_zero(); }) &&
         std::ranges::all_of(bounds.sides, [&](const HalfSpace& h) { return height_above(h, p) < 0; });
}

CommonSetKind kind_of(const std::vector<RationalPoint>& extreme) {
  if (extreme.empty()) return CommonSetKind::none;
  if (extreme.size() == 1) return CommonSetKind::point;
  return extreme.size() == 2 ? CommonSetKind::segment : CommonSetKind::polygon;
}

}  // namespace

RationalTriangle exact(const Triangle& triangle) {
  return {{exact(triangle[0]), exact(triangle[1]), exact(triangle[2])}};
}

RationalPoint normal(const RationalTriangle& triangle) {
  const auto& v = triangle.vertex;
  return cross(v[1] - v[0], v[2] - v[0]);
}

std::vector<RationalPoint> extreme_points(const RationalTriangle& triangle) {
  // No corner of a triangle with area lies between the others.
  const auto& v = triangle.vertex;
  if (!are_parallel(v[1] - v[0], v[2] - v[0])) return {v.begin(), v.end()};
  return without_flat_corners({v.begin(), v.end()});
}

int dimension(const RationalTriangle& triangle) { return static_cast<int>(extreme_points(triangle).size()) - 1; }

Bounding bounding(const RationalTriangle& triangle) {
  const std::vector<RationalPoint> extreme = extreme_points(triangle);
  if (extreme.size() == 3) return bounding_of_face(extreme);
  return extreme.size() == 2 ? bounding_of_segment(extreme[0], extreme[1]) : bounding_of_point(extreme[0]);
}

bool boxes_overlap(const RationalTriangle& a, const RationalTriangle& b) {
  for (const auto axis : {&RationalPoint::x, &RationalPoint::y, &RationalPoint::z})
    if (least(a, axis) > greatest(b, axis) || least(b, axis) > greatest(a, axis)) return false;
  return true;
}

bool contains(const RationalTriangle& triangle, const RationalPoint& p) {
  if (!boxes_overlap(triangle, {{p, p, p}})) return false;
  const Bounding bounds = bounding(triangle);
  return std::ranges::all_of(bounds.containing, [&](const HalfSpace& h) { return height_above(h, p).is_zero(); }) &&
         std::ranges::all_of(bounds.sides, [&](const HalfSpace& h) { return height_above(h, p) <= 0; });
}

bool contains_in_relative_interior(const RationalTriangle& triangle, const RationalPoint& p) {
  return is_in_relative_interior(p, bounding(triangle));
}

TriangleFeature feature_at(const RationalTriangle& triangle, const RationalPoint& point_of_it) {
  const auto& v = triangle.vertex;
  const std::vector<RationalPoint> extreme = extreme_points(triangle);
  for (int i = 0; i < 3; ++i) {
    const RationalPoint& corner = v[static_cast<std::size_t>(i)];
    if (corner == point_of_it && std::ranges::count(extreme, corner) > 0) return {0, i};
  }
  const auto is_named = [&](std::size_t i) {
    return std::ranges::count(extreme, v[i]) > 0 && std::ranges::find(v, v[i]) == v.begin() + i;
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (is_named(i) && is_named(j) && is_between(point_of_it, v[i], v[j])) return {1, static_cast<int>(i)};
  }
  return {2, 0};
}

CommonSet common_set(const RationalTriangle& a, const RationalTriangle& b) {
  std::vector<RationalPoint> six(a.vertex.begin(), a.vertex.end());
  six.insert(six.end(), b.vertex.begin(), b.vertex.end());
  CommonSet result;
  result.coplanar = are_coplanar(six);
  if (!boxes_overlap(a, b)) return result;

  std::vector<RationalPoint> rest = extreme_points(a);
  const Bounding bounds = bounding(b);
  for (const HalfSpace& plane : bounds.containing) {
    rest = clipped(rest, plane);
    rest = clipped(rest, {-plane.normal, -plane.offset});
  }
  for (const HalfSpace& side : bounds.sides) rest = clipped(rest, side);

  result.extreme_points = without_flat_corners(rest);
  result.kind = kind_of(result.extreme_points);
  if (result.kind == CommonSetKind::none || result.coplanar) return result;
  // The centroid lies in the relative interior of the common set. If the relative interiors of a and b meet, the
  // relative interior of the common set is what they have in common, so the centroid tells.
  const RationalPoint middle = centroid(result.extreme_points);
  result.crossing = is_in_relative_interior(middle, bounds) && contains_in_relative_interior(a, middle);
  return result;
}

bool overlap(const RationalTriangle& a, const RationalTriangle& b) {
  return boxes_overlap(a, b) && common_set(a, b).kind != CommonSetKind::none;
}

}  // namespace toccata::oracle
