#include "toccata/bounds/swept_sphere.hpp"

#include <numbers>
#include <vector>

#include "bounds/frame.hpp"
#include "bounds/point_clouds.hpp"
#include "bounds/posed_bounds.hpp"
#include "bounds/separation.hpp"
#include "math/constants.hpp"
#include "toccata/bounds/obb.hpp"
#include "toccata/math/mat3.hpp"

namespace toccata {
namespace {

template <std::size_t dimension>
Vec3 core_point(const SweptSphere<dimension>& v, const Vec3& s) {
  return point_in_frame(v.axes, v.centre, s);
}

/// Where on the core a point is nearest, but for rounding, and how far at most it is from the core. Any place on the
/// core proves a bound: the exact centre + Σ s_i axis_i of these s_i.
template <std::size_t dimension>
double core_distance_bound(const SweptSphere<dimension>& v, const Vec3& point) {
  const Vec3 from_centre = point - v.centre;
  std::array<double, dimension> s{};
  for (std::size_t i = 0; i < dimension; ++i)
    s[i] = std::clamp(dot(v.axes[static_cast<int>(i)], from_centre), -v.half[i], v.half[i]);
  Vec3 rest;
  for (int axis = 0; axis < 3; ++axis) {
    UpperSum sum;
    sum.add(1, from_centre[axis]);
    for (std::size_t i = 0; i < dimension; ++i) sum.add(-s[i], v.axes[static_cast<int>(i)][axis]);
    rest[axis] = from_centre[axis] == 0 && dimension == 0 ? 0 : sum.magnitude_bound();
  }
  return length_bound(rest);
}

/// The least radius, but for rounding, with which the core holds all balls.
template <std::size_t dimension>
double radius_around(const SweptSphere<dimension>& core, std::span<const Ball> balls) {
  double radius = 0;
  for (const Ball& ball : balls) radius = std::max(radius, core_distance_bound(core, ball.centre) + ball.radius);
  return radius;
}

/// A volume around balls with a core along the given axes, and in the middle of them.
template <std::size_t dimension>
SweptSphere<dimension> around(const Mat3& axes, const Vec3& near, std::span<const Ball> balls) {
  Aabb along;
  double largest = 0;
  for (const Ball& ball : balls) {
    const Vec3 y = ball.centre - near;
    along = merge(along, Vec3{dot(axes[0], y), dot(axes[1], y), dot(axes[2], y)});
    largest = std::max(largest, ball.radius);
  }
  const Vec3 reach = 0.5 * (along.upper - along.lower);
  SweptSphere<dimension> best;
  // The share of the thickness by which the core is shorter than the balls' centres reach.
  for (const double shorter : {0.0, 0.5, 0.75, 1.0}) {
    SweptSphere<dimension> next{point_in_frame(axes, near, centre_of(along)), axes, {}, 0};
    double thickness = 0;
    for (int i = static_cast<int>(dimension); i < 3; ++i) thickness = std::max(thickness, reach[i]);
    for (std::size_t i = 0; i < dimension; ++i)
      next.half[i] = std::max(0.0, reach[static_cast<int>(i)] - shorter * thickness);
    next.radius = radius_around(next, balls);
    if (is_empty(best) || half_area(next) < half_area(best)) best = next;
    if (thickness == 0) break;
  }
  // Where centres are not finite, neither is any distance to them.
  if (!is_finite(best.centre)) best = {{}, {}, {}, infinity};
  return best;
}

std::vector<Ball> as_balls(std::span<const Vec3> points) {
  std::vector<Ball> balls;
  balls.reserve(points.size());
  for (const Vec3& p : points) balls.push_back({p, 0});
  return balls;
}

template <std::size_t dimension>
SweptSphere<dimension> fit_swept(std::span<const Vec3> points, const Mat3& axes) {
  const Aabb box = checked_box(points);
  if (is_empty(box)) return {};
  return around<dimension>(axes, centre_of(box), as_balls(points));
}

/// The hull of the balls at the corners of the core is the volume.
template <std::size_t dimension>
std::vector<Ball> corner_balls(const SweptSphere<dimension>& v) {
  std::vector<Ball> balls;
  for (unsigned corner = 0; corner < 1U << dimension; ++corner) {
    Vec3 s;
    for (unsigned i = 0; i < dimension; ++i) s[static_cast<int>(i)] = (corner >> i & 1U) != 0 ? v.half[i] : -v.half[i];
    balls.push_back({core_point(v, s), v.radius});
  }
  return balls;
}

/// What a corner that is computed, and what `contains` asks later, are off by.
template <std::size_t dimension>
double slack_of(const SweptSphere<dimension>& v) {
  double size = v.radius;
  for (const double half : v.half) size += half;
  return 0x1p-44 * size + 0x1p-50 * largest_magnitude(v.centre);
}

}  // namespace

template <>
Pss fit<Pss>(std::span<const Vec3> points) {
  const Ball ball = fit<Ball>(points);
  Pss fitted{ball.centre, {}, {}, ball.radius};
  for (const Vec3& p : points) fitted.radius = std::max(fitted.radius, core_distance_bound(fitted, p));
  return fitted;
}
template <>
Lss fit<Lss>(std::span<const Vec3> points) {
  return fit_swept<1>(points, principal_axes(points).axes);
}
template <>
Rss fit<Rss>(std::span<const Vec3> points) {
  return fit_swept<2>(points, principal_axes(points).axes);
}
template <>
Pss fit<Pss>(std::span<const Triangle> triangles) {
  return fit<Pss>(corners_of(triangles));
}
template <>
Lss fit<Lss>(std::span<const Triangle> triangles) {
  return fit_swept<1>(corners_of(triangles), principal_axes(triangles).axes);
}
template <>
Rss fit<Rss>(std::span<const Triangle> triangles) {
  return fit_swept<2>(corners_of(triangles), principal_axes(triangles).axes);
}

template <std::size_t dimension>
double support_bound(const SweptSphere<dimension>& v, const Vec3& direction, const Vec3& from) {
  if (is_empty(v)) return -infinity;
  UpperSum sum;
  sum.add(direction, v.centre - from);
  for (std::size_t i = 0; i < dimension; ++i) {
    UpperSum along;
    along.add(direction, v.axes[static_cast<int>(i)]);
    sum.add(along.magnitude_bound(), v.half[i]);
  }
  sum.add(v.radius, length_bound(direction));
  return sum.bound();
}

template <std::size_t dimension>
Vec3 farthest_core_point(const SweptSphere<dimension>& v, const Vec3& direction) {
  Vec3 s;
  for (std::size_t i = 0; i < dimension; ++i) {
    const int axis = static_cast<int>(i);
    s[axis] = dot(direction, v.axes[axis]) < 0 ? -v.half[i] : v.half[i];
  }
  return core_point(v, s);
}

template <std::size_t dimension>
Vec3 farthest_point(const SweptSphere<dimension>& v, const Vec3& direction) {
  return farthest_point(Ball{farthest_core_point(v, direction), v.radius}, direction);
}

template <std::size_t dimension>
SweptSphere<dimension> merge(const SweptSphere<dimension>& a, const SweptSphere<dimension>& b) {
  if (is_empty(a) || is_empty(b)) return is_empty(a) ? b : a;
  std::vector<Ball> balls = corner_balls(a);
  for (const Ball& ball : corner_balls(b)) balls.push_back(ball);
  std::vector<Vec3> centres;
  for (const Ball& ball : balls) centres.push_back(ball.centre);
  const bool in_range = std::all_of(centres.begin(), centres.end(),
                                    [](const Vec3& p) { return largest_magnitude(p) <= greatest_fitted_coordinate; });
  const Mat3 axes = in_range ? principal_axes(centres).axes : Mat3{};
  SweptSphere<dimension> merged;
  if constexpr (dimension == 0) {
    const Ball ball = merge(balls[0], balls[1]);
    merged = {ball.centre, {}, {}, ball.radius};
  } else {
    merged = around<dimension>(axes, 0.5 * a.centre + 0.5 * b.centre, balls);
  }
  merged.radius = rounded_up(merged.radius + (slack_of(a) + slack_of(b) + slack_of(merged)));
  return merged;
}

template <std::size_t dimension>
bool contains(const SweptSphere<dimension>& v, const Vec3& point) {
  return !is_empty(v) && core_distance_bound(v, point) <= v.radius;
}

template <std::size_t dimension>
SweptSphere<dimension> posed(const SweptSphere<dimension>& v, const Pose& pose) {
  if (is_empty(v)) return {};
  const Pose turn{pose.linear, {}};
  const Mat3 axes = orthonormal_axes(transform(turn, v.axes[0]), transform(turn, v.axes[1]));
  const double radius = rounded_up(stretch_bound(pose.linear) * (v.radius + slack_of(v)) +
                                   length_bound(posing_slack(pose, box_around(v))));
  std::vector<Ball> balls;
  for (const Ball& ball : corner_balls(v)) balls.push_back({transform(pose, ball.centre), radius});
  SweptSphere<dimension> turned = around<dimension>(axes, transform(pose, v.centre), balls);
  turned.radius = rounded_up(turned.radius + slack_of(turned));
  if (!(turned.radius < infinity) || !is_finite(turned.centre)) return {{}, {}, {}, infinity};
  return turned;
}

template <std::size_t dimension>
Aabb box_around(const SweptSphere<dimension>& v) {
  return box_by_supports(v);
}

namespace {

struct Sizes {
  double unit = 0;
  double radius = 0;
  double perimeter = 0;  ///< of the core; of a segment twice its length
  double area = 0;       ///< of the core
};

/// In a unit in which nothing overflows.
template <std::size_t dimension>
Sizes sizes_of(const SweptSphere<dimension>& v) {
  double unit = v.radius;
  for (const double half : v.half) unit = std::max(unit, half);
  if (!(unit > 0)) return {};
  if (!(unit <= std::numeric_limits<double>::max())) return {unit, 1, 1, 1};
  Sizes sizes{unit, v.radius / unit, 0, 0};
  for (const double half : v.half) sizes.perimeter += 4 * (half / unit);
  if constexpr (dimension == 2) sizes.area = 4 * (v.half[0] / unit) * (v.half[1] / unit);
  return sizes;
}

}  // namespace

// J. Steiner's formulas for a flat body.

template <std::size_t dimension>
double measure(const SweptSphere<dimension>& v) {
  const auto [unit, r, perimeter, area] = sizes_of(v);
  const double disc = std::numbers::pi * r * r;
  return (2 * area * r + perimeter * disc / 2 + 4 * disc * r / 3) * unit * unit * unit;
}

template <std::size_t dimension>
double surface_area(const SweptSphere<dimension>& v) {
  const auto [unit, r, perimeter, area] = sizes_of(v);
  return (2 * area + std::numbers::pi * r * perimeter + 4 * std::numbers::pi * r * r) * unit * unit;
}

template <std::size_t dimension>
double half_area(const SweptSphere<dimension>& v) {
  return surface_area(v) / 2;
}

#define TOCCATA_INSTANTIATE_SWEPT_SPHERE(V)                          \
  template double support_bound(const V&, const Vec3&, const Vec3&); \
  template Vec3 farthest_point(const V&, const Vec3&);               \
  template V merge(const V&, const V&);                              \
  template bool contains(const V&, const Vec3&);                     \
  template V posed(const V&, const Pose&);                           \
  template Aabb box_around(const V&);                                \
  template double measure(const V&);                                 \
  template double surface_area(const V&);                            \
  template double half_area(const V&);                               \
  TOCCATA_INSTANTIATE_VOLUME(V)

TOCCATA_INSTANTIATE_SWEPT_SPHERE(Pss);
TOCCATA_INSTANTIATE_SWEPT_SPHERE(Lss);
TOCCATA_INSTANTIATE_SWEPT_SPHERE(Rss);

}  // namespace toccata
