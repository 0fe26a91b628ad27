#pragma once

#include "toccata/core/function_ref.hpp"
#include "toccata/motion/rigid_motion.hpp"
#include "toccata/world/body.hpp"

namespace toccata {

/// Contains the body wherever it is on its way, without its margin. Throws Error as `body_box` does.
[[nodiscard]] Aabb swept_box(const Body& body, const RigidMotion& motion, FunctionRef<std::string()> who);

}  // namespace toccata
