#include "oracle/penetration.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "oracle/hull_boundary.hpp"

namespace toccata::oracle {
namespace {

using Points = std::vector<RationalPoint>;

/// How far A − B reaches along n, not divided by the length of n.
Rational reach(const RationalPoint& n, const ConvexSet& a, const ConvexSet& b) {
  const auto along = [&](const RationalPoint& v) { return dot(v, n); };
  return along(*std::ranges::max_element(a.vertices, {}, along)) -
         along(*std::ranges::min_element(b.vertices, {}, along));
}

double hypotenuse(const Vec3& v) { return std::hypot(v.x, v.y, v.z); }

/// A − B in doubles, near enough to leave out normals along which it reaches much farther than along others.
class RoundedDifference {
 public:
  RoundedDifference(const ConvexSet& a, const ConvexSet& b) {
    for (const RationalPoint& v : a.vertices) a_.push_back(rounded(v - a.vertices[0]));
    for (const RationalPoint& v : b.vertices) b_.push_back(rounded(v - a.vertices[0]));
    for (const Vec3& v : a_) size_ = std::max(size_, hypotenuse(v));
    for (const Vec3& v : b_) size_ = std::max(size_, hypotenuse(v));
  }

  /// With an error below a tenth of `tolerance` when the direction of n is known to 1e-11.
  double reach(const Vec3& n) const {
    double most = -std::numeric_limits<double>::infinity(), least = -most;
    for (const Vec3& v : a_) most = std::max(most, dot(v, n));
    for (const Vec3& v : b_) least = std::min(least, dot(v, n));
    return (most - least) / hypotenuse(n);
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
  const bool known = hypotenuse(n) > (one ? 0 : 1e-4 * hypotenuse(p) * hypotenuse(q)) && hypotenuse(n) > 1e-200;
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
      squared_distance_(squared_distance(a, b)),
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
