#include "narrow/face_meeting.hpp"

#include <algorithm>
#include <optional>
#include <span>

namespace toccata {
namespace {

/// A point in the plane, over some denominator.
struct PlanePoint {
  WideInteger x;
  WideInteger y;
};

bool less(const PlanePoint& p, const PlanePoint& q) {
  if (p.x != q.x) return p.x < q.x;
  return p.y < q.y;
}

WideInteger turn(const PlanePoint& p, const PlanePoint& q, const PlanePoint& r) {
  return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

/// Counter-clockwise, corners only: three or more, or the two ends of a segment, or one point.
using Polygon = std::vector<PlanePoint>;

/// The corners of a chain that turns left, the last one left out: it starts the next chain.
void append_chain(Polygon& hull, std::span<const PlanePoint> points) {
  const std::size_t kept = hull.size();
  for (const PlanePoint& point : points) {
    while (hull.size() >= kept + 2 && turn(hull[hull.size() - 2], hull.back(), point) <= 0) hull.pop_back();
    hull.push_back(point);
  }
  hull.pop_back();
}

/// A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions", 1979.
Polygon hull_of(std::vector<PlanePoint> points) {
  std::sort(points.begin(), points.end(), [](const PlanePoint& p, const PlanePoint& q) { return less(p, q); });
  Polygon hull;
  append_chain(hull, points);
  std::reverse(points.begin(), points.end());
  append_chain(hull, points);
  if (hull.empty()) hull.push_back(points.front());
  return hull;
}

bool contains(const Polygon& polygon, const PlanePoint& p) {
  if (polygon.size() == 1) return polygon[0].x == p.x && polygon[0].y == p.y;
  // The first corner of a hull is its least.
  if (polygon.size() == 2) return turn(polygon[0], polygon[1], p) == 0 && !less(p, polygon[0]) && !less(polygon[1], p);
  for (std::size_t i = 0; i < polygon.size(); ++i)
    if (turn(polygon[i], polygon[(i + 1) % polygon.size()], p) < 0) return false;
  return true;
}

/// point / weight, the weight positive.
struct WeightedPoint {
  PlanePoint point;
  WideInteger weight{1};
};

bool less(const WeightedPoint& p, const WeightedPoint& q) {
  return less(PlanePoint{p.point.x * q.weight, p.point.y * q.weight},
              PlanePoint{q.point.x * p.weight, q.point.y * p.weight});
}

/// Where two segments pass through each other in inner points of both.
std::optional<WeightedPoint> crossing(const PlanePoint& p, const PlanePoint& q, const PlanePoint& r,
                                      const PlanePoint& s) {
  const WideInteger of_p = turn(r, s, p), of_q = turn(r, s, q);
  if (of_p.sign() * of_q.sign() >= 0) return {};
  if (turn(p, q, r).sign() * turn(p, q, s).sign() >= 0) return {};
  const WideInteger weight = abs(of_p) + abs(of_q);
  const WideInteger share_p = abs(of_q), share_q = abs(of_p);
  return WeightedPoint{{share_p * p.x + share_q * q.x, share_p * p.y + share_q * q.y}, weight};
}

/// Keeps the least of what it is shown.
struct Least {
  std::optional<WeightedPoint> found;

  void consider(const WeightedPoint& point) {
    if (!found || less(point, *found)) found = point;
  }
  void consider_corners(const Polygon& of, const Polygon& within) {
    for (const PlanePoint& corner : of)
      if (contains(within, corner)) consider({corner, 1});
  }
};

/// The least point of two polygons that meet: a corner of one in the other, or where edges cross.
WeightedPoint least_common_point(const Polygon& p, const Polygon& q) {
  Least least;
  least.consider_corners(p, q);
  least.consider_corners(q, p);
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < q.size(); ++j)
      if (const auto cross = crossing(p[i], p[(i + 1) % p.size()], q[j], q[(j + 1) % q.size()])) least.consider(*cross);
  return *least.found;
}

/// The plane of the faces, seen along an axis across it. The axis is the last possible one: then the order by the two
/// coordinates that are left is that by all three.
struct PlaneView {
  std::size_t x = 0, y = 1, dropped = 2;

  explicit PlaneView(const IntegerVector& normal) {
    while (normal[dropped] == 0) --dropped;
    x = dropped == 0 ? 1 : 0;
    y = dropped == 2 ? 1 : 2;
  }

  [[nodiscard]] PlanePoint operator()(const IntegerVector& v) const { return {v[x], v[y]}; }
};

std::vector<PlanePoint> seen(std::span<const IntegerVector> points, const PlaneView& view) {
  std::vector<PlanePoint> in_plane;
  for (const IntegerVector& point : points) in_plane.push_back(view(point));
  return in_plane;
}

/// The point of the plane normal · p = normal · on_plane above a point of the view.
HomogeneousVector lifted(const WeightedPoint& p, const IntegerVector& normal, const IntegerVector& on_plane,
                         const PlaneView& view) {
  HomogeneousVector lifted;
  const WideInteger& steep = normal[view.dropped];
  const WideInteger size = abs(steep), side = steep.sign();
  lifted.numerator[view.x] = size * p.point.x;
  lifted.numerator[view.y] = size * p.point.y;
  lifted.numerator[view.dropped] =
      side * (dot(normal, on_plane) * p.weight - normal[view.x] * p.point.x - normal[view.y] * p.point.y);
  lifted.denominator = size * p.weight;
  return lifted;
}

}  // namespace

HomogeneousVector least_meeting_point(const ParallelFaces& faces) {
  if (faces.a.size() == 1) return {faces.a[0], 1};
  if (faces.b.size() == 1) return faces.b[0] + faces.difference;
  const PlaneView view(faces.normal);
  Polygon p = hull_of(seen(faces.a, view)), q = hull_of(seen(faces.b, view));
  const PlanePoint move = view(faces.difference.numerator);
  // A move along the dropped axis is not seen; to leave its denominator out keeps the numbers short.
  const WideInteger scale = move.x == 0 && move.y == 0 ? WideInteger(1) : faces.difference.denominator;
  for (PlanePoint& corner : p) corner = {corner.x * scale, corner.y * scale};
  for (PlanePoint& corner : q) corner = {corner.x * scale + move.x, corner.y * scale + move.y};
  WeightedPoint least = least_common_point(p, q);
  least.weight *= scale;
  return lifted(least, faces.normal, faces.a[0], view);
}

}  // namespace toccata
