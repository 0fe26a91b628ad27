#include "toccata/motion/joint_chain.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "math/vec3_measures.hpp"
#include "motion/point_bounds.hpp"
#include "narrow/pose_checks.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

constexpr double above_roundings =
    1 + 0x1p-30;  ///< more than the roundings of a bound, and than what origins may stretch

/// Bounds of speeds go by lengths, which a rotation keeps.
void require_rotation(const Pose& pose, std::string_view who) {
  require_finite(pose, who);
  double off = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      off = std::max(off, std::fabs(dot(pose.linear.column(i), pose.linear.column(j)) - (i == j ? 1 : 0)));
  const double volume = dot(pose.linear[0], cross(pose.linear[1], pose.linear[2]));
  if (!(off <= 0x1p-40) || volume < 0)
    throw Error(fmt::format("{}: its origin is off from a rotation by {:.3g}; Pose::nearest_rigid makes one of it", who,
                            volume < 0 ? 2 : off));
}

void require_joint(const Joint& joint, std::size_t number) {
  const std::string who = fmt::format("joint {}", number);
  require_rotation(joint.origin, who);
  if (!is_finite(joint.axis)) throw Error(fmt::format("{}: its axis is not finite", who));
  if (joint.axis == Vec3{}) throw Error(fmt::format("{}: its axis is zero; give a direction", who));
  if (joint.parent && *joint.parent >= number)
    throw Error(fmt::format("{}: its parent is joint {}, which does not come before it", who, *joint.parent));
}

void require_positions(std::span<const Joint> joints, std::span<const double> positions) {
  if (positions.size() != joints.size())
    throw Error(
        fmt::format("a chain of {} joints has {} positions; give one for each", joints.size(), positions.size()));
  for (std::size_t i = 0; i < positions.size(); ++i)
    if (!std::isfinite(positions[i])) throw Error(fmt::format("joint {}: its position is not finite", i));
}

void require_chain(std::span<const Joint> joints, const Pose& base) {
  require_rotation(base, "the base of a chain of joints");
  for (std::size_t i = 0; i < joints.size(); ++i) require_joint(joints[i], i);
}

Pose pose_at(const Joint& joint, double position) {
  if (joint.kind == JointKind::revolute) return joint.origin * Pose{rotation_about(joint.axis, position), {}};
  return joint.origin * Pose::translation(position * normalized(joint.axis));
}

/// A joint that goes from one position to another.
struct MovingJoint {
  Joint joint;
  double from;
  double to;

  [[nodiscard]] bool moves() const { return from != to; }
  [[nodiscard]] Pose at(double time) const { return pose_at(joint, time == 1 ? to : from + time * (to - from)); }
  /// In radians, or world units, per unit of time.
  [[nodiscard]] double rate() const {
    const double way = std::fabs(to - from) * above_roundings;
    return joint.kind == JointKind::revolute ? radians_in_a_turn / 360 * way : way;
  }
  /// From the frame of the link before to that of its own.
  [[nodiscard]] double length_at_most() const {
    const double out = joint.kind == JointKind::prismatic ? std::max(std::fabs(from), std::fabs(to)) : 0;
    return (length(joint.origin.offset) + out) * above_roundings;
  }
};

/// What a link hangs on, from the base outwards.
struct Chain {
  Pose base;
  std::vector<MovingJoint> joints;

  [[nodiscard]] Pose at(double time) const {
    Pose pose = base;
    for (const MovingJoint& joint : joints) pose = pose * joint.at(time);
    return pose;
  }
};

/// Turns that both ends have in common are only digits that are missing behind the point.
MovingJoint without_whole_turns(MovingJoint joint) {
  if (joint.joint.kind != JointKind::revolute) return joint;
  const double whole = 360 * std::trunc(joint.from / 360);
  joint.from -= whole;
  joint.to -= whole;
  return joint;
}

Chain chain_of(std::span<const Joint> joints, std::span<const double> from, std::span<const double> to,
               const Pose& base, Index link) {
  Chain chain{base, {}};
  for (std::optional<Index> i = link; i; i = joints[*i].parent)
    chain.joints.push_back(without_whole_turns({joints[*i], from[*i], to[*i]}));
  std::reverse(chain.joints.begin(), chain.joints.end());
  return chain;
}

/// The speed that a joint gives the origin of the link is that of the point of its axis, 0, and its rate times the
/// distance from there, which is not longer than the way along the links in between. Speeds of joints add up.
MotionSpeed speed_of(const Chain& chain) {
  MotionSpeed bound;
  double reach = 0;
  for (auto joint = chain.joints.rbegin(); joint != chain.joints.rend(); ++joint) {
    const bool turns = joint->joint.kind == JointKind::revolute;
    bound.speed += turns ? joint->rate() * reach : joint->rate();
    if (turns) bound.turns += std::fabs(joint->to - joint->from) / 360 * above_roundings;
    reach += joint->length_at_most();
  }
  bound.speed *= above_roundings;
  // Each pose of the chain rounds some tens of times, of lengths that are no greater than all together.
  const auto poses = static_cast<double>(1 + chain.joints.size());
  bound.rounding = 0x1p-46 * poses * (reach + sum_of_magnitudes(chain.base.offset));
  return bound;
}

/// About the axis of the one joint that moves, or along it.
RigidMove move_of(const Chain& chain, std::size_t moving) {
  Pose frame = chain.base;
  for (std::size_t i = 0; i < moving; ++i) frame = frame * chain.joints[i].at(0);
  const MovingJoint& joint = chain.joints[moving];
  frame = frame * joint.joint.origin;
  const Vec3 axis = Pose{frame.linear, {}} * normalized(joint.joint.axis);
  const double way = joint.to - joint.from;
  if (joint.joint.kind == JointKind::prismatic) return {.translation = way * axis};
  return {.centre = frame.offset, .axis = axis, .turns = way / 360};
}

RigidMotion motion_of(const Chain& chain) {
  const auto moves = [](const MovingJoint& joint) { return joint.moves(); };
  const auto moving = std::count_if(chain.joints.begin(), chain.joints.end(), moves);
  if (moving == 0) return chain.at(0);
  if (moving == 1) {
    const auto only = std::find_if(chain.joints.begin(), chain.joints.end(), moves);
    return {chain.at(0), move_of(chain, static_cast<std::size_t>(only - chain.joints.begin()))};
  }
  return RigidMotion::of([chain](double time) { return chain.at(time); }, speed_of(chain));
}

}  // namespace

std::vector<Pose> link_poses(std::span<const Joint> joints, std::span<const double> positions, const Pose& base) {
  require_chain(joints, base);
  require_positions(joints, positions);
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const Pose& before = joints[i].parent ? poses[*joints[i].parent] : base;
    poses.push_back(before * pose_at(joints[i], positions[i]));
  }
  return poses;
}

std::vector<RigidMotion> link_motions(std::span<const Joint> joints, std::span<const double> from,
                                      std::span<const double> to, const Pose& base) {
  require_chain(joints, base);
  require_positions(joints, from);
  require_positions(joints, to);
  std::vector<RigidMotion> motions;
  for (Index link = 0; link < joints.size(); ++link)
    motions.push_back(motion_of(chain_of(joints, from, to, base, link)));
  return motions;
}

}  // namespace toccata
