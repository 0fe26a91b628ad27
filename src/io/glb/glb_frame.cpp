#include "io/glb/glb_frame.hpp"

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

}  // namespace toccata::io
