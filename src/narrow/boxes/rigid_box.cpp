#include "toccata/narrow/posed_shapes.hpp"

#include <cmath>

#include "narrow/boxes/box_slack.hpp"

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

}  // namespace

RigidBox rigid_box(const Box& box, const Pose& pose) {
  RigidBox result{transform(pose, box.centre()), box.half_extents()};
  result.skew = skew_of(pose.linear);
  const double slack = slack_of(box, pose);
  if (result.skew <= largest_rigid_skew && slack < 0x1p940) result.slack = slack;
  return result;
}

}  // namespace toccata
