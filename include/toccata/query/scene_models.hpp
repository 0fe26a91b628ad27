#pragma once

#include <vector>

#include "toccata/query/check_all.hpp"
#include "toccata/shapes/scene.hpp"

namespace toccata {

/// The scene's objects ready for `check_all`, in the scene's order. Objects that share a mesh share one Model.
[[nodiscard]] std::vector<SceneInstance> scene_models(const Scene& scene, int threads = 0);

}  // namespace toccata
