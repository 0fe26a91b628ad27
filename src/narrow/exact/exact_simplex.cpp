#include "narrow/exact/exact_simplex.hpp"

#include "narrow/convex/gjk_simplex.hpp"

namespace toccata {
namespace {

SimplexNearest nearest_of_segment(const IntegerVector& p, const IntegerVector& q) {
  const IntegerVector along = q - p;
  SimplexNearest nearest;
  nearest.weight[0] = dot(q, along);
  nearest.weight[1] = -dot(p, along);
  nearest.total = dot(along, along);
  nearest.direction = nearest.weight[0] * p + nearest.weight[1] * q;
  return nearest;
}

SimplexNearest nearest_of_triangle(const IntegerVector& p, const IntegerVector& q, const IntegerVector& r) {
  const IntegerVector normal = cross(q - p, r - p);
  SimplexNearest nearest;
  nearest.weight[0] = dot(cross(q, r), normal);
  nearest.weight[1] = dot(cross(r, p), normal);
  nearest.weight[2] = dot(cross(p, q), normal);
  nearest.total = dot(normal, normal);
  nearest.direction = WideInteger(dot(normal, p).sign()) * normal;
  return nearest;
}

/// The affine hull is all of space, so the point is the origin.
SimplexNearest nearest_of_tetrahedron(const std::array<IntegerVector, 4>& p) {
  const auto volume = [&](std::size_t i, std::size_t j, std::size_t k) { return dot(cross(p[i], p[j]), p[k]); };
  SimplexNearest nearest;
  nearest.weight = {volume(1, 2, 3), -volume(0, 2, 3), volume(0, 1, 3), -volume(0, 1, 2)};
  nearest.total = nearest.weight[0] + nearest.weight[1] + nearest.weight[2] + nearest.weight[3];
  if (nearest.total < 0) {
    for (WideInteger& weight : nearest.weight) weight = -weight;
    nearest.total = -nearest.total;
  }
  return nearest;
}

/// The pairs whose bits are set.
IntegerSimplex face_of(const IntegerSimplex& simplex, unsigned bits) {
  IntegerSimplex face;
  face.exponent = simplex.exponent;
  for (std::size_t i = 0; i < simplex.pairs.size; ++i) {
    if ((bits >> i & 1U) == 0) continue;
    const std::size_t at = face.pairs.size;
    face.pairs.append(simplex.pairs.a[i], simplex.pairs.b[i]);
    face.a[at] = simplex.a[i];
    face.point[at] = simplex.point[i];
  }
  return face;
}

/// No point of the simplex lies before the plane through the face's nearest point, and that point is within the face.
bool is_witness(const IntegerSimplex& simplex, const IntegerSimplex& face) {
  const SimplexNearest nearest = nearest_of(face);
  for (std::size_t i = 0; i < face.pairs.size; ++i)
    if (nearest.weight[i] <= 0) return false;
  const WideInteger height = dot(nearest.direction, face.point[0]);
  for (std::size_t i = 0; i < simplex.pairs.size; ++i)
    if (dot(nearest.direction, simplex.point[i]) < height) return false;
  return true;
}

/// What the search in doubles would keep, as bits.
unsigned likely_face(const IntegerSimplex& simplex) {
  GjkSimplex rounded;
  for (std::size_t i = 0; i < simplex.pairs.size; ++i) rounded.append(0, 0, simplex.rounded_point[i]);
  return nearest_face(rounded).kept;
}

}  // namespace

IntegerSimplex integer_simplex(const PosedPolytope& a, const PosedPolytope& b, const VertexPairs& pairs) {
  std::array<Vec3, 8> vertices;
  for (std::size_t i = 0; i < pairs.size; ++i) {
    vertices[2 * i] = a.vertex(pairs.a[i]);
    vertices[2 * i + 1] = b.vertex(pairs.b[i]);
  }
  return integer_simplex(a, b, pairs, common_exponent({vertices.data(), 2 * pairs.size}));
}

IntegerSimplex integer_simplex(const PosedPolytope& a, const PosedPolytope& b, const VertexPairs& pairs, int exponent) {
  IntegerSimplex simplex;
  simplex.pairs = pairs;
  simplex.exponent = exponent;
  for (std::size_t i = 0; i < pairs.size; ++i) {
    simplex.a[i] = scaled_wide(a.vertex(pairs.a[i]), exponent);
    simplex.point[i] = simplex.a[i] - scaled_wide(b.vertex(pairs.b[i]), exponent);
    simplex.rounded_point[i] = a.vertex(pairs.a[i]) - b.vertex(pairs.b[i]);
  }
  return simplex;
}

SimplexNearest nearest_of(const IntegerSimplex& simplex) {
  const auto& p = simplex.point;
  switch (simplex.pairs.size) {
    case 1:
      return {{1}, 1, p[0]};
    case 2:
      return nearest_of_segment(p[0], p[1]);
    case 3:
      return nearest_of_triangle(p[0], p[1], p[2]);
    default:
      return nearest_of_tetrahedron(p);
  }
}

VertexPairs needed_pairs(const IntegerSimplex& simplex) {
  const unsigned last = 1U << (simplex.pairs.size - 1);
  const unsigned likely = likely_face(simplex);
  if (const IntegerSimplex face = face_of(simplex, likely); is_witness(simplex, face)) return face.pairs;
  for (unsigned others = 0; others < last - 1; ++others) {
    if ((others | last) == likely) continue;
    const IntegerSimplex face = face_of(simplex, others | last);
    if (is_witness(simplex, face)) return face.pairs;
  }
  return simplex.pairs;
}

}  // namespace toccata
