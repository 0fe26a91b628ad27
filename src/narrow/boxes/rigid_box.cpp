#include "toccata/narrow/posed_shapes.hpp"

#include <cmath>

#include "math/vec3_measures.hpp"

namespace toccata {
namespace {

/// Up to here a pose passes for rigid.
constexpr double largest_rigid_skew = 0x1p-20;

/// All entries in and beside the diagonal are added: more than the greatest, without choices. An entry is a sum of
/// three products that add up to 1.01 at most in magnitude where it is of use, off by 3 · 2^-53; to add them loses
/// less.
double skew_of(const Mat3& m) {
  const Vec3 x = m.column(0), y = m.column(1), z = m.column(2);
  const double lengths = (std::fabs(dot(x, x) - 1) + std::fabs(dot(y, y) - 1)) + std::fabs(dot(z, z) - 1);
  const double angles = (std::fabs(dot(x, y)) + std::fabs(dot(y, z))) + std::fabs(dot(z, x));
  return (lengths + angles) + 0x1p-50;
}

/// Let u = 2^-53, M the sum of |R| (|c| + h) over all products and |t| the sum of the offset's magnitudes. A world
/// corner is off by 4u M + u |t| at most (three products, three sums), by u M more where its local coordinates were
/// rounded, and the centre by 4u M + u |t|; about the origin of the shape's frame the last two are exact. A column of a
/// rigid pose has a sum of at most 1.74. The bounds below have a few percent to spare; underflow loses less than
/// 2^-1000.
double slack_of(const Box& box, const Pose& pose) {
  const double offset = sum_of_magnitudes(pose.offset), halves = sum_of_magnitudes(box.half_extents());
  const double centre = sum_of_magnitudes(box.centre());
  const double roundings = centre == 0 ? 7.5 * halves + 1.25 * offset : 16.5 * (halves + centre) + 2.25 * offset;
  return 0x1p-53 * roundings + 0x1p-1000;
}

}  // namespace

RigidBox rigid_box(const Box& box, const Pose& pose) {
  RigidBox result{transform(pose, box.centre()), box.half_extents()};
  result.skew = skew_of(pose.linear);
  const double slack = slack_of(box, pose);
  if (result.skew <= largest_rigid_skew && slack < 0x1p940) result.slack = slack;
  return result;
}

}  // namespace toccata
