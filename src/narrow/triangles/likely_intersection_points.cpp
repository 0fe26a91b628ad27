#include "narrow/triangles/likely_intersection_points.hpp"

#include <cmath>

#include "math/double_word.hpp"
#include "narrow/triangles/triangle_features.hpp"

namespace toccata {
namespace {

// Where numbers are in these ranges, underflow takes at most 2^-860 from n and d below, which the floor covers, and
// from the rest nothing that matters.
constexpr double greatest_likely_coordinate = 0x1p100;
constexpr double least_number = 0x1p-500;
constexpr double magnitude_floor = 0x1p-700;

struct WordVector {
  DoubleWord x, y, z;
};

WordVector exact_way(const Vec3& from, const Vec3& to) {
  return {exact_difference(to.x, from.x), exact_difference(to.y, from.y), exact_difference(to.z, from.z)};
}

/// The magnitudes of the rounded components.
Vec3 magnitudes(const WordVector& v) { return {std::fabs(v.x.high), std::fabs(v.y.high), std::fabs(v.z.high)}; }

DoubleWord dot(const WordVector& u, const WordVector& v) { return u.x * v.x + u.y * v.y + u.z * v.z; }

WordVector cross(const WordVector& u, const WordVector& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

/// The magnitudes of the terms of `cross`.
Vec3 cross_of_magnitudes(const Vec3& u, const Vec3& v) {
  return {u.y * v.z + u.z * v.y, u.z * v.x + u.x * v.z, u.x * v.y + u.y * v.x};
}

bool in_range(const Vec3& v) {
  return std::fabs(v.x) <= greatest_likely_coordinate && std::fabs(v.y) <= greatest_likely_coordinate &&
         std::fabs(v.z) <= greatest_likely_coordinate;
}

bool in_range(const Triangle& t) { return in_range(t[0]) && in_range(t[1]) && in_range(t[2]); }

/// The point at n / d of the way from p to q, where n and d are sums of products of exact differences.
///
/// Let β be `double_word_bound`. n and d are off by at most 7β times the sum of their terms' magnitudes, d perhaps by
/// β|d| more; `magnitude` is both sums together. The exact share is between 0 and 1, so n / d is off from it by at most
/// β(14 magnitude / |d| + 2), and a coordinate x of the point, where g = q − p, by |g| times that and β(|g| + |x|).
/// 64β(|g|(magnitude / |d| + 1) + |x|) is more, with room for what rounds in computing it.
struct ShareOfEdge {
  DoubleWord n;
  DoubleWord d;
  double magnitude = 0;
};

/// The nearest double, where that is certain.
std::optional<double> likely_coordinate(double p, double q, const DoubleWord& share, double spread) {
  if (p == q) return p + 0.0;  // 0 for −0
  const DoubleWord way = exact_difference(q, p);
  const DoubleWord x = DoubleWord{p, 0} + share * way;
  if (!(std::fabs(x.high) >= least_number)) return std::nullopt;
  const double error = 64 * double_word_bound * (std::fabs(way.high) * spread + std::fabs(x.high));
  const double low = x.high + (x.low - error), high = x.high + (x.low + error);
  return low == high ? std::optional(low) : std::nullopt;
}

std::optional<Vec3> likely_point(const Vec3& p, const Vec3& q, const ShareOfEdge& at) {
  if (!(std::fabs(at.n.high) >= least_number && std::fabs(at.d.high) >= least_number)) return std::nullopt;
  const double spread = (at.magnitude + magnitude_floor) / std::fabs(at.d.high) + 1;
  const DoubleWord share = at.n / at.d;
  const std::optional<double> x = likely_coordinate(p.x, q.x, share, spread),
                              y = likely_coordinate(p.y, q.y, share, spread),
                              z = likely_coordinate(p.z, q.z, share, spread);
  if (!x || !y || !z) return std::nullopt;
  return Vec3{*x, *y, *z};
}

}  // namespace

std::optional<Vec3> likely_edge_and_plane(const Triangle& t, int i, const Triangle& plane) {
  if (!in_range(t) || !in_range(plane)) return std::nullopt;
  const Vec3 &p = edge_start(t, i), &q = edge_end(t, i);
  const WordVector u = exact_way(plane[0], plane[1]), v = exact_way(plane[0], plane[2]);
  const WordVector to_p = exact_way(plane[0], p), to_q = exact_way(plane[0], q), normal = cross(u, v);
  const DoubleWord height = dot(normal, to_p);
  return likely_point(p, q,
                      {height, height - dot(normal, to_q),
                       dot(cross_of_magnitudes(magnitudes(u), magnitudes(v)), magnitudes(to_p) + magnitudes(to_q))});
}

std::optional<Vec3> likely_edge_and_edge(const Triangle& a, int i, const Triangle& b, int j) {
  if (!in_range(a) || !in_range(b)) return std::nullopt;
  const Vec3 &p = edge_start(a, i), &q = edge_end(a, i), &r = edge_start(b, j);
  const WordVector along_a = exact_way(p, q), along_b = exact_way(r, edge_end(b, j)), way = exact_way(p, r);
  const WordVector turns = cross(along_a, along_b), shares = cross(way, along_b);
  const Vec3 terms = cross_of_magnitudes(magnitudes(along_a) + magnitudes(way), magnitudes(along_b));
  // Seen along the axis from which the edges turn most.
  const Vec3 size = magnitudes(turns);
  if (size.x >= size.y && size.x >= size.z) return likely_point(p, q, {shares.x, turns.x, terms.x});
  if (size.y >= size.z) return likely_point(p, q, {shares.y, turns.y, terms.y});
  return likely_point(p, q, {shares.z, turns.z, terms.z});
}

}  // namespace toccata
