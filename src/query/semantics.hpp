#pragma once

#include <string_view>

#include "toccata/math/pose.hpp"
#include "toccata/query/model.hpp"
#include "toccata/shapes/scene.hpp"

namespace toccata {

/// Whether the posed model is taken as the solid it encloses (docs/truth.md). Throws Error when it is asked about as a
/// solid that it cannot be: an open mesh under Solid::all, or a solid under a singular pose. `who` names the model in
/// the message.
[[nodiscard]] bool taken_as_solid(const Model& model, const Pose& pose, Solid solid, std::string_view who);

}  // namespace toccata
