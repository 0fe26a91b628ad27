#include <algorithm>
#include <array>
#include <optional>

#include "narrow/triangles/triangle_features.hpp"
#include "toccata/math/predicates.hpp"
#include "toccata/narrow/triangle_triangle.hpp"

// Let A and B be the two convex hulls, of any dimension, and D = B − A, a polytope. A and B are disjoint exactly when
// D does not contain the origin. Let E be the space of directions in A and in B together, that is, in D.
//
// The six vertices span space. Then E has at least two dimensions: with one, both hulls would lie on parallel lines,
// hence in one plane.
//  - E is all of space: D has facets, and one of their planes keeps the origin strictly outside. A facet is the sum of
//    the parts of B and −A that are extreme in the direction of its normal; to have area, one part is a face (the
//    normal is that of A or of B) or both are edges that are not parallel (the normal is their cross product).
//  - E is a plane: D lies in a translate of it, which does not pass through the origin, since otherwise the six
//  vertices
//    would not span space. So a normal of E separates: it is the normal of A or of B if these have area, and otherwise
//    the cross product of two edges.
// In both cases one of the 2 + 9 axes separates strictly. The axis of a hull without area, or of parallel edges, is
// the zero vector; its signs are zero, which never separates.
//
// The six vertices span a plane. The same in two dimensions, seen along a coordinate axis that maps the plane one to
// one: E has at least one dimension, since two points span a line at most; a facet of D is an edge of A or of B; and if
// E is a line, D lies beside the origin and the edge's normal separates.
//
// The six vertices span a line or a point: order along a line is the lexicographic order of coordinates.

namespace toccata {
namespace {

bool strictly_one_side(std::initializer_list<Sign> signs) {
  const Sign first = *signs.begin();
  return first != Sign::zero && std::all_of(signs.begin(), signs.end(), [=](Sign s) { return s == first; });
}

bool normal_separates(const Triangle& t, const Triangle& other) {
  return strictly_one_side({orient3d(t[0], t[1], t[2], other[0]), orient3d(t[0], t[1], t[2], other[1]),
                            orient3d(t[0], t[1], t[2], other[2])});
}

/// Both ends of an edge have the same height along the axis, so one end and the opposite vertex stand for a triangle.
bool cross_product_separates(const Triangle& a, int i, const Triangle& b, int j) {
  const Difference edge_a{a[next_vertex(i)], a[i]}, edge_b{b[next_vertex(j)], b[j]};
  const auto height = [&](const Vec3& from_a, const Vec3& to_b) {
    return triple_product_sign({to_b, from_a}, edge_a, edge_b);
  };
  const Sign first = height(a[i], b[j]);
  const Vec3 &apex_a = a[next_vertex(next_vertex(i))], &apex_b = b[next_vertex(next_vertex(j))];
  return first != Sign::zero && height(apex_a, b[j]) == first && height(a[i], apex_b) == first &&
         height(apex_a, apex_b) == first;
}

bool separated_in_space(const Triangle& a, const Triangle& b) {
  if (normal_separates(a, b) || normal_separates(b, a)) return true;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (cross_product_separates(a, i, b, j)) return true;
  return false;
}

Sign turn_seen_along(int axis, const Vec3& p, const Vec3& q, const Vec3& r) {
  return orient2d(drop_axis(p, axis), drop_axis(q, axis), drop_axis(r, axis));
}

/// The line of edge i of `t` and its third vertex on one side, all of `other` strictly on the opposite side, or `t` on
/// the line itself.
bool edge_separates(int axis, const Triangle& t, int i, const Triangle& other) {
  const auto side = [&](const Vec3& v) { return turn_seen_along(axis, t[i], t[next_vertex(i)], v); };
  const Sign beyond = side(other[0]);
  return strictly_one_side({beyond, side(other[1]), side(other[2])}) && side(t[next_vertex(next_vertex(i))]) != beyond;
}

bool separated_in_plane(int axis, const Triangle& a, const Triangle& b) {
  for (int i = 0; i < 3; ++i)
    if (edge_separates(axis, a, i, b) || edge_separates(axis, b, i, a)) return true;
  return false;
}

bool separated_on_line(const Triangle& a, const Triangle& b) {
  const auto less = [](const Vec3& p, const Vec3& q) {
    return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
  };
  const auto [least_a, greatest_a] = std::minmax_element(a.vertex.begin(), a.vertex.end(), less);
  const auto [least_b, greatest_b] = std::minmax_element(b.vertex.begin(), b.vertex.end(), less);
  return less(*greatest_a, *least_b) || less(*greatest_b, *least_a);
}

/// What the six vertices span.
struct Span {
  int dimension = 0;  ///< 1 stands for a point too
  int axis = 0;       ///< of dimension 2: an axis along which the plane is seen one to one
};

Span span_of(const Triangle& a, const Triangle& b) {
  const std::array<Vec3, 6> v{a[0], a[1], a[2], b[0], b[1], b[2]};
  const auto second = std::find_if(v.begin(), v.end(), [&](const Vec3& p) { return p != v[0]; });
  if (second == v.end()) return {1, 0};
  for (const Vec3& third : v)
    for (int axis = 0; axis < 3; ++axis) {
      if (turn_seen_along(axis, v[0], *second, third) == Sign::zero) continue;
      const bool flat = std::all_of(v.begin(), v.end(),
                                    [&](const Vec3& p) { return orient3d(v[0], *second, third, p) == Sign::zero; });
      return flat ? Span{2, axis} : Span{3, 0};
    }
  return {1, 0};
}

}  // namespace

bool overlap_by_separating_axes(const Triangle& a, const Triangle& b) {
  const Span span = span_of(a, b);
  if (span.dimension == 3) return !separated_in_space(a, b);
  if (span.dimension == 2) return !separated_in_plane(span.axis, a, b);
  return !separated_on_line(a, b);
}

}  // namespace toccata
