#pragma once

#include "toccata/bounds/aabb.hpp"
#include "toccata/math/mat3.hpp"

namespace toccata {

/// How rays of the world come into the units of a tree, from its origin: docs/design/rays.md, whose names and bounds
/// these are.
struct RayFrame {
  Mat3 back;               ///< about the inverse of the pose's matrix, in the tree's units
  Vec3 offset;             ///< of the pose
  Vec3 origin;             ///< of the tree, in its units
  Aabb box;                ///< of the tree, in its units
  double off = 0;          ///< what a point is off by
  double off_by_size = 0;  ///< and what more of it, for each unit of the greatest coordinate in the world
  bool has_units = true;   ///< the tree's coordinates are at most 1
  bool usable = true;      ///< else nothing of the above is known
};

}  // namespace toccata
