#include "toccata/query/scene_index.hpp"

#include "query/posed_shape.hpp"
#include "query/scenes/object_queries.hpp"
#include "query/scenes/posed_name.hpp"

namespace toccata {
namespace {

std::vector<Aabb> boxes_of(std::span<const SceneInstance> models) {
  std::vector<Aabb> boxes;
  boxes.reserve(models.size());
  for (std::size_t i = 0; i < models.size(); ++i) {
    const SceneInstance& posed = models[i];
    boxes.push_back(world_box(pose_model(posed.model, posed.pose, posed.solid, name_for_messages(posed, i))));
  }
  return boxes;
}

}  // namespace

InstanceView SceneObjects::at(Index object) const {
  const SceneInstance& posed = models[object];
  return {posed.model, posed.pose, posed.solid};
}

std::string SceneObjects::name_of(Index object) const { return name_for_messages(models[object], object); }

SceneIndex::SceneIndex(std::span<const SceneInstance> models) : ObjectQueries({{models.begin(), models.end()}}) {
  boxes_ = BoxBvh(boxes_of(models));
}

template class ObjectQueries<SceneObjects>;

}  // namespace toccata
