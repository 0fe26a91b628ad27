#include <cmath>
#include <optional>

#include "math/bounded_number.hpp"
#include "math/double_search.hpp"
#include "math/exact.hpp"
#include "narrow/convex/convex_containment.hpp"
#include "narrow/half_spaces/half_space_gap.hpp"
#include "narrow/near.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

/// The doubles around a positive number known by comparisons.
template <class Compare>
DoubleBracket neighbours_of(const Compare& compare, double guess) {
  const double lower = greatest_double_below(compare, std::fmax(0, guess));
  const bool is_double = compare(lower, lower) == Sign::zero;
  return {lower, is_double ? lower : of_rank(rank_of(lower) + 1)};
}

/// What HalfSpaceGap finds exactly, where 106 bits are enough.
struct LikelyGap {
  BoundedNumber gap;
  std::optional<Vec3> on_ball;
  std::optional<Vec3> foot;
};

/// The point moved along the normal; a coordinate along which the normal does not point stays.
std::optional<Vec3> moved_along(const Vec3& point, const BoundedNumber& share, const Vec3& normal) {
  Vec3 result = point + Vec3{};  // no −0
  for (int axis = 0; axis < 3; ++axis) {
    if (normal[axis] == 0) continue;
    const auto rounded = nearest_double(exactly(point[axis]) - share * exactly(normal[axis]));
    if (!rounded) return {};
    result[axis] = *rounded;
  }
  return result;
}

LikelyGap likely_gap(const Vec3& centre, double radius, const PosedHalfSpace& h) {
  const BoundedVector normal = exactly(h.normal);
  const BoundedNumber height = dot(bounded_difference(centre, h.point), normal), squared = dot(normal, normal);
  const BoundedNumber length = square_root(squared);
  return {height / length - exactly(radius), moved_along(centre, exactly(radius) / length, h.normal),
          moved_along(centre, height / squared, h.normal)};
}

/// The doubles around the gap, where it certainly is one.
std::optional<DoubleBracket> certain_neighbours(const BoundedNumber& gap) {
  return gap.is_positive() ? bracket(gap) : std::nullopt;
}

Distance apart_by(const Vec3& centre, double radius, const PosedHalfSpace& h) {
  const LikelyGap likely = likely_gap(centre, radius, h);
  if (const auto near = certain_neighbours(likely.gap); near && likely.on_ball && likely.foot)
    return {near->lower, near->upper, *likely.on_ball, *likely.foot, Status::exact};
  const HalfSpaceGap gap(centre, radius, h);
  const auto compare = [&](double x, double y) { return gap.compare(x, y); };
  const auto [lower, upper] = neighbours_of(compare, gap.approximate());
  return {lower, upper, gap.on_ball(), gap.foot(), Status::exact};
}

Distance intersection_in(const Vec3& point) { return {0, 0, point, point, Status::exact}; }

/// The point on both planes that is nearest to a.point; for normals that are not parallel.
Vec3 point_on_planes(const PosedHalfSpace& a, const PosedHalfSpace& b) {
  const RationalPoint from = to_rational(a.point), n = to_rational(a.normal), m = to_rational(b.normal);
  const Rational height = dot(from - to_rational(b.point), m);
  const Rational nn = dot(n, n), nm = dot(n, m), mm = dot(m, m);
  const Rational determinant = nn * mm - nm * nm;
  return nearest_doubles(from + (height * nm / determinant) * n - (height * nn / determinant) * m);
}

/// A common point of two half-spaces that meet; the same for both orders.
Vec3 common_point(const PosedHalfSpace& a, const PosedHalfSpace& b) {
  if (lexicographically_less(b.point, a.point)) return common_point(b, a);
  if (height_sign(b, a.point) != Sign::positive) return a.point;
  if (height_sign(a, b.point) != Sign::positive) return b.point;
  return point_on_planes(a, b);  // not parallel: of parallel ones that meet, one contains the other's point
}

/// Off by less than 2^-49 of it. The last place of the exact depth is not enough: the direction is rounded too, and the
/// move has to reach. Its length along the exact normal is at least upper · (1 − 2^-50).
double depth_that_parts(double upper) { return std::nextafter(upper * (1 + 0x1p-49), HUGE_VAL); }

/// The distance is rounded both ways to neighbouring doubles, or is itself a double: `upper` is the least that is not
/// below it.
template <class A>
std::optional<Nearby> nearby_half_space(const A& a, const PosedHalfSpace& b, const WantedDistance& wanted) {
  return nearby_by(
      wanted, Quicker::distance,
      [&](double length) { return length == 0 ? overlap(a, b) : distance(a, b).upper <= length; },
      [&] { return distance(a, b); });
}

}  // namespace

std::optional<Nearby> nearby(const PosedPolytope& a, const PosedHalfSpace& b, const WantedDistance& wanted) {
  return nearby_half_space(a, b, wanted);
}
std::optional<Nearby> nearby(const PosedHalfSpace& a, const PosedHalfSpace& b, const WantedDistance& wanted) {
  return nearby_half_space(a, b, wanted);
}

Distance distance(const PosedPolytope& a, const PosedHalfSpace& b) {
  const Vec3 lowest = extreme_vertex(a, b, Reach::below).position;
  if (height_sign(b, lowest) != Sign::positive) return intersection_in(lowest);
  if (reach_sign(lowest, a.radius(), b, Reach::below) == Sign::negative) return apart_by(lowest, a.radius(), b);
  const auto foot = likely_gap(lowest, a.radius(), b).foot;
  return intersection_in(foot ? *foot : HalfSpaceGap(lowest, a.radius(), b).foot());
}

Distance distance(const PosedHalfSpace& a, const PosedHalfSpace& b) {
  if (relation(a, b).kind == RelationKind::apart) return apart_by(a.point, 0, b);
  return intersection_in(common_point(a, b));
}

Penetration penetration(const PosedPolytope& a, const PosedHalfSpace& b) {
  if (!a.solid()) throw Error("penetration: a surface has no interior that a half-space could leave; ask for distance");
  const Vec3 lowest = extreme_vertex(a, b, Reach::below).position;
  if (reach_sign(lowest, a.radius(), b, Reach::below) != Sign::positive || is_flattened(a)) return {};
  const LikelyGap likely = likely_gap(lowest, a.radius(), b);
  if (const auto near = certain_neighbours(-likely.gap); near && likely.on_ball && likely.foot)
    return {near->lower, depth_that_parts(near->upper), -unit_normal(b), *likely.on_ball, *likely.foot, Status::exact};
  const HalfSpaceGap gap(lowest, a.radius(), b);
  const auto compare_depth = [&](double x, double y) { return -gap.compare(-x, -y); };
  const auto [lower, upper] = neighbours_of(compare_depth, -gap.approximate());
  return {lower, depth_that_parts(upper), -unit_normal(b), gap.on_ball(), gap.foot(), Status::exact};
}

}  // namespace toccata
