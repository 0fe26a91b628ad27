#include "narrow/exact/exact_nearest.hpp"

#include <vector>

#include "narrow/exact/exact_simplex.hpp"
#include "narrow/exact/exact_support.hpp"
#include "narrow/triangles/face_intersection.hpp"

namespace toccata {
namespace {

/// The vertex pair lies before the plane through the simplex's nearest point, across its direction.
bool lies_before(const PosedPolytope& a, const PosedPolytope& b, const VertexPairs& pairs,
                 const IntegerVector& direction) {
  VertexPairs first_and_last;
  first_and_last.append(pairs.a[0], pairs.b[0]);
  first_and_last.append(pairs.a[pairs.size - 1], pairs.b[pairs.size - 1]);
  const IntegerSimplex both = integer_simplex(a, b, first_and_last);
  return dot(direction, both.point[1]) < dot(direction, both.point[0]);
}

/// The simplex after a step towards one more pair, or itself if that brings it no nearer.
VertexPairs after_step(const PosedPolytope& a, const PosedPolytope& b, const VertexPairs& simplex,
                       const IntegerVector& direction, Index vertex_a, Index vertex_b) {
  VertexPairs more = simplex;
  more.append(vertex_a, vertex_b);
  if (!lies_before(a, b, more, direction)) return simplex;
  return needed_pairs(integer_simplex(a, b, more));
}

IntegerVector direction_of(const PosedPolytope& a, const PosedPolytope& b, const VertexPairs& simplex) {
  return nearest_of(integer_simplex(a, b, simplex)).direction;
}

/// What of the given pairs is needed, which makes them independent too.
VertexPairs independent_part(const PosedPolytope& a, const PosedPolytope& b, const VertexPairs& start) {
  VertexPairs simplex;
  simplex.append(start.a[0], start.b[0]);
  for (std::size_t i = 1; i < start.size; ++i) {
    const IntegerVector direction = direction_of(a, b, simplex);
    if (is_zero(direction)) break;
    simplex = after_step(a, b, simplex, direction, start.a[i], start.b[i]);
  }
  return simplex;
}

/// A point of A, from the same weights as its difference from a point of B.
HomogeneousVector weighted_point(const IntegerSimplex& simplex, const SimplexNearest& nearest) {
  HomogeneousVector point{{}, nearest.total};
  for (std::size_t i = 0; i < simplex.pairs.size; ++i)
    point.numerator = point.numerator + nearest.weight[i] * simplex.a[i];
  return point;
}

HomogeneousVector weighted_difference(const IntegerSimplex& simplex, const SimplexNearest& nearest) {
  HomogeneousVector point{{}, nearest.total};
  for (std::size_t i = 0; i < simplex.pairs.size; ++i)
    point.numerator = point.numerator + nearest.weight[i] * simplex.point[i];
  return point;
}

ExactNearest intersection_of(const IntegerSimplex& simplex) {
  ExactNearest nearest;
  nearest.meet = true;
  nearest.exponent = simplex.exponent;
  nearest.on_a = weighted_point(simplex, nearest_of(simplex));
  nearest.on_b = nearest.on_a;
  nearest.squared_denominator = 1;
  nearest.simplex = simplex.pairs;
  return nearest;
}

}  // namespace

ExactNearest exact_nearest_of_faces(const PosedPolytope& a, const PosedPolytope& b, const VertexPairs& pairs,
                                    std::span<const Index> face_a, std::span<const Index> face_b) {
  std::vector<Vec3> vertices;
  for (const Index i : face_a) vertices.push_back(a.vertex(i));
  for (const Index i : face_b) vertices.push_back(b.vertex(i));
  const int exponent = common_exponent(vertices);
  const IntegerSimplex simplex = integer_simplex(a, b, pairs, exponent);
  const SimplexNearest weights = nearest_of(simplex);
  const HomogeneousVector difference = weighted_difference(simplex, weights);

  ExactNearest nearest;
  nearest.exponent = exponent;
  nearest.direction = weights.direction;
  nearest.squared_numerator = dot(difference.numerator, simplex.point[0]);
  nearest.squared_denominator = difference.denominator;
  nearest.simplex = pairs;
  ParallelFaces faces{{}, {}, weights.direction, difference};
  for (std::size_t i = 0; i < vertices.size(); ++i)
    (i < face_a.size() ? faces.a : faces.b).push_back(scaled_wide(vertices[i], exponent));
  nearest.on_a = least_meeting_point(faces);
  nearest.on_b = nearest.on_a - difference;
  return nearest;
}

ExactNearest exact_nearest(const PosedPolytope& a, const PosedPolytope& b, const VertexPairs& start) {
  VertexPairs simplex = independent_part(a, b, start);
  while (true) {
    const IntegerVector direction = direction_of(a, b, simplex);
    if (is_zero(direction)) return intersection_of(integer_simplex(a, b, simplex));
    const std::vector<Index> face_a = least_vertices(a, direction);
    const std::vector<Index> face_b = least_vertices(b, -direction);
    VertexPairs more = simplex;
    more.append(face_a.front(), face_b.front());
    if (!lies_before(a, b, more, direction)) return exact_nearest_of_faces(a, b, simplex, face_a, face_b);
    simplex = needed_pairs(integer_simplex(a, b, more));
  }
}

}  // namespace toccata
