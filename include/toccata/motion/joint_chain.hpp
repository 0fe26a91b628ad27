#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "toccata/core/index.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/math/vec3.hpp"
#include "toccata/motion/rigid_motion.hpp"

namespace toccata {

enum class JointKind : std::uint8_t {
  revolute,   ///< turns about its axis; its position is in degrees, counter-clockwise seen against the axis
  prismatic,  ///< slides along its axis; its position is in world units
};

/// What a link of a robot hangs on, as URDF describes it. At the position 0 the frame of the link is `origin` in the
/// frame of the link before; from there the joint turns or slides it.
struct Joint {
  JointKind kind = JointKind::revolute;
  Pose origin{};                  ///< a rotation and a translation
  Vec3 axis{0, 0, 1};             ///< in the link's frame, through its origin; of any length above 0
  std::optional<Index> parent{};  ///< the joint whose link it hangs on, one before it; none: the base
};

/// Where the links are when the joints are at these positions, one each: pose(parent) · origin · R(axis, position), or
/// · position · axis / |axis|, composed from the base outwards. Throws Error naming the joint when there is not one
/// position for each, a number is not finite, an axis is zero, a parent does not come before its joint, or an origin
/// scales, shears or mirrors (is off from a rotation by more than 2⁻⁴⁰).
[[nodiscard]] std::vector<Pose> link_poses(std::span<const Joint> joints, std::span<const double> positions,
                                           const Pose& base = {});

/// How each link moves while all joints go from one configuration to another, each at an even speed, in the time from 0
/// to 1: to be asked about with `sweep`, of what is fixed to a link with `carrying`. A link below one joint that moves
/// makes a move, below none it rests. Below more it is a motion given by a function, which is `link_poses`, with the
/// bound
///
///     turns ≤ Σ |rate of a revolute joint|        speed of the link's origin ≤ Σ |rate| · reach + Σ |rate of a
///     prismatic|
///
/// over the joints that it hangs on, where the reach is what is between a joint and the link: the lengths of the
/// origins and how far what slides is out at most. X. Zhang, S. Redon, M. Lee, Y. J. Kim, "Continuous collision
/// detection for articulated models using Taylor models and temporal culling", 2007, section 4, has tighter ones.
/// Throws like `link_poses`; the base is a rotation and a translation too.
[[nodiscard]] std::vector<RigidMotion> link_motions(std::span<const Joint> joints, std::span<const double> from,
                                                    std::span<const double> to, const Pose& base = {});

}  // namespace toccata
