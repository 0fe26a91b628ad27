#pragma once

#include "io/formats/json.hpp"
#include "io/scenes/scene_shape.hpp"
#include "toccata/shapes/scene.hpp"

namespace toccata::io {

// What scene files are written of.

/// Throws Error naming the object when a name or group is not UTF-8, a name is empty, or two are alike.
void require_writable(const Scene& scene);

/// The members in front of the objects.
[[nodiscard]] Json scene_head(const Scene& scene);

/// A node: its name, its parent's number, and its pose where it has one.
[[nodiscard]] Json json_of(const SceneNode& node);

/// An object without its source and node; its mesh is what `write_mesh` gives.
[[nodiscard]] Json json_of(const SceneObject& object, const MeshWriting& write_mesh);

}  // namespace toccata::io
