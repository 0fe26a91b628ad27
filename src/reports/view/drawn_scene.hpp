#pragma once

#include <span>
#include <vector>

#include "toccata/reports/scene_question.hpp"

namespace toccata::io {

/// Objects as they are drawn.
struct DrawnScene {
  Scene scene;
  std::vector<SceneInstance> models;  ///< of its objects, in their order
};

/// The objects that an answer is about: those of costs where the first of the queries has them, the convex parts
/// instead of the mesh that was cut, and beside A and B their sum.
[[nodiscard]] DrawnScene drawn_scene(const Scene& scene, std::span<const SceneInstance> models,
                                     const SceneAnswer& answer);

}  // namespace toccata::io
