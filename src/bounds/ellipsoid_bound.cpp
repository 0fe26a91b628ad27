#include "toccata/bounds/all_volumes.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <vector>

#include "bounds/frame.hpp"
#include "bounds/point_clouds.hpp"
#include "bounds/posed_bounds.hpp"
#include "bounds/separation.hpp"
#include "math/constants.hpp"
#include "toccata/math/mat3.hpp"

namespace toccata {
namespace {

constexpr double least_ratio = 0x1p-20;  // of the half axes
constexpr double growth = 1 + 0x1p-18;   // far more than the bounds of a few products of such ratios are off by

// What is smaller gets half axes far larger than itself: ratios of numbers near the least double tell nothing.
constexpr double least_trusted_size = 0x1p-960;
constexpr Vec3 least_half{0x1p-955, 0x1p-955, 0x1p-955};

constexpr EllipsoidBound everything{{}, {}, {infinity, infinity, infinity}};

/// Half axes that are not shorter than the ratio allows, nor than the slack needs to be a small part of them.
Vec3 with_least(const Vec3& half, double slack) {
  const double least = std::max(least_ratio * largest_magnitude(half), slack / least_ratio);
  return larger(half, {least, least, least});
}

/// No less than √Σ (s_i / half_i)² of a point.
double ratio_bound(const EllipsoidBound& v, const Vec3& point) {
  const Vec3 s = coordinate_bounds(v.axes, v.centre, point);
  Vec3 ratio;
  for (int axis = 0; axis < 3; ++axis)
    ratio[axis] = s[axis] == 0 || v.half[axis] == infinity ? 0 : s[axis] / v.half[axis];
  return length_bound(ratio);
}

/// A mean of weighted points, and their covariance in its eigenvectors.
struct Inertia {
  Vec3 mean;
  SymmetricEigen eigen;
};

Inertia inertia_of(std::span<const Vec3> points, std::span<const double> weights) {
  Inertia inertia;
  for (std::size_t i = 0; i < points.size(); ++i) inertia.mean = inertia.mean + weights[i] * points[i];
  Mat3 covariance{{Vec3{}, Vec3{}, Vec3{}}};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 y = points[i] - inertia.mean;
    for (int axis = 0; axis < 3; ++axis) covariance[axis] = covariance[axis] + (weights[i] * y[axis]) * y;
  }
  inertia.eigen = symmetric_eigen(covariance);
  const double least = std::max(inertia.eigen.values.x * least_ratio * least_ratio, 0x1p-200);
  inertia.eigen.values = larger(inertia.eigen.values, {least, least, least});
  return inertia;
}

double stretched_square(const Inertia& inertia, const Vec3& point) {
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double s = dot(inertia.eigen.axes[axis], point - inertia.mean);
    sum += s * s / inertia.eigen.values[axis];
  }
  return sum;
}

/// Khachiyan's weights: again and again the point that sticks out most gains weight. Points of magnitude about 1.
Inertia least_ellipsoid(std::span<const Vec3> points) {
  constexpr int rounds = 60;
  std::vector<double> weights(points.size(), 1 / static_cast<double>(points.size()));
  Inertia inertia = inertia_of(points, weights);
  for (int round = 0; round < rounds; ++round) {
    std::size_t farthest = 0;
    double square = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (const double next = stretched_square(inertia, points[i]); next > square) {
        square = next;
        farthest = i;
      }
    // At the optimum no point has more than the dimension, 3.
    if (square < 3.02) break;
    const double step = (square - 3) / (4 * square);
    for (double& weight : weights) weight *= 1 - step;
    weights[farthest] += step;
    inertia = inertia_of(points, weights);
  }
  return inertia;
}

/// Grows the half axes by one factor until every point is inside.
EllipsoidBound grown_around(EllipsoidBound v, std::span<const Vec3> points) {
  Vec3 reach;
  for (const Vec3& p : points) reach = larger(reach, coordinate_bounds(v.axes, v.centre, p));
  if (reach == Vec3{}) return {v.centre, v.axes, {}};
  if (largest_magnitude(reach) < least_trusted_size) return {v.centre, v.axes, least_half};
  v.half = with_least(largest_magnitude(v.half) > 0 ? v.half : reach, largest_magnitude(reach) * 0x1p-44);
  double factor = 0;
  for (const Vec3& p : points) factor = std::max(factor, ratio_bound(v, p));
  v.half = (factor * (1 + 0x1p-40)) * v.half;
  return v;
}

