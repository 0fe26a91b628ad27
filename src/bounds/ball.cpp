#include "toccata/bounds/ball.hpp"

#include <numbers>

#include "bounds/point_clouds.hpp"
#include "bounds/posed_bounds.hpp"
#include "bounds/separation.hpp"
#include "bounds/smallest_ball.hpp"
#include "math/constants.hpp"

namespace toccata {
namespace {

/// The ball around a centre that every point is inside of.
Ball around(const Vec3& centre, std::span<const Vec3> points) {
  Ball ball{centre, 0};
  for (const Vec3& p : points) ball.radius = std::max(ball.radius, length_bound(p - centre));
  return ball;
}

const Vec3& farthest_from(const Vec3& place, std::span<const Vec3> points) {
  return *std::max_element(points.begin(), points.end(), [&](const Vec3& p, const Vec3& q) {
    return length_bound(p - place) < length_bound(q - place);
  });
}

}  // namespace

template <>
Ball fit<Ball>(std::span<const Vec3> points) {
  if (points.empty()) return {};
  const CloudScale scaled(checked_box(points));
  std::vector<Vec3> near_one;
  near_one.reserve(points.size());
  for (const Vec3& p : points) near_one.push_back(scaled(p));
  return around(scaled.back(smallest_ball_centre(near_one)), points);
}

template <>
Ball fit<Ball>(std::span<const Triangle> triangles) {
  return fit<Ball>(corners_of(triangles));
}

Ball fit_ball_fast(std::span<const Vec3> points) {
  if (is_empty(checked_box(points))) return {};
  const Vec3& p = farthest_from(points.front(), points);
  const Vec3& q = farthest_from(p, points);
  Ball ball{0.5 * p + 0.5 * q, 0.5 * length_bound(q - p)};
  for (const Vec3& outer : points) {
    const double distance = length_bound(outer - ball.centre);
    if (!(distance > ball.radius)) continue;
    // The ball that touches the far side of this one and the point.
    const double radius = 0.5 * ball.radius + 0.5 * distance;
    ball = {ball.centre + ((distance - radius) / distance) * (outer - ball.centre), radius};
  }
  return around(ball.centre, points);
}

double support_bound(const Ball& ball, const Vec3& direction, const Vec3& from) {
  if (is_empty(ball)) return -infinity;
  UpperSum sum;
  sum.add(direction, ball.centre - from);
  sum.add(ball.radius, length_bound(direction));
  return sum.bound();
}

Vec3 farthest_point(const Ball& ball, const Vec3& direction) {
  const double length = length_bound(direction);
  return length > 0 ? ball.centre + (ball.radius / length) * direction : ball.centre;
}

Ball merge(const Ball& a, const Ball& b) {
  if (is_empty(a) || is_empty(b)) return is_empty(a) ? b : a;
  const Ball& large = a.radius >= b.radius ? a : b;
  const Ball& small = a.radius >= b.radius ? b : a;
  const Vec3 way = small.centre - large.centre;
  const double distance = length_bound(way);
  if (distance + small.radius <= large.radius) return {large.centre, rounded_up(large.radius)};
  const double radius = 0.5 * distance + (0.5 * small.radius + 0.5 * large.radius);
  const Vec3 centre = distance > 0 ? large.centre + ((radius - large.radius) / distance) * way : large.centre;
  const auto reach = [&](const Ball& ball) { return length_bound(ball.centre - centre) + ball.radius; };
  return {centre, rounded_up(std::max(reach(a), reach(b)))};
}

bool contains(const Ball& ball, const Vec3& point) { return length_bound(point - ball.centre) <= ball.radius; }

bool contains(const Ball& outer, const Ball& inner) {
  return is_empty(inner) || rounded_up(length_bound(inner.centre - outer.centre) + inner.radius) <= outer.radius;
}

Ball posed(const Ball& ball, const Pose& pose) {
  if (is_empty(ball)) return {};
  const double slack = length_bound(posing_slack(pose, box_around(ball)));
  const Vec3 centre = transform(pose, ball.centre);
  if (!is_finite(centre)) return {{}, infinity};
  return {centre, rounded_up(stretch_bound(pose.linear) * ball.radius + slack)};
}

Aabb box_around(const Ball& ball) { return box_by_supports(ball); }

double measure(const Ball& ball) {
  return is_empty(ball) ? 0 : 4 * std::numbers::pi / 3 * ball.radius * ball.radius * ball.radius;
}
double surface_area(const Ball& ball) { return is_empty(ball) ? 0 : 4 * std::numbers::pi * ball.radius * ball.radius; }
double half_area(const Ball& ball) { return surface_area(ball) / 2; }

TOCCATA_INSTANTIATE_VOLUME(Ball);

}  // namespace toccata
