#pragma once

#include <optional>

#include "world/character_mover/thing_planes.hpp"

namespace toccata {

/// A polytope, grown by a ball, that goes along a straight way: which part of the way the planes of things leave.
class PlaneCast {
 public:
  /// What stays so far is not met.
  struct Reach {
    double distance = 0;        ///< of the polytope, what it is grown by included
    double spare = 0;           ///< more than that distance and the times at which things are met may be off by
    double parallel_speed = 0;  ///< a plane is not approached by less
  };

  /// The corners have to outlive it.
  PlaneCast(const FewCorners& corners, const Vec3& motion, const Reach& reach);

  /// Fractions of the way; more than 1: it is not met.
  struct Times {
    double free = 0;      ///< by the planes, one by one
    double earliest = 0;  ///< with a little to spare, and of a triangle by its face and a side together
  };
  [[nodiscard]] Times times_of(const ThingPlanes& planes) const;

  /// Its face keeps the triangle away.
  [[nodiscard]] bool is_kept_off(const TriangleFace& face) const;

 private:
  struct Heights {
    double excess;    ///< over the distance at which it is met
    double approach;  ///< in the whole way
  };
  [[nodiscard]] double distance_from(double extent, double radius) const;
  [[nodiscard]] Heights heights_over(const ThingPlanes::Plane& plane, double distance) const;
  [[nodiscard]] double free_of(const Heights& heights) const;
  [[nodiscard]] double earliest_beside(const ThingPlanes& planes, const std::array<Heights, 2>& face, double side,
                                       double distance) const;

  const FewCorners& corners_;
  Vec3 motion_;
  Reach reach_;
};

}  // namespace toccata
