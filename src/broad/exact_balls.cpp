#include "broad/exact_balls.hpp"

#include <algorithm>
#include <cmath>

#include "math/exact.hpp"

namespace toccata {
namespace {

bool are_within_exactly(const Vec3& p, const Vec3& q, double one, double other) {
  const RationalPoint way = to_rational(p) - to_rational(q);
  const Rational reach = to_rational(one) + to_rational(other);
  return sign_of(Rational(dot(way, way) - reach * reach)) != Sign::positive;
}

/// Whether two points are as near as the sum of two lengths, which are not negative.
bool are_within(const Vec3& p, const Vec3& q, double one, double other) {
  if (std::isinf(one) || std::isinf(other)) return true;
  const Vec3 way = p - q;
  const double squared = dot(way, way), reach = (one + other) * (one + other);
  // Each is rounded six times at most. Below and above these numbers it may be by more.
  constexpr double least = 0x1p-960, most = 0x1p+1000, unsure = 0x1p-49;
  const double larger = std::max(squared, reach);
  if (larger > least && larger < most && std::fabs(squared - reach) > unsure * larger) return squared < reach;
  return are_within_exactly(p, q, one, other);
}

}  // namespace

bool balls_meet(const Ball& a, const Ball& b) { return are_within(a.centre, b.centre, a.radius, b.radius); }

bool ball_meets_box(const Ball& ball, const Aabb& box) {
  const auto nearest = [&](int axis) { return std::clamp(ball.centre[axis], box.lower[axis], box.upper[axis]); };
  return are_within(ball.centre, {nearest(0), nearest(1), nearest(2)}, ball.radius, 0);
}

}  // namespace toccata
