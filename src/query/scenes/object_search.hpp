#pragma once

#include <optional>
#include <string>
#include <vector>

#include "toccata/broad/box_bvh.hpp"
#include "toccata/core/function_ref.hpp"
#include "toccata/query/pair_query.hpp"
#include "toccata/query/scene_index.hpp"

// The questions of SceneIndex about models that somebody keeps, numbered as their boxes are in a tree. An error about
// one of them begins with its name.
namespace toccata {

/// A model at its place.
struct InstanceView {
  const Model& model;
  const Pose& pose;
  Solid solid;
};

struct SearchedObjects {
  const BoxBvh& tree;
  FunctionRef<InstanceView(Index)> at;
  FunctionRef<std::string(Index)> name_of;
  FunctionRef<bool(Index)> accepts;
};

[[nodiscard]] std::optional<ObjectRayHit> first_ray_hit(const SearchedObjects& objects, const Ray& ray);
[[nodiscard]] std::vector<ObjectRayHit> all_ray_hits(const SearchedObjects& objects, const Ray& ray);

[[nodiscard]] std::optional<ObjectCast> first_cast(const SearchedObjects& objects, const MovingShape& moving,
                                                   Workspace& workspace);

[[nodiscard]] std::vector<Index> overlapping_objects(const SearchedObjects& objects, const SceneInstance& shape,
                                                     Workspace& workspace);
[[nodiscard]] std::vector<ObjectRelation> related_objects(const SearchedObjects& objects, const SceneInstance& shape,
                                                          Workspace& workspace);

[[nodiscard]] std::optional<ObjectDistance> nearest_object(const SearchedObjects& objects, const SceneInstance& shape,
                                                           double max_distance, Workspace& workspace);
[[nodiscard]] std::vector<Index> objects_within(const SearchedObjects& objects, const SceneInstance& shape,
                                                double distance, Workspace& workspace);

// Many at once.

[[nodiscard]] std::vector<std::optional<ObjectRayHit>> first_ray_hits(const SearchedObjects& objects,
                                                                      std::span<const Ray> rays,
                                                                      const BatchOptions& options);
[[nodiscard]] std::vector<std::optional<ObjectCast>> first_casts(const SearchedObjects& objects,
                                                                 std::span<const MovingShape> moving,
                                                                 const BatchOptions& options);
[[nodiscard]] std::vector<std::vector<Index>> objects_overlapping_each(const SearchedObjects& objects,
                                                                       std::span<const SceneInstance> shapes,
                                                                       const BatchOptions& options);
[[nodiscard]] std::vector<std::optional<ObjectDistance>> nearest_objects(const SearchedObjects& objects,
                                                                         std::span<const SceneInstance> shapes,
                                                                         double max_distance,
                                                                         const BatchOptions& options);
[[nodiscard]] std::vector<std::vector<Index>> objects_within_each(const SearchedObjects& objects,
                                                                  std::span<const SceneInstance> shapes,
                                                                  double distance, const BatchOptions& options);

}  // namespace toccata
