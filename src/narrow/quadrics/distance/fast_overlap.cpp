#include "narrow/quadrics/distance/fast_overlap.hpp"

#include <algorithm>
#include <cmath>

#include "math/constants.hpp"
#include "math/vec3_measures.hpp"

// Near each corner, which is rounded, lies a true point of A − B. When a ball around the origin with that radius lies
// within the tetrahedron of the corners, the origin lies within that of the true points: else all of these would lie
// beyond a plane through the origin, and no corner farther before it than the radius, as the ball does.
//
// With u = 2⁻⁵³, and as no coordinate in the pair's frame is more than 2, of a centre, a column, or their sum: a centre
// is off by 6 u; a column by 2 u, for three of them along a vector of length 1 by 3.5 u; their products and sums by
// 10.4 u; what the vector is longer than 1 counts 10 u · 2 √3; the sum with the centre rounds by 2 u. In all 56.5 u for
// each body, and 4 u for the difference: 117 u for each coordinate of a corner, 203 u for its place.
//
// The distance of the origin from the plane of three corners p, q, r is p · (q × r) / |(q − p) × (r − p)|. Coordinates
// are at most 4 here: of the cross product, products round by 16 u each and the difference by 32 u, 64 u; that counts
// 64 u · 4 for each of three terms, the products of which, of at most 128, round by 128 u each, and their sums by 256 u
// and 384 u: 1792 u for the numerator. The length is no more than 13.9²; what it may be off by is of second order.
namespace toccata {
namespace {

constexpr double corner_off = 256 * unit_roundoff;
constexpr double volume_off = 2048 * unit_roundoff;

/// Whether a vector is no longer than 1, but for rounding, which is 5 u: squares and sums round by 4 u.
bool is_within_unit_ball(const Vec3& round) { return dot(round, round) <= 1 + 15 * unit_roundoff; }

/// The faces of four corners in the order in which all look outwards, or all inwards; each across from one of them.
constexpr std::array<std::array<std::size_t, 3>, 4> outward_faces{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

}  // namespace

bool are_surely_around_origin(std::span<const QuadricSearch::Corner> corners) {
  if (corners.size() != 4) return false;
  std::array<Vec3, 4> p;
  for (std::size_t i = 0; i < 4; ++i) {
    if (!is_within_unit_ball(corners[i].a.round) || !is_within_unit_ball(corners[i].b.round)) return false;
    p[i] = corners[i].a.point - corners[i].b.point;
    if (!(largest_magnitude(p[i]) <= 4)) return false;
  }
  double sign = 0;
  for (const auto& [i, j, k] : outward_faces) {
    const double volume = dot(p[i], cross(p[j], p[k]));
    if (sign == 0) sign = volume > 0 ? 1 : -1;
    const double area = plain_length(cross(p[j] - p[i], p[k] - p[i]));
    if (!(sign * volume > corner_off * area + volume_off)) return false;
  }
  return true;
}

// The corners' shares of the origin are as the volumes that it has with the faces across from them.
Vec3 common_point_of(std::span<const QuadricSearch::Corner> corners) {
  std::array<Vec3, 4> p;
  for (std::size_t i = 0; i < 4; ++i) p[i] = corners[i].a.point - corners[i].b.point;
  Vec3 sum;
  double whole = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& [j, k, l] = outward_faces[i];
    const double share = std::fabs(dot(p[j], cross(p[k], p[l])));
    sum = sum + share * (0.5 * corners[i].a.point + 0.5 * corners[i].b.point);
    whole += share;
  }
  return (1 / whole) * sum;
}

}  // namespace toccata
