#include "oracle/motion.hpp"

#include <algorithm>

// Two features meet when the origin lies among the differences of their points. These are a triangle, face − vertex, or
// a parallelogram, edge − edge, which is two triangles, whatever its shape. So all questions are one: when does a
// triangle whose corners move linearly first contain the origin?
//
// It contains the origin when a corner is the origin, or the origin lies between two corners, or in the relative
// interior of a triangle with area or on its edges (Carathéodory). Each of these is told by signs of polynomials in the
// time. Between two neighbouring roots of all these polynomials every sign stays the same, and the contact with it; and
// the times of contact are a closed set. So the first of them is 0 or a root.
namespace toccata::oracle {
namespace {

using MovingTriangle = std::array<PolynomialVector, 3>;

bool is_zero_at(const PolynomialVector& v, const AlgebraicNumber& t) {
  return sign_at(v[0], t) == 0 && sign_at(v[1], t) == 0 && sign_at(v[2], t) == 0;
}

PolynomialVector normal_of(const MovingTriangle& q) { return cross(q[1] - q[0], q[2] - q[0]); }

/// Six times the signed volume of the triangle and the origin.
Polynomial volume_of(const MovingTriangle& q) { return dot(q[0], cross(q[1], q[2])); }

/// On which side of the edge from corner i the origin is, as seen along the normal, once it lies in the plane.
Polynomial side_of(const MovingTriangle& q, std::size_t i) { return dot(cross(q[i], q[(i + 1) % 3]), normal_of(q)); }

bool origin_between(const PolynomialVector& p, const PolynomialVector& q, const AlgebraicNumber& t) {
  return is_zero_at(cross(p, q), t) && sign_at(dot(p, q), t) <= 0;
}

bool origin_in_proper_triangle(const MovingTriangle& q, const AlgebraicNumber& t) {
  if (sign_at(volume_of(q), t) != 0 || is_zero_at(normal_of(q), t)) return false;
  for (std::size_t i = 0; i < 3; ++i)
    if (sign_at(side_of(q, i), t) < 0) return false;
  return true;
}

bool contains_origin(const MovingTriangle& q, const AlgebraicNumber& t) {
  for (std::size_t i = 0; i < 3; ++i)
    if (is_zero_at(q[i], t) || origin_between(q[i], q[(i + 1) % 3], t)) return true;
  return origin_in_proper_triangle(q, t);
}

/// Polynomials such that the first contact, if it is not at 0, is a root of one of them that is not zero everywhere.
std::vector<Polynomial> telling_polynomials(const MovingTriangle& q) {
  // The origin lies in the plane of every triangle that contains it.
  if (!volume_of(q).is_zero()) return {volume_of(q)};
  std::vector<Polynomial> all;
  const auto add = [&](const PolynomialVector& v) { all.insert(all.end(), v.begin(), v.end()); };
  add(normal_of(q));
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    add(q[i]);
    add(cross(q[i], q[next]));
    all.push_back(dot(q[i], q[next]));
    all.push_back(side_of(q, i));
  }
  return all;
}

/// Each polynomial that is not zero once, whatever number it is multiplied by.
std::vector<Polynomial> different(const std::vector<Polynomial>& all) {
  std::vector<Polynomial> found;
  for (const Polynomial& polynomial : all) {
    if (polynomial.is_zero()) continue;
    Polynomial one = primitive(polynomial.leading().sign() < 0 ? -polynomial : polynomial);
    const auto is_one = [&](const Polynomial& other) { return other.coefficients() == one.coefficients(); };
    if (std::none_of(found.begin(), found.end(), is_one)) found.push_back(std::move(one));
  }
  return found;
}

std::optional<AlgebraicNumber> contact_time(const MovingTriangle& q) {
  if (contains_origin(q, algebraic(0))) return algebraic(0);
  std::optional<AlgebraicNumber> first;
  for (const Polynomial& polynomial : different(telling_polynomials(q))) {
    for (const AlgebraicNumber& root : roots_in_unit_interval(polynomial)) {
      // The later ones are no less either.
      if (first && !(root < *first)) break;
      if (!contains_origin(q, root)) continue;
      first = root;
      break;
    }
  }
  return first;
}

/// The difference of two moving points, (1 − t) · start + t · end.
PolynomialVector difference(const MovingPoint& a, const MovingPoint& b) {
  const RationalPoint start = exact(a.start) - exact(b.start), end = exact(a.end) - exact(b.end);
  const auto moving = [](const Rational& from, const Rational& to) { return Polynomial({from, to - from}); };
  return {moving(start.x, end.x), moving(start.y, end.y), moving(start.z, end.z)};
}

std::vector<MovingTriangle> differences(const VertexFace& pair) {
  MovingTriangle triangle;
  for (std::size_t i = 0; i < 3; ++i) triangle[i] = difference(pair.face[i], pair.vertex);
  return {triangle};
}

std::vector<MovingTriangle> differences(const EdgeEdge& pair) {
  const auto corner = [&](std::size_t i, std::size_t j) { return difference(pair.a[i], pair.b[j]); };
  return {{corner(0, 0), corner(1, 0), corner(1, 1)}, {corner(0, 0), corner(1, 1), corner(0, 1)}};
}

template <class Pair>
std::optional<AlgebraicNumber> contact_time_of(const Pair& pair) {
  std::optional<AlgebraicNumber> first;
  for (const MovingTriangle& triangle : differences(pair)) {
    const std::optional<AlgebraicNumber> contact = contact_time(triangle);
    if (contact && (!first || *contact < *first)) first = contact;
  }
  return first;
}

template <class Pair>
bool pair_meets_at(const Pair& pair, const AlgebraicNumber& time) {
  const std::vector<MovingTriangle> triangles = differences(pair);
  return std::any_of(triangles.begin(), triangles.end(), [&](const auto& q) { return contains_origin(q, time); });
}

}  // namespace

std::optional<AlgebraicNumber> contact_time(const VertexFace& pair) { return contact_time_of(pair); }
std::optional<AlgebraicNumber> contact_time(const EdgeEdge& pair) { return contact_time_of(pair); }
bool meet_at(const VertexFace& pair, const AlgebraicNumber& time) { return pair_meets_at(pair, time); }
bool meet_at(const EdgeEdge& pair, const AlgebraicNumber& time) { return pair_meets_at(pair, time); }

}  // namespace toccata::oracle
