#include "query/relation/relation_segments.hpp"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "query/inside/enclose.hpp"
#include "query/inside/inside_point.hpp"

namespace toccata {
namespace {

PlanarPoint planar_point(const RationalPoint2& p) { return {ExactNumber(p.x), ExactNumber(p.y)}; }
PlanarPoint planar_point(const Vec2& p) { return {ExactNumber(p.x), ExactNumber(p.y)}; }

bool operator==(const PlanarPoint& p, const PlanarPoint& q) { return p.x == q.x && p.y == q.y; }
bool operator<(const PlanarPoint& p, const PlanarPoint& q) { return p.x < q.x || (p.x == q.x && p.y < q.y); }

PlanarSegment planar_segment(PlanarPoint p, PlanarPoint q) {
  if (q < p) std::swap(p, q);
  return {std::move(p), std::move(q)};
}

PlanarSegment projected_segment(const Vec3& p, const Vec3& q, int axis) {
  return planar_segment(planar_point(drop_axis(p, axis)), planar_point(drop_axis(q, axis)));
}

RationalPoint2 exact(const PlanarPoint& p) { return {p.x.exact(), p.y.exact()}; }

bool is_double(const PlanarPoint& p) { return p.x.is_double() && p.y.is_double(); }
Vec2 rounded_place(const PlanarPoint& p) { return {p.x.around().lower, p.y.around().lower}; }

/// On which side of the line from s.left to s.right the point lies: positive is above.
Sign side_of(const PlanarSegment& s, const PlanarPoint& p) {
  if (is_double(s.left) && is_double(s.right) && is_double(p))
    return orient2d(rounded_place(s.left), rounded_place(s.right), rounded_place(p));
  const Interval ux = s.right.x.around() - s.left.x.around(), uy = s.right.y.around() - s.left.y.around();
  const Interval vx = p.x.around() - s.left.x.around(), vy = p.y.around() - s.left.y.around();
  const Interval filter = ux * vy - uy * vx;
  if (certainly_positive(filter)) return Sign::positive;
  if (certainly_negative(filter)) return Sign::negative;
  return orient2d(exact(s.left), exact(s.right), exact(p));
}

/// How far the point lies above the line of s, times a positive number that is the same for all points.
Rational scaled_height(const PlanarSegment& s, const PlanarPoint& p) {
  return (s.right.x.exact() - s.left.x.exact()) * (p.y.exact() - s.left.y.exact()) -
         (s.right.y.exact() - s.left.y.exact()) * (p.x.exact() - s.left.x.exact());
}

/// Where the lines of the two cross, the ends of `other` being on different sides of s.
ExactNumber crossing_of(const PlanarSegment& s, const PlanarSegment& other) {
  const Rational left = scaled_height(s, other.left), right = scaled_height(s, other.right);
  const Rational &from = other.left.x.exact(), &to = other.right.x.exact();
  return ExactNumber(Rational(from + (to - from) * left / (left - right)));
}

/// Where the edge a → b crosses the plane of `t`, in the projection; the ends lie strictly on different sides.
PlanarPoint plane_crossing(const Triangle& t, const Vec3& a, const Vec3& b, int axis) {
  const RationalPoint origin = to_rational(t[0]), from = to_rational(a), to = to_rational(b);
  const RationalPoint normal = cross(to_rational(t[1]) - origin, to_rational(t[2]) - origin);
  const Rational height_from = dot(normal, from - origin), height_to = dot(normal, to - origin);
  return planar_point(drop_axis(from + Rational(height_from / (height_from - height_to)) * (to - from), axis));
}

using VertexSides = std::array<Sign, 3>;

VertexSides sides_of_plane(const Triangle& t, const Triangle& other) {
  const auto side = [&](int vertex) { return orient3d(t[0], t[1], t[2], other[vertex]); };
  return {side(0), side(1), side(2)};
}

bool is_coplanar(const VertexSides& side) { return side == VertexSides{Sign::zero, Sign::zero, Sign::zero}; }

/// The segment in which a triangle that is not coplanar cuts the plane of `t`, if it is one.
void add_plane_cut(const Triangle& t, const Triangle& cut, const VertexSides& side, int axis,
                   std::vector<PlanarSegment>& segments) {
  std::vector<PlanarPoint> ends;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const Sign from = side[static_cast<std::size_t>(i)], to = side[static_cast<std::size_t>(j)];
    if (from == Sign::zero) ends.push_back(planar_point(drop_axis(cut[i], axis)));
    if (from * to == Sign::negative) ends.push_back(plane_crossing(t, cut[i], cut[j], axis));
  }
  if (ends.size() == 2 && !(ends[0] == ends[1])) segments.push_back(planar_segment(ends[0], ends[1]));
}

/// An edge of a coplanar triangle, `from` lexicographically before `to`, and on which side the triangle lies.
struct CoplanarEdge {
  Vec3 from;
  Vec3 to;
  Sign side;

