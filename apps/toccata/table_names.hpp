#pragma once

#include <span>
#include <string>
#include <vector>

#include "toccata/shapes/scene.hpp"

namespace toccata::command {

/// The names of objects as a table shows them: printable, and where one is longer than 40 characters without its
/// middle, "begin…end". No two different names become equal: more of them is left.
std::vector<std::string> table_names(std::span<const SceneObject> objects);

}  // namespace toccata::command
