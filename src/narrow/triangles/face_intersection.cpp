#include "narrow/triangles/face_intersection.hpp"

#include <algorithm>
#include <optional>
#include <span>

namespace toccata {
namespace {

/// A point of a plane as it is seen along an axis.
struct PlanePoint {
  WideInteger x;
  WideInteger y;
  std::size_t number = 0;  ///< among the vertices of its face
};

bool less(const PlanePoint& p, const PlanePoint& q) {
  if (p.x != q.x) return p.x < q.x;
  return p.y < q.y;
}

WideInteger turn(const PlanePoint& p, const PlanePoint& q, const PlanePoint& r) {
  return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

/// Counter-clockwise as seen, corners only: three or more, or the two ends of a segment, or one point.
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
  const auto equal = [](const PlanePoint& p, const PlanePoint& q) { return p.x == q.x && p.y == q.y; };
  points.erase(std::unique(points.begin(), points.end(), equal), points.end());
  Polygon hull;
  append_chain(hull, points);
  std::reverse(points.begin(), points.end());
  append_chain(hull, points);
  if (hull.empty()) hull.push_back(points.front());
  return hull;
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
};

/// Corners in space, in order: counter-clockwise across the common normal.
using Face = std::vector<IntegerVector>;

Face face_of(std::span<const IntegerVector> vertices, const IntegerVector& normal, const PlaneView& view) {
  std::vector<PlanePoint> points;
  for (const IntegerVector& v : vertices) points.push_back({v[view.x], v[view.y], points.size()});
  Face face;
  for (const PlanePoint& corner : hull_of(std::move(points))) face.push_back(vertices[corner.number]);
  // Seen along +y the axes (x, z) turn the other way.
  const bool mirrored = (normal[view.dropped] < 0) != (view.dropped == 1);
  if (mirrored) std::reverse(face.begin(), face.end());
  return face;
}

/// Twice the area that three points span across the normal, times its length. A move along the normal does not change
/// it: so points of the two parallel planes can be mixed, as if one had been moved onto the other.
class Turn {
 public:
  explicit Turn(const IntegerVector& normal) : normal_(normal) {}

  [[nodiscard]] WideInteger operator()(const IntegerVector& p, const IntegerVector& q, const IntegerVector& r) const {
    return dot(cross(q - p, r - p), normal_);
  }

 private:
  const IntegerVector& normal_;
};

/// The face is more than a vertex.
bool contains(const Face& face, const IntegerVector& p, const Turn& turn) {
  for (std::size_t i = 0; i < face.size(); ++i)
    if (turn(face[i], face[(i + 1) % face.size()], p) < 0) return false;
  if (face.size() > 2) return true;
  const IntegerVector edge = face[1] - face[0];
  return dot(p - face[0], edge) >= 0 && dot(face[1] - p, edge) >= 0;
}

/// Where the segment from p to q, in the plane of A, passes through the one from r to s, in that of B, in inner points
/// of both.
std::optional<HomogeneousVector> crossing(const IntegerVector& p, const IntegerVector& q, const IntegerVector& r,
                                          const IntegerVector& s, const Turn& turn) {
  const WideInteger of_p = turn(r, s, p), of_q = turn(r, s, q);
  if (of_p.sign() * of_q.sign() >= 0) return {};
  if (turn(p, q, r).sign() * turn(p, q, s).sign() >= 0) return {};
  const WideInteger share_p = abs(of_q), share_q = abs(of_p);
  return HomogeneousVector{share_p * p + share_q * q, share_p + share_q};
}

bool less(const HomogeneousVector& p, const HomogeneousVector& q) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const WideInteger own = p.numerator[axis] * q.denominator, other = q.numerator[axis] * p.denominator;
    if (own != other) return own < other;
  }
  return false;
}

/// Keeps the least of what it is shown.
struct Least {
  std::optional<HomogeneousVector> found;

  void consider(const HomogeneousVector& point) {
    if (!found || less(point, *found)) found = point;
  }
};

}  // namespace

// The least common point is a corner of one face within the other, or lies where edges cross.
HomogeneousVector least_meeting_point(const ParallelFaces& faces) {
  if (faces.a.size() == 1) return {faces.a[0], 1};
  if (faces.b.size() == 1) return faces.b[0] + faces.difference;
  const PlaneView view(faces.normal);
  const Face a = face_of(faces.a, faces.normal, view), b = face_of(faces.b, faces.normal, view);
  if (a.size() == 1) return {a[0], 1};
  if (b.size() == 1) return b[0] + faces.difference;
  const Turn turn(faces.normal);
  Least least;
  for (const IntegerVector& corner : a)
    if (contains(b, corner, turn)) least.consider({corner, 1});
  for (const IntegerVector& corner : b)
    if (contains(a, corner, turn)) least.consider(corner + faces.difference);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      if (const auto cross = crossing(a[i], a[(i + 1) % a.size()], b[j], b[(j + 1) % b.size()], turn))
        least.consider(*cross);
  return *least.found;
}

}  // namespace toccata