  [[nodiscard]] auto key() const { return std::tie(from.x, from.y, from.z, to.x, to.y, to.z); }
  [[nodiscard]] bool has_ends_of(const CoplanarEdge& other) const { return key() == other.key(); }
};

void add_edges(const Triangle& t, int axis, std::vector<CoplanarEdge>& edges) {
  const Sign orientation = projected_orientation(t, axis);
  for (int i = 0; i < 3; ++i) {
    const Vec3 &p = t[i], &q = t[(i + 1) % 3];
    if (lexicographically_less(p, q))
      edges.push_back({p, q, orientation});
    else
      edges.push_back({q, p, -orientation});
  }
}

/// Both ends lie on or beyond the line of one edge of `t`, so that the segment does not enter its interior.
bool stays_outside(const Triangle& t, const Vec3& p, const Vec3& q, int axis) {
  const Sign orientation = projected_orientation(t, axis);
  const auto is_beyond = [&](const Vec3& point, int edge) {
    const Vec2 from = drop_axis(t[edge], axis), to = drop_axis(t[(edge + 1) % 3], axis);
    return orient2d(from, to, drop_axis(point, axis)) * orientation != Sign::positive;
  };
  for (int edge = 0; edge < 3; ++edge)
    if (is_beyond(p, edge) && is_beyond(q, edge)) return true;
  return false;
}

/// Adds those edges of coplanar triangles that bound what the triangles cover, each once.
void add_outlines(const Triangle& t, std::vector<CoplanarEdge> edges, int axis, std::vector<PlanarSegment>& segments) {
  std::sort(edges.begin(), edges.end(), [](const CoplanarEdge& d, const CoplanarEdge& e) { return d.key() < e.key(); });
  for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
    while (last < edges.size() && edges[last].has_ends_of(edges[first])) ++last;
    const bool covered_on_both_sides = last - first == 2 && edges[first].side * edges[first + 1].side == Sign::negative;
    if (covered_on_both_sides || stays_outside(t, edges[first].from, edges[first].to, axis)) continue;
    segments.push_back(projected_segment(edges[first].from, edges[first].to, axis));
  }
}

/// Drops all but one of equal segments, from the third on.
void keep_different(std::vector<PlanarSegment>& segments) {
  const auto before = [](const PlanarSegment& s, const PlanarSegment& other) {
    return s.left < other.left || (s.left == other.left && s.right < other.right);
  };
  const auto equal = [](const PlanarSegment& s, const PlanarSegment& other) {
    return s.left == other.left && s.right == other.right;
  };
  std::sort(segments.begin() + 3, segments.end(), before);
  segments.erase(std::unique(segments.begin() + 3, segments.end(), equal), segments.end());
}

}  // namespace

ExactNumber::ExactNumber(Rational value) : exact_(std::move(value)), around_(enclose(exact_)) {}

bool operator<(const ExactNumber& a, const ExactNumber& b) {
  if (certainly_less(a.around(), b.around())) return true;
  if (a.around().lower >= b.around().upper) return false;
  return a.exact() < b.exact();
}

bool operator==(const ExactNumber& a, const ExactNumber& b) {
  if (certainly_less(a.around(), b.around()) || certainly_less(b.around(), a.around())) return false;
  return (a.is_double() && b.is_double()) || a.exact() == b.exact();
}

std::vector<PlanarSegment> segments_on(const Triangle& t, std::span<const Triangle> cuts, int axis) {
  std::vector<PlanarSegment> segments;
  for (int i = 0; i < 3; ++i) segments.push_back(projected_segment(t[i], t[(i + 1) % 3], axis));
  std::vector<CoplanarEdge> coplanar;
  for (const Triangle& cut : cuts) {
    const VertexSides side = sides_of_plane(t, cut);
    if (is_coplanar(side))
      add_edges(cut, axis, coplanar);
    else
      add_plane_cut(t, cut, side, axis, segments);
  }
  add_outlines(t, std::move(coplanar), axis, segments);
  keep_different(segments);
  return segments;
}

Rational height_at(const PlanarSegment& s, const ExactNumber& x) {
  const Rational &x0 = s.left.x.exact(), &y0 = s.left.y.exact(), &x1 = s.right.x.exact(), &y1 = s.right.y.exact();
  return y0 + (y1 - y0) * (x.exact() - x0) / (x1 - x0);
}

Interval approximate_height_at(const PlanarSegment& s, const Interval& x) {
  const Interval &x0 = s.left.x.around(), &y0 = s.left.y.around(), &x1 = s.right.x.around(), &y1 = s.right.y.around();
  return y0 + (y1 - y0) * (x - x0) / (x1 - x0);
}

void add_intersection(const PlanarSegment& s, const PlanarSegment& other, std::vector<ExactNumber>& ends) {
  if (!(s.left.x < other.right.x && other.left.x < s.right.x)) return;  // they meet at most in an end of s
  const auto add = [&](const ExactNumber& x) {
    if (s.left.x < x && x < s.right.x) ends.push_back(x);
  };
  const Sign left = side_of(s, other.left), right = side_of(s, other.right);
  // Segments on one line need no cut: their pieces overlap or border on one another.
  if (left == right) return;
  if (left == Sign::zero) return add(other.left.x);
  if (right == Sign::zero) return add(other.right.x);
  if (side_of(other, s.left) * side_of(other, s.right) == Sign::negative) add(crossing_of(s, other));
}

}  // namespace toccata
