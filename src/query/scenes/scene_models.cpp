#include "query/scenes/scene_models.hpp"

#include <map>
#include <optional>
#include <utility>

#include "toccata/core/parallel.hpp"

namespace toccata {

std::vector<SceneInstance> scene_models_by(const Scene& scene, int threads,
                                           FunctionRef<Model(const Shape& shape, int threads)> make) {
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

  // Few models are built on several threads each: one may be far larger than the others.
  const int of_each = shapes.size() < 2 * static_cast<std::size_t>(thread_count(threads)) ? threads : own_thread;
  std::vector<std::optional<Model>> models(shapes.size());
  parallel_for(shapes.size(), threads, [&](std::size_t i) { models[i].emplace(make(*shapes[i], of_each)); });

  std::vector<SceneInstance> posed;
  posed.reserve(scene.objects.size());
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const SceneObject& object = scene.objects[i];
    posed.push_back({*models[slots[i]], object.pose, object.solid, object.name, object.group});
  }
  return posed;
}

std::vector<SceneInstance> scene_models(const Scene& scene, int threads) {
  return scene_models_by(scene, threads, [](const Shape& shape, int of_each) { return Model(shape, of_each); });
}

}  // namespace toccata
