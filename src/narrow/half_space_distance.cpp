#include <cmath>

#include "math/double_search.hpp"
#include "math/exact.hpp"
#include "narrow/half_space_gap.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

struct Neighbours {
  double lower = 0;
  double upper = 0;
};

/// The doubles around a positive number known by comparisons.
template <class Compare>
Neighbours neighbours_of(const Compare& compare, double guess) {
  const double lower = greatest_double_below(compare, std::fmax(0, guess));
  const bool is_double = compare(lower, lower) == Sign::zero;
  return {lower, is_double ? lower : of_rank(rank_of(lower) + 1)};
}

Distance apart_by(const HalfSpaceGap& gap) {
  const auto compare = [&](double x, double y) { return gap.compare(x, y); };
  const auto [lower, upper] = neighbours_of(compare, gap.approximate());
  return {lower, upper, gap.on_ball(), gap.foot(), Status::exact};
}

Distance meeting_in(const Vec3& point) { return {0, 0, point, point, Status::exact}; }

/// The point on both planes that is nearest to a.point; for normals that are not parallel.
Vec3 point_on_planes(const PosedHalfSpace& a, const PosedHalfSpace& b) {
  const RationalPoint from = to_rational(a.point), n = to_rational(a.normal), m = to_rational(b.normal);
  const Rational height = dot(from - to_rational(b.point), m);
  const Rational nn = dot(n, n), nm = dot(n, m), mm = dot(m, m);
  const Rational determinant = nn * mm - nm * nm;
  return nearest_doubles(from + (height * nm / determinant) * n - (height * nn / determinant) * m);
}

/// Of two half-spaces that meet; the same for both orders.
Vec3 common_point(const PosedHalfSpace& a, const PosedHalfSpace& b) {
  if (lexicographically_less(b.point, a.point)) return common_point(b, a);
  if (height_sign(b, a.point) != Sign::positive) return a.point;
  if (height_sign(a, b.point) != Sign::positive) return b.point;
  return point_on_planes(a, b);  // not parallel: of parallel ones that meet, one contains the other's point
}

/// Off by less than 2^-49 of it. The last place of the exact depth is not enough: the direction is rounded too, and the
/// move has to reach. Its length along the exact normal is at least upper · (1 − 2^-50).
double depth_that_parts(double upper) { return std::nextafter(upper * (1 + 0x1p-49), HUGE_VAL); }

}  // namespace

Distance distance(const PosedConvex& a, const PosedHalfSpace& b) {
  const Vec3 lowest = extreme_vertex(a, b, Reach::below).position;
  if (height_sign(b, lowest) != Sign::positive) return meeting_in(lowest);
  const HalfSpaceGap gap(lowest, a.radius(), b);
  if (reach_sign(lowest, a.radius(), b, Reach::below) != Sign::negative) return meeting_in(gap.foot());
  return apart_by(gap);
}

Distance distance(const PosedHalfSpace& a, const PosedHalfSpace& b) {
  if (relation(a, b).kind == RelationKind::apart) return apart_by(HalfSpaceGap(a.point, 0, b));
  return meeting_in(common_point(a, b));
}

Penetration penetration(const PosedConvex& a, const PosedHalfSpace& b) {
  if (!a.solid()) throw Error("penetration: a surface has no interior that a half-space could leave; ask for distance");
  const Vec3 lowest = extreme_vertex(a, b, Reach::below).position;
  if (reach_sign(lowest, a.radius(), b, Reach::below) != Sign::positive) return {};
  const HalfSpaceGap gap(lowest, a.radius(), b);
  const auto compare_depth = [&](double x, double y) { return -gap.compare(-x, -y); };
  const auto [lower, upper] = neighbours_of(compare_depth, -gap.approximate());
  return {lower, depth_that_parts(upper), -unit_normal(b), gap.on_ball(), gap.foot(), Status::exact};
}

}  // namespace toccata
