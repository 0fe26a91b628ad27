#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "query/ask_each.hpp"
#include "query/scenes/object_search.hpp"
#include "toccata/query/object_queries.hpp"

// How ObjectQueries answer; whoever names a kind of objects includes it and instantiates them.
namespace toccata {

/// What was found of objects by index, as of the ids that they have.
template <class Objects>
class Named {
 public:
  explicit Named(const Objects& objects) : objects_(objects) {}

  auto operator()(Index object) const { return objects_.id_of(object); }
  template <class Answer>
  auto operator()(const ObjectAnswer<Answer>& found) const {
    return typename Objects::template Found<Answer>{static_cast<const Answer&>(found), objects_.id_of(found.object)};
  }
  template <class Found>
  auto operator()(const std::optional<Found>& found) const {
    return found ? std::optional((*this)(*found)) : std::nullopt;
  }
  template <class Found>
  auto operator()(const std::vector<Found>& found) const {
    std::vector<decltype((*this)(found[0]))> named;
    named.reserve(found.size());
    for (const Found& one : found) named.push_back((*this)(one));
    return named;
  }

 private:
  const Objects& objects_;
};

/// `ask(objects)` of all objects that pass the filter.
template <class Objects, class Ask>
auto ask_objects(const Objects& objects, const BoxBvh& boxes, const typename Objects::Filter& filter, const Ask& ask) {
  objects.require_unchanged();
  const auto at = [&](Index object) { return objects.at(object); };
  const auto name_of = [&](Index object) { return objects.name_of(object); };
  const auto accepts = [&](Index object) { return objects.accepts(filter, object); };
  const SearchedObjects searched{boxes, at, name_of, accepts};
  if constexpr (std::is_same_v<typename Objects::Id, Index>)
    return ask(searched);
  else
    return Named(objects)(ask(searched));
}

template <class Objects>
auto ObjectQueries<Objects>::cast_ray(const Ray& ray, const Filter& filter) const -> std::optional<Found<RayHit>> {
  return ask_objects(objects_, boxes_, filter,
                     [&](const SearchedObjects& objects) { return first_ray_hit(objects, ray); });
}

template <class Objects>
auto ObjectQueries<Objects>::cast_ray_through(const Ray& ray, const Filter& filter) const
    -> std::vector<Found<RayHit>> {
  return ask_objects(objects_, boxes_, filter,
                     [&](const SearchedObjects& objects) { return all_ray_hits(objects, ray); });
}

template <class Objects>
auto ObjectQueries<Objects>::cast_shape(const MovingShape& moving, const Filter& filter) const
    -> std::optional<Found<ShapeHit>> {
  Workspace workspace;
  return ask_objects(objects_, boxes_, filter,
                     [&](const SearchedObjects& objects) { return first_cast(objects, moving, workspace); });
}

template <class Objects>
auto ObjectQueries<Objects>::overlapping(const SceneInstance& shape, const Filter& filter) const -> std::vector<Id> {
  Workspace workspace;
  return ask_objects(objects_, boxes_, filter,
                     [&](const SearchedObjects& objects) { return overlapping_objects(objects, shape, workspace); });
}

template <class Objects>
auto ObjectQueries<Objects>::relations(const SceneInstance& shape, const Filter& filter) const
    -> std::vector<Found<Relation>> {
  Workspace workspace;
  return ask_objects(objects_, boxes_, filter,
                     [&](const SearchedObjects& objects) { return related_objects(objects, shape, workspace); });
}

template <class Objects>
auto ObjectQueries<Objects>::nearest(const SceneInstance& shape, double max_distance, const Filter& filter) const
    -> std::optional<Found<Distance>> {
  Workspace workspace;
  return ask_objects(objects_, boxes_, filter, [&](const SearchedObjects& objects) {
    return nearest_object(objects, shape, max_distance, workspace);
  });
}

template <class Objects>
auto ObjectQueries<Objects>::within(const SceneInstance& shape, double max_distance, const Filter& filter) const
    -> std::vector<Id> {
  Workspace workspace;
  return ask_objects(objects_, boxes_, filter, [&](const SearchedObjects& objects) {
    return objects_within(objects, shape, max_distance, workspace);
  });
}

template <class Objects>
auto ObjectQueries<Objects>::cast_ray_each(std::span<const Ray> rays, const Filter& filter,
                                           const BatchOptions& options) const
    -> std::vector<std::optional<Found<RayHit>>> {
  return ask_objects(objects_, boxes_, filter, [&](const SearchedObjects& objects) {
    return ask_each(rays, "ray", options, [&](const Ray& ray, Workspace&) { return first_ray_hit(objects, ray); });
  });
}

template <class Objects>
auto ObjectQueries<Objects>::cast_shape_each(std::span<const MovingShape> moving, const Filter& filter,
                                             const BatchOptions& options) const
    -> std::vector<std::optional<Found<ShapeHit>>> {
  return ask_objects(objects_, boxes_, filter, [&](const SearchedObjects& objects) {
    return ask_each(moving, "shape", options,
                    [&](const MovingShape& one, Workspace& workspace) { return first_cast(objects, one, workspace); });
  });
}

template <class Objects>
auto ObjectQueries<Objects>::overlapping_each(std::span<const SceneInstance> shapes, const Filter& filter,
                                              const BatchOptions& options) const -> std::vector<std::vector<Id>> {
  return ask_objects(objects_, boxes_, filter, [&](const SearchedObjects& objects) {
    return ask_each(shapes, "shape", options, [&](const SceneInstance& shape, Workspace& workspace) {
      return overlapping_objects(objects, shape, workspace);
    });
  });
}

template <class Objects>
auto ObjectQueries<Objects>::nearest_each(std::span<const SceneInstance> shapes, double max_distance,
                                          const Filter& filter, const BatchOptions& options) const
    -> std::vector<std::optional<Found<Distance>>> {
  return ask_objects(objects_, boxes_, filter, [&](const SearchedObjects& objects) {
    return ask_each(shapes, "shape", options, [&](const SceneInstance& shape, Workspace& workspace) {
      return nearest_object(objects, shape, max_distance, workspace);
    });
  });
}

template <class Objects>
auto ObjectQueries<Objects>::within_each(std::span<const SceneInstance> shapes, double max_distance,
                                         const Filter& filter, const BatchOptions& options) const
    -> std::vector<std::vector<Id>> {
  return ask_objects(objects_, boxes_, filter, [&](const SearchedObjects& objects) {
    return ask_each(shapes, "shape", options, [&](const SceneInstance& shape, Workspace& workspace) {
      return objects_within(objects, shape, max_distance, workspace);
    });
  });
}

}  // namespace toccata
