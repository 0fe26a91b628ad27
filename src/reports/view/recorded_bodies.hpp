#pragma once

#include <span>
#include <vector>

#include "reports/view/view_meshes.hpp"
#include "toccata/reports/pages.hpp"
#include "toccata/shapes/scene.hpp"

namespace toccata::io {

/// The bodies of a recording as objects, as they were first seen.
struct RecordedBodies {
  Scene scene;
  std::vector<SceneInstance> models;

  explicit RecordedBodies(std::span<const Body> objects);
};

/// Where they are in all frames.
[[nodiscard]] std::vector<ViewMeshes::Place> places_of(const WorldRecording& recording);

}  // namespace toccata::io
