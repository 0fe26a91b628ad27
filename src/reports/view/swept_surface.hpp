#pragma once

#include <vector>

#include "toccata/motion/rigid_motion.hpp"

namespace toccata::io {

/// What is drawn of the volume that a body passes (swept_volume): triangles, three corners each, without those that lie
/// inside the volume. Nothing of a half-space, and of what rests.
[[nodiscard]] std::vector<Vec3> swept_surface(const Model& body, const RigidMotion& motion, Solid solid);

}  // namespace toccata::io