/// A body {offset + Σ u_i column_i, |u| ≤ 1}.
struct Image {
  Vec3 offset;
  std::array<Vec3, 3> column;
};

Image scaled_image(const Image& image, double factor) {
  return {factor * image.offset, {factor * image.column[0], factor * image.column[1], factor * image.column[2]}};
}

double size_of(const Image& image) {
  double size = largest_magnitude(image.offset);
  for (const Vec3& column : image.column) size = std::max(size, largest_magnitude(column));
  return size;
}

/// Axes and half axes in which the bodies together are as nearly round as their second moments can tell.
SymmetricEigen moments_of(std::span<const Image> images) {
  Mat3 sum{{Vec3{}, Vec3{}, Vec3{}}};
  const auto add = [&](const Vec3& x) {
    for (int axis = 0; axis < 3; ++axis) sum[axis] = sum[axis] + x[axis] * x;
  };
  for (const Image& image : images) {
    add(image.offset);
    for (const Vec3& column : image.column) add(column);
  }
  return symmetric_eigen(sum);
}

/// The ball around a body where space is stretched by 1 / half along the axes: no vector u of length 1 is mapped to
/// more than √‖HHᵀ‖∞.
Ball stretched_ball(const Mat3& axes, const Vec3& half, const Image& image) {
  Ball ball;
  std::array<Vec3, 3> rows;
  for (int i = 0; i < 3; ++i) {
    ball.centre[i] = dot(axes[i], image.offset) / half[i];
    for (std::size_t j = 0; j < 3; ++j)
      rows[static_cast<std::size_t>(i)][static_cast<int>(j)] = dot(axes[i], image.column[j]) / half[i];
  }
  double square = 0;
  for (const Vec3& p : rows)
    square = std::max(square, (std::fabs(dot(p, rows[0])) + std::fabs(dot(p, rows[1]))) + std::fabs(dot(p, rows[2])));
  ball.radius = std::sqrt(square);
  return ball;
}

/// An ellipsoid around bodies that are given relative to a point, and all within `slack` of them. No half axis is
/// shorter than 2⁻²⁰ of the longest or than 2²⁰ slack, so that skew axes and rounding are less than `growth`.
EllipsoidBound around(const Vec3& near, std::span<const Image> images, double slack) {
  double size = slack;
  for (const Image& image : images) size = std::max(size, size_of(image));
  if (size == 0) return {near, {}, {}};
  if (size < least_trusted_size) return {near, {}, least_half};
  if (!is_finite(near) || !(size <= std::numeric_limits<double>::max())) return everything;
  const double unit = std::clamp(size, 0x1p-1000, 0x1p1000);
  std::vector<Image> small;
  for (const Image& image : images) small.push_back(scaled_image(image, 1 / unit));
  const SymmetricEigen moments = moments_of(small);
  const auto root = [](double square) { return std::sqrt(std::max(square, 0.0)); };
  const Vec3 half = with_least({root(moments.values.x), root(moments.values.y), root(moments.values.z)}, slack / unit);
  Ball ball;
  for (const Image& image : small) ball = merge(ball, stretched_ball(moments.axes, half, image));
  // Where the half axes are as long as the slack asks for, the ball is small, and the slack no small part of it.
  ball.radius += slack / unit / std::min({half.x, half.y, half.z});
  const Vec3& s = ball.centre;
  const Vec3 centre = point_in_frame(moments.axes, {}, {s.x * half.x, s.y * half.y, s.z * half.z});
  const EllipsoidBound result{near + unit * centre, moments.axes, (unit * ball.radius * growth) * half};
  // Larger ones would overflow when they are asked about.
  const bool in_range = largest_magnitude(result.centre) < 0x1p1000 && largest_magnitude(result.half) < 0x1p1000;
  return in_range ? result : everything;
}

