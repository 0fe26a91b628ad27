#include "narrow/triangles/intersection_from_points.hpp"

#include <algorithm>

namespace toccata {
namespace {

constexpr bool is_edge_or_less(unsigned set) { return set != 7U; }

/// An edge of a triangle is a face of it, so what an intersection has in common with an edge is one point or one side
/// of the meeting: two extreme points on one edge are always neighbours, and every side lies on an edge of a or of b.
bool are_neighbours(const IntersectionPoint& p, const IntersectionPoint& q) {
  return is_edge_or_less(vertex_set(p.on_a) | vertex_set(q.on_a)) ||
         is_edge_or_less(vertex_set(p.on_b) | vertex_set(q.on_b));
}

/// Walks around the polygon from its least point towards the lesser of the two neighbours.
void order_around(std::span<IntersectionPoint> points) {
  std::sort(points.begin(), points.end());
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const IntersectionPoint& last = points[i - 1];
    // The rest is kept sorted, so the least neighbour comes first.
    const auto next = std::find_if(points.begin() + static_cast<std::ptrdiff_t>(i), points.end(),
                                   [&](const IntersectionPoint& p) { return are_neighbours(last, p); });
    if (next != points.end()) std::rotate(points.begin() + static_cast<std::ptrdiff_t>(i), next, next + 1);
  }
}

IntersectionKind kind_of(std::size_t count) {
  return count == 0   ? IntersectionKind::none
         : count == 1 ? IntersectionKind::point
         : count == 2 ? IntersectionKind::segment
                      : IntersectionKind::polygon;
}

}  // namespace

Intersection intersection_from_points(std::span<const IntersectionPoint> points, const IntersectionFrame& frame) {
  Intersection m;
  m.kind = kind_of(points.size());
  m.coplanar = frame.coplanar;
  if (points.empty()) return m;
  m.count = static_cast<std::uint8_t>(points.size());
  std::copy(points.begin(), points.end(), m.points.begin());
  order_around(std::span(m.points).first(m.count));
  unsigned in_a = 0, in_b = 0;
  for (const IntersectionPoint& p : points) {
    in_a |= vertex_set(p.on_a);
    in_b |= vertex_set(p.on_b);
  }
  m.on_a = feature_of_vertices(in_a);
  m.on_b = feature_of_vertices(in_b);
  // The relative interior of the meeting lies in those of on_a and on_b.
  m.crossing = !m.coplanar && m.on_a == frame.whole_a && m.on_b == frame.whole_b;
  return m;
}

Intersection flipped(const Intersection& m) {
  Intersection f = m;
  std::swap(f.on_a, f.on_b);
  const std::span<IntersectionPoint> points = std::span(f.points).first(f.count);
  for (IntersectionPoint& p : points) std::swap(p.on_a, p.on_b);
  order_around(points);
  return f;
}

}  // namespace toccata
