#pragma once

#include <memory>
#include <string>
#include <utility>

#include "toccata/shapes/scene.hpp"

namespace toccata {

using SharedMesh = std::shared_ptr<const TriangleMesh>;

inline SharedMesh shared(TriangleMesh mesh) { return std::make_shared<const TriangleMesh>(std::move(mesh)); }

/// Adds an object; returns it for what is unusual about it.
inline SceneObject& add(Scene& scene, std::string name, SharedMesh mesh, const Pose& pose = {}) {
  SceneObject object;
  object.name = std::move(name);
  object.shape = std::move(mesh);
  object.pose = pose;
  object.source = "generated: " + object.name;
  scene.objects.push_back(std::move(object));
  return scene.objects.back();
}

}  // namespace toccata
