#pragma once

#include <array>
#include <limits>

#include "toccata/math/pose.hpp"
#include "toccata/shapes/primitives.hpp"

namespace toccata {

/// A box at its place, seen as centre ± half_extents[i] · column i of the pose's linear part, the formula of a box
/// under a pose that hardly deforms. Together with that linear part it is what the formulas for two boxes read.
struct RigidBox {
  Vec3 centre;  ///< in the world
  Vec3 half_extents;
  /// No world corner is farther than this from where the formula has it; infinite where nothing may be concluded from
  /// the formula: the shape is no box, the pose deforms it, or its numbers are beyond 2^1000.
  double slack = std::numeric_limits<double>::infinity();
  double skew = 0;  ///< at least every |RᵀR − I|
};

/// The box at its place; its slack is infinite where the pose has a number that is not finite.
[[nodiscard]] RigidBox rigid_box(const Box& box, const Pose& pose);

}  // namespace toccata

// Round and boxy shapes at their places, in the form that the closed formulas want. All in world coordinates and
// units. A shape is posed once and asked about many times; a world Triangle needs no such form.
namespace toccata {

/// All points within `radius` of the centre.
struct PosedSphere {
  Vec3 centre;
  double radius = 0;

  PosedSphere() = default;
  /// In place. Precondition: finite, and the radius is positive.
  PosedSphere(const Vec3& world_centre, double world_radius) : centre(world_centre), radius(world_radius) {}
  /// Throws Error when the pose or the world centre is not finite, or the pose deforms (docs/truth.md).
  explicit PosedSphere(const Sphere& shape, const Pose& pose = {});
};

/// All points within `radius` of the segment; its ends may be equal.
struct PosedCapsule {
  Vec3 start;
  Vec3 end;
  double radius = 0;

  PosedCapsule() = default;
  /// In place. Precondition: finite, and the radius is positive.
  PosedCapsule(const Vec3& world_start, const Vec3& world_end, double world_radius)
      : start(world_start), end(world_end), radius(world_radius) {}
  /// Throws Error as for a sphere.
  explicit PosedCapsule(const Capsule& shape, const Pose& pose = {});
};

/// An oriented box. The set is the hull of the eight rounded world corners; the formulas look at the parallelepiped
/// centre ± half_axis, and know how far the two may differ.
struct PosedBox {
  Pose pose;
  RigidBox rigid;  ///< as the formulas for two boxes see it, which read nothing but this and the pose
  Box shape;
  Vec3 centre;
  std::array<Vec3, 3> half_axis;  ///< from the centre to the face's, along each axis of the shape
  Vec3 inverse_squared;           ///< 1 / |half_axis|², of each
  double size = 0;                ///< at least the sum of all coordinates' magnitudes of the half axes
  double corner_slack = 0;        ///< no world corner is farther than this from its counterpart

  /// Throws Error when the pose or a world corner is not finite, or the pose is singular.
  explicit PosedBox(const Box& box, const Pose& box_pose = {});
};

}  // namespace toccata
