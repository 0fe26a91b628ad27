#include <algorithm>
#include <cmath>
#include <limits>

#include "math/double_word.hpp"
#include "narrow/triangle_gaps.hpp"

namespace toccata {
namespace {

using PreciseVector = std::array<DoubleWord, 3>;

// Inlined by force: six heights are computed side by side then, where calls would wait for memory.

[[gnu::always_inline]] inline PreciseVector difference(const Vec3& a, const Vec3& b) {
  return {exact_difference(a.x, b.x), exact_difference(a.y, b.y), exact_difference(a.z, b.z)};
}
[[gnu::always_inline]] inline PreciseVector moved(const PreciseVector& from, double share, const PreciseVector& along) {
  return {from[0] + along[0] * share, from[1] + along[1] * share, from[2] + along[2] * share};
}
[[gnu::always_inline]] inline DoubleWord dot(const PreciseVector& u, const PreciseVector& v) {
  return (u[0] * v[0] + u[1] * v[1]) + u[2] * v[2];
}
Vec3 high_parts(const PreciseVector& v) { return {v[0].high, v[1].high, v[2].high}; }
bool is_less(const DoubleWord& a, const DoubleWord& b) {
  return a.high < b.high || (a.high == b.high && a.low < b.low);
}

/// Differences from points of b to points of a: start + s · along + t · other_along, for shares within a square or,
/// where a face is one of the features, a triangle.
struct Differences {
  PreciseVector start;
  PreciseVector along;
  PreciseVector other_along;
  bool of_face;
};

Differences differences(const Triangle& a, const Triangle& b, int features) {
  const auto next = [](int i) { return (i + 1) % 3; };
  if (features < 9) {
    const int i = features / 3, j = features % 3;
    return {difference(a[i], b[j]), difference(a[next(i)], a[i]), difference(b[j], b[next(j)]), false};
  }
  const int i = features % 3;
  if (features < 12) return {difference(a[i], b[0]), difference(b[0], b[1]), difference(b[0], b[2]), true};
  return {difference(a[0], b[i]), difference(a[1], a[0]), difference(a[2], a[0]), true};
}

/// Two shares, each the sum of two doubles.
struct Shares {
  double s, t;
  double more_s = 0, more_t = 0;

  /// Well within what is allowed, or at an end of it and not moved.
  [[nodiscard]] bool allowed(bool of_face) const {
    const auto fits = [](double share, double more) {
      return more == 0 ? share >= 0 && share <= 1 : share + more > 0x1p-50 && share + more < 1 - 0x1p-50;
    };
    return fits(s, more_s) && fits(t, more_t) && (!of_face || (s + more_s) + (t + more_t) < 1 - 0x1p-50);
  }
};

/// A step of Newton's for the least difference, of the shares that are not at an end.
Shares refined(const Differences& d, const Shares& at) {
  const PreciseVector here = moved(moved(d.start, at.s, d.along), at.t, d.other_along);
  const double down = dot(here, d.along).high, other_down = dot(here, d.other_along).high;
  const Vec3 u = high_parts(d.along), v = high_parts(d.other_along);
  const double uu = toccata::dot(u, u), uv = toccata::dot(u, v), vv = toccata::dot(v, v);
  const bool free = at.s > 0 && at.s<1, other_free = at.t> 0 && at.t < 1;
  Shares result = at;
  if (free && other_free) {
    const double area = uu * vv - uv * uv;
    result.more_s = (uv * other_down - vv * down) / area;
    result.more_t = (uv * down - uu * other_down) / area;
  } else if (free) {
    result.more_s = -down / uu;
  } else if (other_free) {
    result.more_t = -other_down / vv;
  }
  return result;
}

/// How far apart the triangles are along a difference, times its length.
DoubleWord height(const PreciseVector& along, const Triangle& a, const Triangle& b) {
  const Vec3& origin = b[0];
  DoubleWord least = dot(along, difference(a[0], origin)), greatest{0, 0};
  for (int i = 1; i < 3; ++i) {
    const DoubleWord of_a = dot(along, difference(a[i], origin)), of_b = dot(along, difference(b[i], origin));
    if (is_less(of_a, least)) least = of_a;
    if (is_less(greatest, of_b)) greatest = of_b;
  }
  return least - greatest;
}

double largest_difference(const Triangle& a, const Triangle& b) {
  double largest = 0;
  for (int i = 0; i < 3; ++i)
    for (const Vec3& v : {a[i] - b[0], b[i] - b[0]})
      largest = std::max({largest, std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  return largest;
}

}  // namespace

// Bounds: docs/methods/mesh-distance.md.
GapInterval precise_gap(const Triangle& a, const Triangle& b, const TriangleGaps::Points& points) {
  constexpr GapInterval nothing{0, std::numeric_limits<double>::infinity()};
  const Differences d = differences(a, b, static_cast<int>(points.features));
  const Shares shares = refined(d, {points.share, points.other_share});
  if (!shares.allowed(d.of_face)) return nothing;
  PreciseVector least = moved(moved(d.start, shares.s, d.along), shares.t, d.other_along);
  least = moved(moved(least, shares.more_s, d.along), shares.more_t, d.other_along);
  const double size = largest_difference(a, b), off = 0x1p-90 * size;
  const double length = std::sqrt(dot(least, least).high);
  if (!(size > 0x1p-200 && size < 0x1p200 && length > 0x1p-60 * size)) return nothing;
  const double lower = height(least, a, b).high / length;
  return {std::max(lower * (1 - 0x1p-49) - off, 0.0), length * (1 + 0x1p-49) + off};
}

}  // namespace toccata
