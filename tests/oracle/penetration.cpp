#include "oracle/penetration.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace toccata::oracle {
namespace {

using Points = std::vector<RationalPoint>;

/// Directions in which the hull of some points has edges, and the normals of its facets; perhaps some more than once,
/// and of a flat hull more than those.
struct Directions {
  Points edges;
  Points normals;
};

/// Four points that span space, or fewer that span as much as there is.
Points spanning(const Points& points) {
  Points few{points[0]};
  for (const RationalPoint& p : points) {
    if (few.size() == 1 && !(p == few[0])) few.push_back(p);
    if (few.size() == 2 && !is_zero(cross(few[1] - few[0], p - few[0]))) few.push_back(p);
    if (few.size() == 3 && !orientation(few[0], few[1], few[2], p).is_zero()) few.push_back(p);
  }
  return few;
}

using Corners = std::array<RationalPoint, 3>;

bool is_above(const Corners& face, const RationalPoint& p) { return orientation(face[0], face[1], face[2], p) > 0; }

/// Triangles that bound the hull, seen counter-clockwise from outside: begins with a tetrahedron, and each point takes
/// the place of the triangles that it lies strictly above.
std::vector<Corners> boundary(const Points& points, Points four) {
  if (orientation(four[0], four[1], four[2], four[3]) > 0) std::swap(four[0], four[1]);
  std::vector<Corners> faces{{four[0], four[1], four[2]},
                             {four[0], four[3], four[1]},
                             {four[1], four[3], four[2]},
                             {four[2], four[3], four[0]}};
  for (const RationalPoint& p : points) {
    const auto hidden = std::partition(faces.begin(), faces.end(), [&](const Corners& f) { return !is_above(f, p); });
    std::vector<std::pair<RationalPoint, RationalPoint>> open;
    for (auto face = hidden; face != faces.end(); ++face)
      for (std::size_t i = 0; i < 3; ++i) {
        const std::pair edge{(*face)[i], (*face)[(i + 1) % 3]};
        const auto twin = std::ranges::find(open, std::pair{edge.second, edge.first});
        if (twin == open.end())
          open.push_back(edge);
        else
          open.erase(twin);
      }
    faces.erase(hidden, faces.end());
    for (const auto& edge : open) faces.push_back({edge.first, edge.second, p});
  }
  return faces;
}

Directions directions_of_flat(const Points& points, const Points& few) {
  Directions result;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j) result.edges.push_back(points[j] - points[i]);
  if (few.size() == 3) result.normals.push_back(cross(few[1] - few[0], few[2] - few[0]));
  return result;
}

Directions directions_of(const Points& points) {
  const Points few = spanning(points);
  if (few.size() < 4) return directions_of_flat(points, few);
  Directions result;
  for (const Corners& face : boundary(points, few)) {
    result.normals.push_back(cross(face[1] - face[0], face[2] - face[0]));
    for (std::size_t i = 0; i < 3; ++i)  // each edge is seen from two faces, in opposite directions
      if (face[i] < face[(i + 1) % 3]) result.edges.push_back(face[(i + 1) % 3] - face[i]);
  }
  return result;
}

/// How far A − B reaches along n, not divided by the length of n.
Rational reach(const RationalPoint& n, const ConvexSet& a, const ConvexSet& b) {
  const auto along = [&](const RationalPoint& v) { return dot(v, n); };
  return along(*std::ranges::max_element(a.vertices, {}, along)) -
         along(*std::ranges::min_element(b.vertices, {}, along));
}

Vec3 rounded(const RationalPoint& p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
}

double length(const Vec3& v) { return std::hypot(v.x, v.y, v.z); }

/// A − B in doubles, near enough to leave out normals along which it reaches much farther than along others.
class RoundedDifference {
 public:
  RoundedDifference(const ConvexSet& a, const ConvexSet& b) {
    for (const RationalPoint& v : a.vertices) a_.push_back(rounded(v - a.vertices[0]));
    for (const RationalPoint& v : b.vertices) b_.push_back(rounded(v - a.vertices[0]));
    for (const Vec3& v : a_) size_ = std::max(size_, length(v));
    for (const Vec3& v : b_) size_ = std::max(size_, length(v));
  }

  /// With an error below a tenth of `tolerance` when the direction of n is known to 1e-11.
  double reach(const Vec3& n) const {
    double most = -std::numeric_limits<double>::infinity(), least = -most;
    for (const Vec3& v : a_) most = std::max(most, dot(v, n));
    for (const Vec3& v : b_) least = std::min(least, dot(v, n));
    return (most - least) / length(n);
  }
  double tolerance() const { return 1e-9 * size_; }

