#pragma once

#include <string>

#include "toccata/shapes/scene.hpp"

namespace toccata::command {

/// A mesh file, or a generated mesh, in the hole that it leaves in a wall, scaled by `factor` about the middle of its
/// box. The wall is a tenth of the mesh's greatest extent around it.
[[nodiscard]] Scene mould_scene(const std::string& file, double factor);

}  // namespace toccata::command
