#pragma once

#include <cstddef>
#include <cstdint>

#include "toccata/motion/rigid_motion.hpp"
#include "toccata/query/model.hpp"
#include "toccata/shapes/scene.hpp"

namespace toccata {

/// How finely a swept volume is made.
struct SweptVolumeOptions {
  /// How far outside of what is passed it may reach, in world units, at least 0. 0: a 32nd of the diagonal of the
  /// body's box at the start.
  double excess = 0;
  /// Convex parts, at least 1: refined no further where there are as many, whatever the excess. A body of more shapes,
  /// or a motion of more pieces, has a part for each.
  std::size_t max_parts = 1024;
  /// Whether meshes pass with their inside.
  Solid solid = Solid::automatic;
};

/// A shape that contains every point that a body passes in the time from 0 to 1, in world coordinates. That is proved,
/// for real times and with all roundings: `overlap`, `distance` and `cast_ray` may be asked about it as about any
/// model, at the pose Pose{}.
struct SweptVolume {
  /// A capsule of a sphere that moves straight on, a convex hull of a convex polytope that does, that hull grown by a
  /// radius of what turns, and a compound of such parts. At rest it is the body's own shapes. A mesh that is taken as a
  /// solid is itself a part too, where it starts: nothing else comes inside but through what its surface passes.
  Model model;
  /// No point of it is farther from a point that is passed, in world units. Proved; 0 says that all its points are.
  double excess = 0;
  /// The body rests, so that it is at each of these points at all times.
  bool rests = false;
  /// What its meshes are taken for: to be given to a question about `model` too.
  Solid solid = Solid::automatic;

  [[nodiscard]] bool is_exact() const { return excess == 0; }
};

/// The parts are hulls of both ends of a stretch of the motion: of a convex shape, and of a mesh of the triangles below
/// a node of its tree. What reaches farthest outside is refined first, in time or in space, whichever it is due to
/// (docs/methods/swept-volumes.md has the proofs). Throws Error for what `sweep` throws for at the poses of the start,
/// for a half-space that moves, when an option is out of its range, when a motion that is given by a function moved
/// faster than its bound, and when a coordinate of the volume is not finite.
[[nodiscard]] SweptVolume swept_volume(const Model& body, const RigidMotion& motion,
                                       const SweptVolumeOptions& options = {});

/// What the volumes of two bodies say of their meeting.
enum class SweptOverlap : std::uint8_t {
  never,    ///< they have no point in common at any time in [0, 1], also when each moves at a pace of its own
  maybe,    ///< both pass a place, or nearly; perhaps at different times
  certain,  ///< one rests and the other's volume is exact: they meet
};

/// Whether two bodies may meet on the way: do their volumes overlap? That says no more than *maybe*, but where one
/// rests and both volumes are exact. `sweep` says which, and when.
[[nodiscard]] SweptOverlap may_meet(const SweptVolume& a, const SweptVolume& b);

}  // namespace toccata
