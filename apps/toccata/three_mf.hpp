#pragma once

#include <string>
#include <vector>

#include "toccata/shapes/scene.hpp"

namespace toccata::command {

/// A scene of a file that `read_scene` does not read, and what is to be told about how it was read.
struct ConvertedScene {
  Scene scene;
  std::vector<std::string> notes;
};

/// The build of a 3MF file (3MF Consortium, "3D Manufacturing Format, Core Specification", 1.3): each item and each
/// component a node, each of their meshes an object, in the unit of the file. Objects that repeat share their mesh.
/// Every number is the double nearest to the text. Throws Error naming the file and what is wrong in it.
[[nodiscard]] ConvertedScene read_three_mf(const std::string& path);

}  // namespace toccata::command