Image image_of(const EllipsoidBound& v, const Mat3& linear, const Vec3& offset) {
  const Pose turn{linear, {}};
  Image image{offset, {}};
  for (int i = 0; i < 3; ++i) image.column[static_cast<std::size_t>(i)] = v.half[i] * transform(turn, v.axes[i]);
  return image;
}

}  // namespace

template <>
EllipsoidBound fit<EllipsoidBound>(std::span<const Vec3> points) {
  const Aabb box = checked_box(points);
  if (is_empty(box)) return {};
  const CloudScale scale(box);
  std::vector<Vec3> near_one;
  near_one.reserve(points.size());
  for (const Vec3& p : points) near_one.push_back(scale(p));
  const Inertia inertia = least_ellipsoid(near_one);
  EllipsoidBound fitted{scale.back(inertia.mean), inertia.eigen.axes, {}};
  for (int axis = 0; axis < 3; ++axis) fitted.half[axis] = std::sqrt(3 * inertia.eigen.values[axis]) / scale.factor;
  if (box.lower == box.upper) fitted.centre = box.lower;
  return grown_around(fitted, points);
}

template <>
EllipsoidBound fit<EllipsoidBound>(std::span<const Triangle> triangles) {
  return fit<EllipsoidBound>(corners_of(triangles));
}

double support_bound(const EllipsoidBound& v, const Vec3& direction, const Vec3& from) {
  if (is_empty(v)) return -infinity;
  Vec3 along;
  for (int axis = 0; axis < 3; ++axis) {
    UpperSum sum;
    sum.add(direction, v.axes[axis]);
    along[axis] = rounded_up(sum.magnitude_bound() * v.half[axis]);
  }
  UpperSum sum;
  sum.add(direction, v.centre - from);
  sum.add(1, length_bound(along));
  return sum.bound();
}

Vec3 farthest_point(const EllipsoidBound& v, const Vec3& direction) {
  Vec3 s;
  for (int axis = 0; axis < 3; ++axis) s[axis] = v.half[axis] * dot(direction, v.axes[axis]);
  const double length = length_bound(s);
  if (!(length > 0)) return v.centre;
  for (int axis = 0; axis < 3; ++axis) s[axis] = v.half[axis] * (s[axis] / length);
  return point_in_frame(v.axes, v.centre, s);
}

EllipsoidBound merge(const EllipsoidBound& a, const EllipsoidBound& b) {
  if (is_empty(a) || is_empty(b)) return is_empty(a) ? b : a;
  const Vec3 near = 0.5 * a.centre + 0.5 * b.centre;
  const std::array<Image, 2> images{image_of(a, {}, a.centre - near), image_of(b, {}, b.centre - near)};
  const double size = std::max(size_of(images[0]), size_of(images[1]));
  return around(near, images, 0x1p-44 * size + 0x1p-50 * largest_magnitude(near));
}

bool contains(const EllipsoidBound& v, const Vec3& point) { return !is_empty(v) && ratio_bound(v, point) <= 1; }

EllipsoidBound posed(const EllipsoidBound& v, const Pose& pose) {
  if (is_empty(v)) return {};
  const std::array<Image, 1> image{image_of(v, pose.linear, {})};
  return around(transform(pose, v.centre), image, length_bound(posing_slack(pose, box_around(v))));
}

Aabb box_around(const EllipsoidBound& v) { return box_by_supports(v); }

double measure(const EllipsoidBound& v) {
  return is_empty(v) ? 0 : 4 * std::numbers::pi / 3 * v.half.x * v.half.y * v.half.z;
}

double surface_area(const EllipsoidBound& v) {
  const double size = largest_magnitude(v.half);
  if (is_empty(v) || size == 0) return 0;
  if (!(size <= std::numeric_limits<double>::max())) return size;
  constexpr double power = 1.6075;
  const double x = std::pow(v.half.x / size, power), y = std::pow(v.half.y / size, power);
  const double z = std::pow(v.half.z / size, power);
  return 4 * std::numbers::pi * std::pow(((x * y + y * z) + z * x) / 3, 1 / power) * size * size;
}

double half_area(const EllipsoidBound& v) { return surface_area(v) / 2; }

TOCCATA_INSTANTIATE_VOLUME(EllipsoidBound);

}  // namespace toccata
