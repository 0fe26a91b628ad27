#include "narrow/triangles/feature_intersection.hpp"

#include <algorithm>

#include "narrow/triangles/incidence.hpp"
#include "narrow/triangles/intersection_from_points.hpp"
#include "narrow/triangles/triangle_features.hpp"

// Let x be a point of A ∩ B, and f, g the features of A and B that have x in their relative interiors. Then x is an
// extreme point of A ∩ B exactly when the relative interiors of f and g have only x in common. If they have more in
// common, x lies inside a segment of A ∩ B. If a segment of A ∩ B had x inside, it would lie in f and in g, because
// these are faces of A and B, and near x in both relative interiors. So the extreme points are found by asking every
// pair of features whether their relative interiors meet in a single point. Two open faces never do.

namespace toccata {
namespace {

bool vertex_meets(const Vec3& x, const Triangle& t, const Feature& f) {
  switch (f.kind) {
    case FeatureKind::vertex:
      return x == t[f.index];
    case FeatureKind::edge:
      return in_open_segment(x, edge_start(t, f.index), edge_end(t, f.index));
    case FeatureKind::face:
      break;
  }
  return in_open_triangle(x, t);
}

/// `g` is not of a lower kind than `f`.
bool meet_in_one_point(const Triangle& a, const Feature& f, const Triangle& b, const Feature& g) {
  if (f.kind == FeatureKind::vertex) return vertex_meets(a[f.index], b, g);
  if (f.kind == FeatureKind::face) return false;
  const Vec3 &start = edge_start(a, f.index), &end = edge_end(a, f.index);
  if (g.kind == FeatureKind::face) return open_segment_pierces(start, end, b);
  return open_segments_cross(start, end, edge_start(b, g.index), edge_end(b, g.index));
}

bool is_extreme(const Triangle& a, const Triangle& b, const IntersectionPoint& p) {
  return p.on_a.kind <= p.on_b.kind ? meet_in_one_point(a, p.on_a, b, p.on_b) : meet_in_one_point(b, p.on_b, a, p.on_a);
}

/// Any six points with at most two distinct ones on each side are coplanar unless these are four corners of a solid.
bool all_coplanar(const Triangle& a, const TriangleFeatures& of_a, const Triangle& b, const TriangleFeatures& of_b) {
  const auto in_plane_of = [](const Triangle& plane, const Triangle& t) {
    return std::all_of(t.vertex.begin(), t.vertex.end(),
                       [&](const Vec3& v) { return orient3d(plane[0], plane[1], plane[2], v) == Sign::zero; });
  };
  if (of_a.whole().kind == FeatureKind::face) return in_plane_of(a, b);
  if (of_b.whole().kind == FeatureKind::face) return in_plane_of(b, a);
  if (of_a.count == 1 || of_b.count == 1) return true;
  return orient3d(a[of_a.feature[0].index], a[of_a.feature[1].index], b[of_b.feature[0].index],
                  b[of_b.feature[1].index]) == Sign::zero;
}

}  // namespace

Intersection feature_intersection(const Triangle& a, const Triangle& b) {
  const TriangleFeatures of_a = features_of(a), of_b = features_of(b);
  std::array<IntersectionPoint, 6> points{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < of_a.count; ++i)
    for (std::size_t j = 0; j < of_b.count; ++j) {
      const IntersectionPoint candidate{of_a.feature[i], of_b.feature[j]};
      if (is_extreme(a, b, candidate)) points[count++] = candidate;
    }
  return intersection_from_points(std::span(points).first(count),
                                  {all_coplanar(a, of_a, b, of_b), of_a.whole(), of_b.whole()});
}

bool features_overlap(const Triangle& a, const Triangle& b) {
  const TriangleFeatures of_a = features_of(a), of_b = features_of(b);
  for (std::size_t i = 0; i < of_a.count; ++i)
    for (std::size_t j = 0; j < of_b.count; ++j)
      if (is_extreme(a, b, {of_a.feature[i], of_b.feature[j]})) return true;
  return false;
}

}  // namespace toccata
