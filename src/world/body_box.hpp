#pragma once

#include "toccata/core/function_ref.hpp"
#include "toccata/world/body.hpp"

namespace toccata {

/// Contains the body at that pose, without its margin. Throws Error for a pose that is not finite or that the shape may
/// not have, and where the body is to be a solid that it is not; the message begins with what `who` returns, which is
/// only asked then.
[[nodiscard]] Aabb body_box(const Body& body, const Pose& pose, FunctionRef<std::string()> who);

}  // namespace toccata
