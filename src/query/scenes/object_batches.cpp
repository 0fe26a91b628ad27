#include "query/ask_each.hpp"
#include "query/scenes/object_search.hpp"

namespace toccata {

std::vector<std::optional<ObjectRayHit>> first_ray_hits(const SearchedObjects& objects, std::span<const Ray> rays,
                                                        const BatchOptions& options) {
  return ask_each(rays, "ray", options, [&](const Ray& ray, Workspace&) { return first_ray_hit(objects, ray); });
}

std::vector<std::optional<ObjectCast>> first_casts(const SearchedObjects& objects, std::span<const MovingShape> moving,
                                                   const BatchOptions& options) {
  return ask_each(moving, "shape", options,
                  [&](const MovingShape& one, Workspace& workspace) { return first_cast(objects, one, workspace); });
}

std::vector<std::vector<Index>> objects_overlapping_each(const SearchedObjects& objects,
                                                         std::span<const SceneInstance> shapes,
                                                         const BatchOptions& options) {
  return ask_each(shapes, "shape", options, [&](const SceneInstance& shape, Workspace& workspace) {
    return overlapping_objects(objects, shape, workspace);
  });
}

std::vector<std::optional<ObjectDistance>> nearest_objects(const SearchedObjects& objects,
                                                           std::span<const SceneInstance> shapes, double max_distance,
                                                           const BatchOptions& options) {
  return ask_each(shapes, "shape", options, [&](const SceneInstance& shape, Workspace& workspace) {
    return nearest_object(objects, shape, max_distance, workspace);
  });
}

std::vector<std::vector<Index>> objects_within_each(const SearchedObjects& objects,
                                                    std::span<const SceneInstance> shapes, double distance,
                                                    const BatchOptions& options) {
  return ask_each(shapes, "shape", options, [&](const SceneInstance& shape, Workspace& workspace) {
    return objects_within(objects, shape, distance, workspace);
  });
}

}  // namespace toccata
