#pragma once

#include <optional>
#include <string>
#include <vector>

#include "toccata/broad/box_bvh.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/function_ref.hpp"
#include "toccata/query/pair_query.hpp"
#include "toccata/query/scene_index.hpp"

// The questions of SceneIndex about models that somebody keeps, numbered as their boxes are in a tree. An error about
// one of them begins with its name.
namespace toccata {

struct SearchedObjects {
  const BoxBvh& tree;
  FunctionRef<InstanceView(Index)> at;
  FunctionRef<std::string(Index)> name_of;
  FunctionRef<bool(Index)> accepts;
};

/// What is asked about one of them, whose name an error gets.
template <class Ask>
auto ask_about(Index object, const SearchedObjects& objects, const Ask& ask) {
  try {
    return ask(objects.at(object));
  } catch (const Error& error) {
    throw Error(objects.name_of(object) + ": " + error.what());
  }
}

[[nodiscard]] std::optional<ObjectAnswer<RayHit>> first_ray_hit(const SearchedObjects& objects, const Ray& ray);
[[nodiscard]] std::vector<ObjectAnswer<RayHit>> all_ray_hits(const SearchedObjects& objects, const Ray& ray);

[[nodiscard]] std::optional<ObjectAnswer<ShapeHit>> first_cast(const SearchedObjects& objects,
                                                               const MovingShape& moving, Workspace& workspace);

[[nodiscard]] std::vector<Index> overlapping_objects(const SearchedObjects& objects, const SceneInstance& shape,
                                                     Workspace& workspace);
[[nodiscard]] std::vector<ObjectAnswer<Relation>> related_objects(const SearchedObjects& objects,
                                                                  const SceneInstance& shape, Workspace& workspace);

[[nodiscard]] std::optional<ObjectAnswer<Distance>> nearest_object(const SearchedObjects& objects,
                                                                   const SceneInstance& shape, double max_distance,
                                                                   Workspace& workspace);
[[nodiscard]] std::vector<Index> objects_within(const SearchedObjects& objects, const SceneInstance& shape,
                                                double max_distance, Workspace& workspace);

}  // namespace toccata
