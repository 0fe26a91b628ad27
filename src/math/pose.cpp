#include "toccata/math/pose.hpp"

#include "math/world_vertex.hpp"
#include "toccata/math/predicates.hpp"

namespace toccata {

Pose Pose::from_numbers(const std::array<double, 12>& n) {
  Pose pose;
  pose.linear = {{{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]}}}};
  pose.offset = {n[9], n[10], n[11]};
  return pose;
}

std::array<double, 12> Pose::numbers() const {
  const auto& [r0, r1, r2] = linear.row;
  return {r0.x, r0.y, r0.z, r1.x, r1.y, r1.z, r2.x, r2.y, r2.z, offset.x, offset.y, offset.z};
}

// This function defines the truth. It lives here, in a file compiled with -ffp-contract=off, and not in the header, so
// that a user's compiler cannot fuse it.
Vec3 transform(const Pose& pose, const Vec3& v) { return world_vertex(pose, v); }

std::vector<Vec3> transform(const Pose& pose, std::span<const Vec3> locals) {
  std::vector<Vec3> world;
  world.reserve(locals.size());
  for (const Vec3& v : locals) world.push_back(transform(pose, v));
  return world;
}

Pose compose(const Pose& outer, const Pose& inner) {
  Pose result;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) result.linear[i][j] = row_times(outer.linear[i], inner.linear.column(j));
  result.offset = transform(outer, inner.offset);
  return result;
}

Pose scaled(const Pose& pose, double factor) {
  Pose result = pose;
  for (Vec3& row : result.linear.row) row = factor * row;
  return result;
}

bool is_finite(const Pose& pose) { return is_finite(pose.linear) && is_finite(pose.offset); }

bool is_singular(const Mat3& m) {
  const Vec3 zero{};
  return triple_product_sign({m[0], zero}, {m[1], zero}, {m[2], zero}) == Sign::zero;
}

}  // namespace toccata
