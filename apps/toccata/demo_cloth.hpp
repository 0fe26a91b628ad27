#pragma once

#include <string>

#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata::command {

struct ClothArguments {
  int steps = 1000;
  int cells = 20;
  int threads = 0;
};

/// Lets a cloth fall, looks at every frame exactly, and tells what it saw, in words or as JSON.
struct ClothAnswer {
  std::string text;
  std::string json;
  bool is_clean = true;  ///< no frame intersects itself or what it lies on
  TriangleMesh cloth;    ///< after the last step
  TriangleMesh obstacles;
};

[[nodiscard]] ClothAnswer fallen_cloth(const ClothArguments& arguments);

}  // namespace toccata::command