 private:
  std::vector<Vec3> a_;
  std::vector<Vec3> b_;
  double size_ = 0;
};

struct Candidate {
  RationalPoint first;  ///< the normal is first × second, or first where second is zero
  RationalPoint second;
  double reach;  ///< the lesser of both ways; −∞ where doubles do not know
  RationalPoint normal() const { return is_zero(second) ? first : cross(first, second); }
};

Candidate candidate(const RationalPoint& first, const RationalPoint& second, const RoundedDifference& difference) {
  const Vec3 p = rounded(first), q = rounded(second);
  const bool one = is_zero(second);
  const Vec3 n = one ? p : cross(p, q);
  const bool known = length(n) > (one ? 0 : 1e-4 * length(p) * length(q)) && length(n) > 1e-200;
  const double way = known ? std::min(difference.reach(n), difference.reach(-n)) : -1;
  return {first, second, known ? way : -std::numeric_limits<double>::infinity()};
}

std::vector<Candidate> candidates(const ConvexSet& a, const ConvexSet& b, const RoundedDifference& difference) {
  const Directions of_a = directions_of(a.vertices), of_b = directions_of(b.vertices);
  std::vector<Candidate> result;
  for (const Points& normals : {of_a.normals, of_b.normals})
    for (const RationalPoint& normal : normals) result.push_back(candidate(normal, {}, difference));
  for (const RationalPoint& p : of_a.edges)
    for (const RationalPoint& q : of_b.edges) result.push_back(candidate(p, q, difference));
  return result;
}

/// The squared distance of the origin, which lies in A − B (radii left aside), to the boundary.
Rational squared_core_depth(const ConvexSet& a, const ConvexSet& b) {
  const RoundedDifference difference(a, b);
  const std::vector<Candidate> all = candidates(a, b, difference);
  double least_known = std::numeric_limits<double>::infinity();
  for (const Candidate& c : all)
    if (c.reach > -std::numeric_limits<double>::infinity()) least_known = std::min(least_known, c.reach);
  Rational least = -1;
  for (const Candidate& c : all) {
    if (c.reach > least_known + difference.tolerance()) continue;
    const RationalPoint n = c.normal();
    if (is_zero(n)) continue;
    const Rational way = std::min(reach(n, a, b), reach(-n, a, b));
    const Rational squared = way * way / dot(n, n);
    if (least < 0 || squared < least) least = squared;
  }
  return least < 0 ? Rational(0) : least;  // without any normal, A − B is a segment or a point
}

}  // namespace

ConvexSet moved(ConvexSet set, const RationalPoint& by) {
  for (RationalPoint& v : set.vertices) v = v + by;
  return set;
}

Depth::Depth(const ConvexSet& a, const ConvexSet& b)
    : radii_(a.radius + b.radius),
      squared_distance_(nearest_points(a, b).squared_distance),
      squared_core_depth_(squared_distance_ > 0 ? Rational(0) : squared_core_depth(a, b)) {}

int Depth::compare(const Rational& depth) const {
  const Rational rest = radii_ - depth;
  if (squared_distance_ >= radii_ * radii_ && squared_distance_ > 0) return depth.is_zero() ? 0 : -1;
  // The penetration is radii − distance, or radii + the depth of the cores.
  if (squared_distance_ > 0) return rest < 0 ? -1 : Rational(rest * rest - squared_distance_).sign();
  if (rest > 0) return 1;
  return Rational(squared_core_depth_ - rest * rest).sign();
}

int compare_penetration(const ConvexSet& a, const ConvexSet& b, const Rational& depth) {
  return Depth(a, b).compare(depth);
}

int compare_penetration(const ConvexSet& a, const HalfSpace& b, const Rational& depth) {
  const auto height = [&](const RationalPoint& v) { return height_above(b, v); };
  const Rational lowest = height(*std::ranges::min_element(a.vertices, {}, height));
  // The sign of (a.radius − depth) · |normal| − lowest; a penetration below 0 counts as 0.
  const auto sign = [&](const Rational& r) {
    const Rational squares = r * r * dot(b.normal, b.normal) - lowest * lowest;
    if (r >= 0) return lowest < 0 ? 1 : squares.sign();
    return lowest >= 0 ? -1 : -squares.sign();
  };
  if (depth.is_zero()) return std::max(sign(a.radius), 0);
  return sign(a.radius - depth);
}

}  // namespace toccata::oracle
