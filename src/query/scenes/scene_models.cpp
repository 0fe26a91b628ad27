#include "toccata/query/check_all.hpp"

#include <map>
#include <optional>
#include <utility>

#include "toccata/core/parallel.hpp"

namespace toccata {

std::vector<SceneInstance> scene_models(const Scene& scene, int threads) {
  // Objects that share a mesh share its model and its trees.
  std::map<std::pair<const TriangleMesh*, std::size_t>, std::size_t> slot_of;
  std::vector<std::size_t> slots;
  std::vector<const Shape*> shapes;
  for (const SceneObject& object : scene.objects) {
    const auto mesh = object.mesh();
    const std::size_t slot =
        mesh ? slot_of.emplace(std::pair(mesh.get(), object.shape.index()), shapes.size()).first->second
             : shapes.size();
    if (slot == shapes.size()) shapes.push_back(&object.shape);
    slots.push_back(slot);
  }

  std::vector<std::optional<Model>> models(shapes.size());
  parallel_for(shapes.size(), threads, [&](std::size_t i) { models[i].emplace(*shapes[i]); });

  std::vector<SceneInstance> posed;
  posed.reserve(scene.objects.size());
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const SceneObject& object = scene.objects[i];
    posed.push_back({*models[slots[i]], object.pose, object.solid, object.name, object.group});
  }
  return posed;
}

}  // namespace toccata
