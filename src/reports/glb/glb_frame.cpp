#include "reports/glb/glb_frame.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace toccata::io {
namespace {

Vec3 by_power(const Vec3& v, int exponent) {
  return {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
}

double greatest_part(const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

bool are_square(const Vec3& a, const Vec3& b) {
  constexpr double tolerance = 1e-6;  // of what decomposes matrices in floats
  return std::abs(dot(a, b)) <= tolerance * std::sqrt(dot(a, a) * dot(b, b));
}

/// x, y, z, w of the turn whose matrix has these columns (S. W. Shepperd, "Quaternion from rotation matrix", 1978):
/// from the greatest of its parts the others.
std::array<double, 4> quaternion_of(const std::array<Vec3, 3>& columns) {
  const auto at = [&](std::size_t row, std::size_t column) { return columns[column][static_cast<int>(row)]; };
  const double trace = at(0, 0) + at(1, 1) + at(2, 2);
  std::array<double, 4> q{};
  std::size_t i = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (at(k, k) > at(i, i)) i = k;
  const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
  if (trace >= at(i, i)) {
    q = {at(2, 1) - at(1, 2), at(0, 2) - at(2, 0), at(1, 0) - at(0, 1), 1 + trace};
  } else {
    q[i] = 1 + 2 * at(i, i) - trace;
    q[j] = at(i, j) + at(j, i);
    q[k] = at(i, k) + at(k, i);
    q[3] = at(k, j) - at(j, k);
  }
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (double& part : q) part /= length;
  return q;
}

}  // namespace

GlbFrame GlbFrame::around(const DisplayFrame& place) {
  constexpr double far_away = 16;  // sizes: four of the 24 bits of a float
  constexpr int ordinary = 40;     // floats go to 2^127, and programs multiply them
  GlbFrame frame;
  if (greatest_part(place.centre) > far_away * place.size) frame.origin = place.centre;
  if (std::abs(std::ilogb(place.size)) > ordinary) frame.exponent = std::ilogb(place.size);
  return frame;
}

GlbFrame GlbFrame::around(std::span<const Vec3> points) { return around(DisplayFrame::around(fit_aabb(points))); }

std::array<float, 3> GlbFrame::counted(const Vec3& point) const {
  const Vec3 near = by_power(point - origin, -exponent);
  return {static_cast<float>(near.x), static_cast<float>(near.y), static_cast<float>(near.z)};
}

Pose pose_between(const GlbFrame& world, const Pose& pose, const GlbFrame& own) {
  Pose node;
  for (int i = 0; i < 3; ++i) node.linear[i] = by_power(pose.linear[i], own.exponent - world.exponent);
  node.offset = by_power(transform(pose, own.origin) - world.origin, -world.exponent);
  return node;
}

bool can_be_a_node(const Pose& pose) {
  const Vec3 x = pose.linear.column(0), y = pose.linear.column(1), z = pose.linear.column(2);
  const double lengths = dot(x, x) * dot(y, y) * dot(z, z);
  return is_finite(pose) && std::isnormal(lengths) && are_square(x, y) && are_square(y, z) && are_square(z, x);
}

GlbTurn turn_of(const Pose& pose) {
  std::array<Vec3, 3> axes = {pose.linear.column(0), pose.linear.column(1), pose.linear.column(2)};
  Vec3 scale;
  for (std::size_t i = 0; i < 3; ++i) scale[static_cast<int>(i)] = std::sqrt(dot(axes[i], axes[i]));
  if (dot(cross(axes[0], axes[1]), axes[2]) < 0) scale.x = -scale.x;  // a mirror
  for (std::size_t i = 0; i < 3; ++i) axes[i] = (1 / scale[static_cast<int>(i)]) * axes[i];
  const std::array<double, 4> q = quaternion_of(axes);
  GlbTurn turn{};
  for (int i = 0; i < 3; ++i) {
    const auto place = static_cast<std::size_t>(i);
    turn.translation[place] = static_cast<float>(pose.offset[i]);
    turn.scale[place] = static_cast<float>(scale[i]);
  }
  for (std::size_t i = 0; i < 4; ++i) turn.rotation[i] = static_cast<float>(q[i]);
  return turn;
}

}  // namespace toccata::io
