#pragma once

#include <map>

#include "toccata/bounds/aabb.hpp"
#include "toccata/core/index.hpp"
#include "toccata/motion/rigid_motion.hpp"

namespace toccata {

/// A body that goes along a motion in the next step.
struct BodyOnTheWay {
  RigidMotion motion;
  Aabb box;  ///< around all of its way
};

/// The bodies that are on their way, by index.
using BodiesOnTheWay = std::map<Index, BodyOnTheWay>;

}  // namespace toccata
