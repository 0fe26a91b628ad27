#include "oracle/rays.hpp"

namespace toccata::oracle {
namespace {

void keep_least(std::optional<Rational>& least, const Rational& time) {
  if (time >= 0 && time <= 1 && (!least || time < *least)) least = time;
}

RationalPoint at(const RationalPoint& origin, const RationalPoint& motion, const Rational& time) {
  return origin + time * motion;
}

/// Where the ray passes a point, if it does.
void try_point(const RationalPoint& origin, const RationalPoint& motion, const RationalPoint& p,
               std::optional<Rational>& least) {
  const Rational time = dot(p - origin, motion) / dot(motion, motion);
  if (at(origin, motion, time) == p) keep_least(least, time);
}

/// Where the ray's line and that of p, q are nearest to each other, if they are not parallel.
void try_segment(const RationalPoint& origin, const RationalPoint& motion, const RationalPoint& p,
                 const RationalPoint& q, const RationalTriangle& target, std::optional<Rational>& least) {
  const RationalPoint across = cross(motion, q - p);
  if (is_zero(across)) return;  // then the ends tell
  const Rational time = dot(cross(p - origin, q - p), across) / dot(across, across);
  if (contains(target, at(origin, motion, time))) keep_least(least, time);
}

}  // namespace

std::optional<Rational> time_of_hit(const RationalPoint& origin, const RationalPoint& motion,
                                    const RationalTriangle& target) {
  // The first point on the triangle is the start, or in the plane of a triangle that the ray is not parallel to, or on
  // an edge.
  if (contains(target, origin)) return Rational(0);
  std::optional<Rational> least;
  const auto& v = target.vertex;
  const RationalPoint up = normal(target);
  const Rational speed = dot(up, motion);
  if (speed != 0) {
    const Rational time = dot(up, v[0] - origin) / speed;
    if (contains(target, at(origin, motion, time))) keep_least(least, time);
    return least;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    try_point(origin, motion, v[i], least);
    try_segment(origin, motion, v[i], v[(i + 1) % 3], target, least);
  }
  return least;
}

}  // namespace toccata::oracle
