#include "toccata/query/scene_index.hpp"

#include "query/posed_shape.hpp"
#include "query/scenes/object_search.hpp"
#include "query/scenes/posed_name.hpp"

namespace toccata {
namespace {

/// `ask(objects)` of all models that pass the filter.
template <class Ask>
auto ask_all(const SceneIndex& index, const ObjectFilter& filter, const Ask& ask) {
  const std::span<const SceneInstance> models = index.models();
  const auto at = [&](Index object) {
    const SceneInstance& posed = models[object];
    return InstanceView{posed.model, posed.pose, posed.solid};
  };
  const auto name_of = [&](Index object) { return name_for_messages(models[object], object); };
  const auto accepts = [&](Index object) { return !filter || filter(object); };
  return ask(SearchedObjects{index.boxes(), at, name_of, accepts});
}

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

SceneIndex::SceneIndex(std::span<const SceneInstance> models)
    : models_(models.begin(), models.end()), boxes_(boxes_of(models)) {}

std::optional<ObjectRayHit> SceneIndex::cast_ray(const Ray& ray, const ObjectFilter& filter) const {
  return ask_all(*this, filter, [&](const SearchedObjects& objects) { return first_ray_hit(objects, ray); });
}

std::vector<ObjectRayHit> SceneIndex::cast_ray_through(const Ray& ray, const ObjectFilter& filter) const {
  return ask_all(*this, filter, [&](const SearchedObjects& objects) { return all_ray_hits(objects, ray); });
}

std::optional<ObjectCast> SceneIndex::cast_shape(const MovingShape& moving, const ObjectFilter& filter) const {
  Workspace workspace;
  return ask_all(*this, filter, [&](const SearchedObjects& objects) { return first_cast(objects, moving, workspace); });
}

std::vector<Index> SceneIndex::overlapping(const SceneInstance& shape, const ObjectFilter& filter) const {
  Workspace workspace;
  return ask_all(*this, filter,
                 [&](const SearchedObjects& objects) { return overlapping_objects(objects, shape, workspace); });
}

std::vector<ObjectRelation> SceneIndex::relations(const SceneInstance& shape, const ObjectFilter& filter) const {
  Workspace workspace;
  return ask_all(*this, filter,
                 [&](const SearchedObjects& objects) { return related_objects(objects, shape, workspace); });
}

std::optional<ObjectDistance> SceneIndex::nearest(const SceneInstance& shape, double max_distance,
                                                  const ObjectFilter& filter) const {
  Workspace workspace;
  return ask_all(*this, filter, [&](const SearchedObjects& objects) {
    return nearest_object(objects, shape, max_distance, workspace);
  });
}

std::vector<Index> SceneIndex::within(const SceneInstance& shape, double distance, const ObjectFilter& filter) const {
  Workspace workspace;
  return ask_all(*this, filter,
                 [&](const SearchedObjects& objects) { return objects_within(objects, shape, distance, workspace); });
}

std::vector<std::optional<ObjectRayHit>> SceneIndex::cast_ray_each(std::span<const Ray> rays,
                                                                   const ObjectFilter& filter,
                                                                   const BatchOptions& options) const {
  return ask_all(*this, filter, [&](const SearchedObjects& objects) { return first_ray_hits(objects, rays, options); });
}

std::vector<std::optional<ObjectCast>> SceneIndex::cast_shape_each(std::span<const MovingShape> moving,
                                                                   const ObjectFilter& filter,
                                                                   const BatchOptions& options) const {
  return ask_all(*this, filter, [&](const SearchedObjects& objects) { return first_casts(objects, moving, options); });
}

std::vector<std::vector<Index>> SceneIndex::overlapping_each(std::span<const SceneInstance> shapes,
                                                             const ObjectFilter& filter,
                                                             const BatchOptions& options) const {
  return ask_all(*this, filter,
                 [&](const SearchedObjects& objects) { return objects_overlapping_each(objects, shapes, options); });
}

std::vector<std::optional<ObjectDistance>> SceneIndex::nearest_each(std::span<const SceneInstance> shapes,
                                                                    double max_distance, const ObjectFilter& filter,
                                                                    const BatchOptions& options) const {
  return ask_all(*this, filter, [&](const SearchedObjects& objects) {
    return nearest_objects(objects, shapes, max_distance, options);
  });
}

std::vector<std::vector<Index>> SceneIndex::within_each(std::span<const SceneInstance> shapes, double distance,
                                                        const ObjectFilter& filter, const BatchOptions& options) const {
  return ask_all(*this, filter, [&](const SearchedObjects& objects) {
    return objects_within_each(objects, shapes, distance, options);
  });
}

}  // namespace toccata
