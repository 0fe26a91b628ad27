#include <algorithm>
#include <array>
#include <optional>
#include <type_traits>
#include <vector>

#include "math/exact.hpp"
#include "narrow/primitives/closed_forms.hpp"
#include "toccata/methods/sphere_ways.hpp"

// Each way is written once, for any kind of number: in doubles it makes a guess, which is proved or not; in rationals
// it is exact.
namespace toccata {
namespace {

template <class Number>
struct Vector {
  Number x, y, z;

  friend Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vector operator*(const Number& s, const Vector& a) { return {s * a.x, s * a.y, s * a.z}; }
};

template <class Number>
Number dot(const Vector<Number>& a, const Vector<Number>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Number>
Vector<Number> cross(const Vector<Number>& a, const Vector<Number>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The vertices relative to the sphere's centre, and what several ways need of them.
template <class Number>
struct Corners {
  std::array<Vector<Number>, 3> v;

  [[nodiscard]] const Vector<Number>& at(std::size_t i) const { return v[i % 3]; }
  [[nodiscard]] Vector<Number> edge(std::size_t i) const { return at(i + 1) - at(i); }
  [[nodiscard]] Vector<Number> normal() const { return cross(edge(0), v[2] - v[0]); }
};

template <class Number>
using Way = Vector<Number> (*)(const Corners<Number>&);

template <class Number>
bool is_nearer(const Vector<Number>& a, const Vector<Number>& b) {
  return dot(a, a) < dot(b, b);
}

/// The nearest to the origin of a segment's points.
template <class Number>
Vector<Number> nearest_of_segment(const Vector<Number>& from, const Vector<Number>& edge) {
  const Number along = -dot(from, edge), length_squared = dot(edge, edge);
  if (!(along > 0)) return from;
  if (!(along < length_squared)) return from + edge;
  return from + Number(along / length_squared) * edge;
}

template <class Number>
Vector<Number> nearest_of_edges(const Corners<Number>& t) {
  Vector<Number> best = nearest_of_segment(t.v[0], t.edge(0));
  for (std::size_t i = 1; i < 3; ++i) {
    const Vector<Number> next = nearest_of_segment(t.v[i], t.edge(i));
    if (is_nearer(next, best)) best = next;
  }
  return best;
}

// --- the plane, then two dimensions

/// A point of the plane by two coordinates along orthogonal vectors, u and normal × u, which are not unit: lengths are
/// weighed by their squares.
template <class Number>
struct InPlane {
  Number x, y;
};

template <class Number>
Vector<Number> by_plane_projection(const Corners<Number>& t) {
  const Vector<Number> normal = t.normal(), u = t.edge(0), w = cross(normal, u);
  const Number normal_squared = dot(normal, normal), uu = dot(u, u), ww = dot(w, w);
  if (!(normal_squared > 0 && ww > 0)) return nearest_of_edges(t);
  Vector<Number> foot = Number(dot(normal, t.v[0]) / normal_squared) * normal;
  const auto flat = [&](const Vector<Number>& p) {
    return InPlane<Number>{dot(p - foot, u) / uu, dot(p - foot, w) / ww};
  };
  const auto product = [&](const InPlane<Number>& p, const InPlane<Number>& q) {
    return Number(p.x * q.x * uu + p.y * q.y * ww);
  };
  const std::array<InPlane<Number>, 3> corner = {flat(t.v[0]), flat(t.v[1]), flat(t.v[2])};
  std::optional<InPlane<Number>> best;
  bool inside = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const InPlane<Number>&p = corner[i], &q = corner[(i + 1) % 3];
    inside = inside && !(p.x * q.y - p.y * q.x < 0);  // they turn counter-clockwise: w is u turned to the left
    const InPlane<Number> edge{q.x - p.x, q.y - p.y};
    const Number along = -product(p, edge), length_squared = product(edge, edge);
    const Number share = !(along > 0)                ? Number(0)
                         : !(along < length_squared) ? Number(1)
                                                     : Number(along / length_squared);
    const InPlane<Number> at{p.x + share * edge.x, p.y + share * edge.y};
    if (!best || product(at, at) < product(*best, *best)) best = at;
  }
  if (inside) return foot;
  return foot + best->x * u + best->y * w;
}

// --- the features

template <class Number>
Vector<Number> by_features(const Corners<Number>& t) {
  const Vector<Number> normal = t.normal();
  const Number normal_squared = dot(normal, normal);
  bool on_face = normal_squared > 0;
  for (std::size_t i = 0; i < 3; ++i) on_face = on_face && !(dot(cross(t.v[i], t.edge(i)), normal) < 0);
  if (on_face) return Number(dot(normal, t.v[0]) / normal_squared) * normal;
  Vector<Number> best = t.v[0];
  for (std::size_t i = 1; i < 3; ++i)
    if (is_nearer(t.v[i], best)) best = t.v[i];
  for (std::size_t i = 0; i < 3; ++i) {
    const Number along = -dot(t.v[i], t.edge(i)), length_squared = dot(t.edge(i), t.edge(i));
    if (!(along > 0 && along < length_squared)) continue;
    const Vector<Number> at = t.v[i] + Number(along / length_squared) * t.edge(i);
    if (is_nearer(at, best)) best = at;
  }
  return best;
}

// --- minimisation

/// What a vertex has to be nearer by, so that a guess in doubles does not follow rounding.
template <class Number>
Number rounding_slack(const Number& length_squared) {
  if constexpr (std::is_same_v<Number, double>) return 0x1p-40 * length_squared;
  return Number(0);
}

/// The vertex that lies lowest along `direction`.
template <class Number>
std::size_t lowest(const Corners<Number>& t, const Vector<Number>& direction) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (dot(t.v[i], direction) < dot(t.v[best], direction)) best = i;
  return best;
}

/// Goes from a vertex to an edge to the face, each time with the vertex that lies nearest along the way to the origin.
/// An edge that is left for another one never comes back, since the distance falls.
template <class Number>
Vector<Number> by_minimisation(const Corners<Number>& t) {
  Vector<Number> best = t.v[0];
  std::size_t start = 0;
  for (int step = 0; step < 6; ++step) {  // a triangle has three vertices and three edges
    const std::size_t next = lowest(t, best);
    const Number length_squared = dot(best, best);
    if (!(dot(t.v[next], best) < length_squared - rounding_slack(length_squared))) return best;
    const Vector<Number> along_new = nearest_of_segment(t.v[start], t.v[next] - t.v[start]);
    const std::size_t other = 3 - start - next;
    const Vector<Number> along_other =
        other < 3 && other != start ? nearest_of_segment(t.v[other], t.v[next] - t.v[other]) : along_new;
    const bool other_is_nearer = is_nearer(along_other, along_new);
    const Vector<Number> improved = other_is_nearer ? along_other : along_new;
    if (!is_nearer(improved, best)) break;
    best = improved;
    start = next;
  }
  // No edge has a nearer point, and some vertex lies before the plane across `best`: the minimum is on the face.
  const Vector<Number> normal = t.normal();
  const Number normal_squared = dot(normal, normal);
  return normal_squared > 0 ? Number(dot(normal, t.v[0]) / normal_squared) * normal : best;
}

// --- Voronoi regions

template <class Number>
Vector<Number> by_voronoi_regions(const Corners<Number>& t) {
  const auto& [a, b, c] = t.v;
  const Vector<Number> ab = b - a, ac = c - a;
  const Number d1 = -dot(ab, a), d2 = -dot(ac, a);
  if (d1 <= 0 && d2 <= 0) return a;
  const Number d3 = -dot(ab, b), d4 = -dot(ac, b);
  if (d3 >= 0 && d4 <= d3) return b;
  const Number d5 = -dot(ab, c), d6 = -dot(ac, c);
  if (d6 >= 0 && d5 <= d6) return c;
  const Number of_c = d1 * d4 - d3 * d2, of_b = d5 * d2 - d1 * d6, of_a = d3 * d6 - d5 * d4;
  if (of_c <= 0 && d1 >= 0 && d3 <= 0 && d1 > d3) return a + Number(d1 / (d1 - d3)) * ab;
  if (of_b <= 0 && d2 >= 0 && d6 <= 0 && d2 > d6) return a + Number(d2 / (d2 - d6)) * ac;
  if (of_a <= 0 && d4 >= d3 && d5 >= d6 && (d4 - d3) + (d5 - d6) > 0)
    return b + Number((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (c - b);
  const Number whole = (of_a + of_b) + of_c;
  if (!(whole > 0)) return nearest_of_edges(t);
  return a + Number(of_b / whole) * ab + Number(of_c / whole) * ac;
}

// --- guess, proof, and truth

Corners<double> likely_corners(const PosedSphere& s, const Triangle& t) {
  Corners<double> result;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 v = t.vertex[i] - s.centre;
    result.v[i] = {v.x, v.y, v.z};
  }
  return result;
}

Corners<Rational> exact_corners(const PosedSphere& s, const Triangle& t) {
  const RationalPoint centre = to_rational(s.centre);
  Corners<Rational> result;
  for (std::size_t i = 0; i < 3; ++i) {
    const RationalPoint v = to_rational(t.vertex[i]) - centre;
    result.v[i] = {v.x, v.y, v.z};
  }
  return result;
}

double magnitude_of(const Corners<double>& t) {
  double sum = 0;
  for (const Vector<double>& v : t.v) sum += (std::fabs(v.x) + std::fabs(v.y)) + std::fabs(v.z);
  return sum;
}

/// No vertex is nearer along the vector than the radius: apart, whatever the vector is.
bool is_proved_apart(const Corners<double>& t, const Vector<double>& along, double radius) {
  double gap = HUGE_VAL;
  for (const Vector<double>& v : t.v) gap = std::min(gap, dot(v, along));
  return proves_apart(gap, dot(along, along), radius, nearness_error(radius, magnitude_of(t)));
}

/// The triangle's point with the weights of the guess, put into [0, 1], is nearer than the radius.
bool is_proved_near(const Corners<double>& t, const Vector<double>& guess, double radius) {
  const Vector<double> from = guess - t.v[0], u = t.edge(0), w = t.v[2] - t.v[0];
  const double uu = dot(u, u), uw = dot(u, w), ww = dot(w, w), determinant = uu * ww - uw * uw;
  const double of_u = clamped((dot(from, u) * ww - dot(from, w) * uw) / determinant, 0, 1);
  const double of_w = clamped((dot(from, w) * uu - dot(from, u) * uw) / determinant, 0, 1 - of_u);
  const Vector<double> point = (t.v[0] + of_u * u) + of_w * w;
  return proves_meeting(dot(point, point), radius, nearness_error(radius, magnitude_of(t)));
}

/// |height| < radius · |normal|. With the sum m of all coordinates' magnitudes, each coordinate of the normal is off by
/// less than 2^-49 m², the height by less than 2^-48 m³, and a length has at most √3 of its coordinates' errors.
bool is_surely_reached(const Corners<double>& t, const Vector<double>& normal, double height, double radius) {
  const double m = magnitude_of(t), error = 0x1p-47 * (m * m) * (m + radius) + 0x1p-900;
  return height + error < (1 - 0x1p-48) * (radius * std::sqrt(dot(normal, normal)));
}

bool overlap_by(Way<double> likely, Way<Rational> exact, const PosedSphere& sphere, const Triangle& triangle) {
  if (plane_rejects(sphere, triangle)) return false;
  const Corners<double> corners = likely_corners(sphere, triangle);
  const Vector<double> guess = likely(corners);
  if (is_proved_apart(corners, guess, sphere.radius)) return false;
  if (is_proved_near(corners, guess, sphere.radius)) return true;
  const Vector<Rational> nearest = exact(exact_corners(sphere, triangle));
  const Rational radius = to_rational(sphere.radius);
  return dot(nearest, nearest) <= radius * radius;
}

}  // namespace

bool plane_rejects(const PosedSphere& sphere, const Triangle& triangle) {
  const Corners<double> likely = likely_corners(sphere, triangle);
  const Vector<double> along = likely.normal();
  const double height = dot(along, likely.v[0]);
  // Any vector may be the direction of a proof; the height over the plane is the same at all vertices.
  if (is_proved_apart(likely, height < 0 ? -1.0 * along : along, sphere.radius)) return true;
  if (is_surely_reached(likely, along, std::fabs(height), sphere.radius)) return false;
  const Corners<Rational> corners = exact_corners(sphere, triangle);
  const Vector<Rational> normal = corners.normal();
  const Rational exact_height = dot(normal, corners.v[0]), radius = to_rational(sphere.radius);
  return exact_height * exact_height > radius * radius * dot(normal, normal);
}

bool overlap_by_plane_projection(const PosedSphere& sphere, const Triangle& triangle) {
  return overlap_by(by_plane_projection<double>, by_plane_projection<Rational>, sphere, triangle);
}

bool overlap_by_features(const PosedSphere& sphere, const Triangle& triangle) {
  return overlap_by(by_features<double>, by_features<Rational>, sphere, triangle);
}

bool overlap_by_minimisation(const PosedSphere& sphere, const Triangle& triangle) {
  return overlap_by(by_minimisation<double>, by_minimisation<Rational>, sphere, triangle);
}

bool overlap_by_voronoi_regions(const PosedSphere& sphere, const Triangle& triangle) {
  return overlap_by(by_voronoi_regions<double>, by_voronoi_regions<Rational>, sphere, triangle);
}

}  // namespace toccata
