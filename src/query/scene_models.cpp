#include "toccata/query/scene_models.hpp"

#include <map>
#include <optional>

#include "toccata/core/parallel.hpp"

namespace toccata {

std::vector<Posed> scene_models(const Scene& scene, int threads) {
  std::map<const TriangleMesh*, std::size_t> slot_of_mesh;
  std::vector<std::shared_ptr<const TriangleMesh>> meshes;
  for (const SceneObject& object : scene.objects)
    if (slot_of_mesh.emplace(object.mesh.get(), meshes.size()).second) meshes.push_back(object.mesh);

  std::vector<std::optional<Model>> models(meshes.size());
  parallel_for(meshes.size(), threads, [&](std::size_t i) { models[i].emplace(meshes[i]); });

  std::vector<Posed> posed;
  posed.reserve(scene.objects.size());
  for (const SceneObject& object : scene.objects)
    posed.push_back(
        {*models[slot_of_mesh.at(object.mesh.get())], object.pose, object.solid, object.name, object.group});
  return posed;
}

}  // namespace toccata
