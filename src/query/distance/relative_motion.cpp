#include "query/distance/relative_motion.hpp"

#include <algorithm>
#include <cmath>

#include "math/constants.hpp"
#include "math/vec3_measures.hpp"
#include "narrow/pose_checks.hpp"
#include "query/meshes/cull_bounds.hpp"

namespace toccata {
namespace {

/// x to linear · x + offset, in doubles.
struct AffineMotion {
  Mat3 linear;
  Vec3 offset;
};

AffineMotion difference(const AffineMotion& after, const AffineMotion& before) {
  return {{after.linear[0] - before.linear[0], after.linear[1] - before.linear[1], after.linear[2] - before.linear[2]},
          after.offset - before.offset};
}

/// Not less than the length, however small it is.
double length_or_more(const Vec3& v) {
  const double squared = dot(v, v);
  return squared > 0x1p-900 ? std::sqrt(squared) : sum_of_magnitudes(v);
}

/// The greatest length of linear · x + offset in the box.
double farthest(const AffineMotion& motion, const Aabb& box) {
  double length = 0;
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 x;
    for (int axis = 0; axis < 3; ++axis) x[axis] = (corner >> axis & 1) != 0 ? box.upper[axis] : box.lower[axis];
    const Vec3 moved = {dot(motion.linear[0], x) + motion.offset.x, dot(motion.linear[1], x) + motion.offset.y,
                        dot(motion.linear[2], x) + motion.offset.z};
    length = std::max(length, length_or_more(moved));
  }
  return length;
}

double in_world(const Pose& before, const Pose& after, const Aabb& box) {
  return farthest(difference({after.linear, after.offset}, {before.linear, before.offset}), box);
}

/// What places points of another frame within a rotated one.
AffineMotion seen_from(const Pose& own, const Pose& other) {
  AffineMotion seen;
  const Vec3 between = other.offset - own.offset;
  for (int i = 0; i < 3; ++i) {
    const Vec3 axis = own.linear.column(i);
    for (int j = 0; j < 3; ++j) seen.linear[i][j] = dot(axis, other.linear.column(j));
    seen.offset[i] = dot(axis, between);
  }
  return seen;
}

/// More than any point of the other box is away from the own frame's origin, and any of the own box.
double size_seen(const AffineMotion& other, const Aabb& other_box, const Aabb& own_box) {
  const Vec3 reach = largest_coordinates(other_box);
  double size = sum_of_magnitudes(largest_coordinates(own_box)) + sum_of_magnitudes(other.offset);
  for (int i = 0; i < 3; ++i) size += (sum_of_magnitudes(other.linear[i])) * std::max({reach.x, reach.y, reach.z});
  return size;
}

/// A rotation is one up to 2⁻⁴², so lengths seen from it are off by 2⁻⁴¹ of themselves and of the own point's; what is
/// rounded is much less.
double as_seen(const Pose& own_before, const Pose& own_after, const Aabb& own_box, const Pose& before,
               const Pose& after, const Aabb& box) {
  if (!is_surely_rigid(own_before.linear) || !is_surely_rigid(own_after.linear)) return infinity;
  const AffineMotion seen_before = seen_from(own_before, before), seen_after = seen_from(own_after, after);
  const double size = size_seen(seen_before, box, own_box) + size_seen(seen_after, box, own_box);
  return farthest(difference(seen_after, seen_before), box) + 0x1p-39 * size;
}

}  // namespace

double relative_motion(const Model& a, const Model& b, const Pose& a_before, const Pose& b_before, const Pose& a_after,
                       const Pose& b_after) {
  const Aabb &box_a = a.bounds(), &box_b = b.bounds();
  double motion = in_world(a_before, a_after, box_a) + in_world(b_before, b_after, box_b);
  motion = std::min(motion, as_seen(a_before, a_after, box_a, b_before, b_after, box_b));
  motion = std::min(motion, as_seen(b_before, b_after, box_b, a_before, a_after, box_a));
  // World vertices are rounded by some units of these sizes, and so is all that was computed here.
  const double sizes =
      (sum_of_magnitudes(world_sizes(a_before, box_a)) + sum_of_magnitudes(world_sizes(a_after, box_a))) +
      (sum_of_magnitudes(world_sizes(b_before, box_b)) + sum_of_magnitudes(world_sizes(b_after, box_b)));
  const double bound = motion * (1 + 0x1p-40) + (128 * unit_roundoff * sizes + 64 * smallest_double);
  return std::isfinite(bound) ? bound : infinity;
}

}  // namespace toccata
