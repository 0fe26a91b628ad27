#include "narrow/triangles/plane_intervals.hpp"

namespace toccata {
namespace {

/// The point in which the edge from vertex i to the next, whose signs are opposite, crosses the plane.
IntervalEnd edge_end_of(const Triangle& t, const PlaneSides& sides, int i) {
  const Vec3 &from = edge_start(t, i), &to = edge_end(t, i);
  return sides[i] == Sign::negative ? IntervalEnd{edge_feature(i), &from, &to}
                                    : IntervalEnd{edge_feature(i), &to, &from};
}

/// Vertex i, whose sign is zero; `off` is a vertex whose sign is not.
IntervalEnd vertex_end_of(const Triangle& t, const PlaneSides& sides, int i, int off) {
  return sides[off] == Sign::positive ? IntervalEnd{vertex_feature(i), &t[i], &t[off]}
                                      : IntervalEnd{vertex_feature(i), &t[off], &t[i]};
}

/// Vertices `alone` and after lie on both sides, none in the plane; `alone` is the one without company.
PlaneInterval through_two_edges(const Triangle& t, const PlaneSides& sides, int alone) {
  const IntervalEnd in = edge_end_of(t, sides, previous_vertex(alone)), out = edge_end_of(t, sides, alone);
  // Around the triangle, interior on the left, the boundary rises through the plane where the interval starts.
  return sides[alone] == Sign::positive ? PlaneInterval{in, out, face_feature()}
                                        : PlaneInterval{out, in, face_feature()};
}

/// Only vertex i lies in the plane.
PlaneInterval through_one_vertex(const Triangle& t, const PlaneSides& sides, int i) {
  const IntervalEnd at_vertex = vertex_end_of(t, sides, i, next_vertex(i));
  if (sides[next_vertex(i)] == sides[previous_vertex(i)]) return {at_vertex, at_vertex, vertex_feature(i)};
  const IntervalEnd at_edge = edge_end_of(t, sides, next_vertex(i));
  return sides[next_vertex(i)] == Sign::positive ? PlaneInterval{at_vertex, at_edge, face_feature()}
                                                 : PlaneInterval{at_edge, at_vertex, face_feature()};
}

/// Only vertex `off` does not lie in the plane.
PlaneInterval along_edge(const Triangle& t, const PlaneSides& sides, int off) {
  const int i = next_vertex(off), j = previous_vertex(off);
  const IntervalEnd first = vertex_end_of(t, sides, i, off), second = vertex_end_of(t, sides, j, off);
  return sides[off] == Sign::negative ? PlaneInterval{first, second, edge_feature(i)}
                                      : PlaneInterval{second, first, edge_feature(i)};
}

}  // namespace

PlaneInterval plane_interval(const Triangle& t, const PlaneSides& sides) {
  int zeros = 0, zero = 0, other = 0;
  for (int i = 0; i < 3; ++i) {
    (sides[i] == Sign::zero ? zero : other) = i;
    zeros += sides[i] == Sign::zero ? 1 : 0;
  }
  if (zeros == 2) return along_edge(t, sides, other);
  if (zeros == 1) return through_one_vertex(t, sides, zero);
  const int alone = sides[0] == sides[1] ? 2 : sides[1] == sides[2] ? 0 : 1;
  return through_two_edges(t, sides, alone);
}

}  // namespace toccata
