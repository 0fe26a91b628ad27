#include "toccata/world/world_queries.hpp"

#include <fmt/format.h>

#include <string>

#include "query/scenes/object_search.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

const Body& body_of(const World& world, Index index) { return world.body(*world.body_at(index)); }

std::string name_of_body(const World& world, Index index) {
  const BodyId id = *world.body_at(index);
  const std::string& name = world.body(id).name;
  return fmt::format("body {} (generation {}){}", id.index, id.generation,
                     name.empty() ? "" : fmt::format(" (\"{}\")", name));
}

bool passes(const World& world, const BodyFilter& filter, Index index) {
  const Body& body = body_of(world, index);
  if ((body.group & filter.mask) == 0 || (filter.group != 0 && (body.mask & filter.group) == 0)) return false;
  return !filter.accepts || filter.accepts(*world.body_at(index));
}

/// Gives what was found of an object to the body that has its index.
class Named {
 public:
  explicit Named(const World& world) : world_(world) {}

  BodyId operator()(Index object) const { return *world_.body_at(object); }
  BodyRayHit operator()(const ObjectRayHit& hit) const { return {hit, (*this)(hit.object)}; }
  BodyCast operator()(const ObjectCast& cast) const { return {cast, (*this)(cast.object)}; }
  BodyDistance operator()(const ObjectDistance& distance) const { return {distance, (*this)(distance.object)}; }
  BodyRelation operator()(const ObjectRelation& found) const { return {(*this)(found.object), found.relation}; }

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
  const World& world_;
};

/// `ask(objects)` of all bodies that pass the filter.
template <class Ask>
auto ask_all(const World& world, const BoxBvh& boxes, std::uint64_t revision, const BodyFilter& filter,
             const Ask& ask) {
  if (world.revision() != revision)
    throw Error("the bodies of the World have changed since these WorldQueries looked; call update() before asking");
  const auto at = [&](Index object) {
    const Body& body = body_of(world, object);
    return InstanceView{body.model, body.pose, body.solid};
  };
  const auto name_of = [&](Index object) { return name_of_body(world, object); };
  const auto accepts = [&](Index object) { return passes(world, filter, object); };
  return Named(world)(ask(SearchedObjects{boxes, at, name_of, accepts}));
}

}  // namespace

WorldQueries::WorldQueries(const World& world) : world_(&world) { update(); }

void WorldQueries::update() {
  boxes_.update(world_->boxes());
  revision_ = world_->revision();
}

std::optional<BodyRayHit> WorldQueries::cast_ray(const Ray& ray, const BodyFilter& filter) const {
  return ask_all(*world_, boxes_, revision_, filter,
                 [&](const SearchedObjects& objects) { return first_ray_hit(objects, ray); });
}

std::vector<BodyRayHit> WorldQueries::cast_ray_through(const Ray& ray, const BodyFilter& filter) const {
  return ask_all(*world_, boxes_, revision_, filter,
                 [&](const SearchedObjects& objects) { return all_ray_hits(objects, ray); });
}

std::optional<BodyCast> WorldQueries::cast_shape(const MovingShape& moving, const BodyFilter& filter) const {
  Workspace workspace;
  return ask_all(*world_, boxes_, revision_, filter,
                 [&](const SearchedObjects& objects) { return first_cast(objects, moving, workspace); });
}

std::vector<BodyId> WorldQueries::overlapping(const SceneInstance& shape, const BodyFilter& filter) const {
  Workspace workspace;
  return ask_all(*world_, boxes_, revision_, filter,
                 [&](const SearchedObjects& objects) { return overlapping_objects(objects, shape, workspace); });
}

std::vector<BodyRelation> WorldQueries::relations(const SceneInstance& shape, const BodyFilter& filter) const {
  Workspace workspace;
  return ask_all(*world_, boxes_, revision_, filter,
                 [&](const SearchedObjects& objects) { return related_objects(objects, shape, workspace); });
}

std::optional<BodyDistance> WorldQueries::nearest(const SceneInstance& shape, double max_distance,
                                                  const BodyFilter& filter) const {
  Workspace workspace;
  return ask_all(*world_, boxes_, revision_, filter, [&](const SearchedObjects& objects) {
    return nearest_object(objects, shape, max_distance, workspace);
  });
}

std::vector<BodyId> WorldQueries::within(const SceneInstance& shape, double distance, const BodyFilter& filter) const {
  Workspace workspace;
  return ask_all(*world_, boxes_, revision_, filter,
                 [&](const SearchedObjects& objects) { return objects_within(objects, shape, distance, workspace); });
}

std::vector<std::optional<BodyRayHit>> WorldQueries::cast_ray_each(std::span<const Ray> rays, const BodyFilter& filter,
                                                                   const BatchOptions& options) const {
  return ask_all(*world_, boxes_, revision_, filter,
                 [&](const SearchedObjects& objects) { return first_ray_hits(objects, rays, options); });
}

std::vector<std::optional<BodyCast>> WorldQueries::cast_shape_each(std::span<const MovingShape> moving,
                                                                   const BodyFilter& filter,
                                                                   const BatchOptions& options) const {
  return ask_all(*world_, boxes_, revision_, filter,
                 [&](const SearchedObjects& objects) { return first_casts(objects, moving, options); });
}

std::vector<std::vector<BodyId>> WorldQueries::overlapping_each(std::span<const SceneInstance> shapes,
                                                                const BodyFilter& filter,
                                                                const BatchOptions& options) const {
  return ask_all(*world_, boxes_, revision_, filter,
                 [&](const SearchedObjects& objects) { return objects_overlapping_each(objects, shapes, options); });
}

std::vector<std::optional<BodyDistance>> WorldQueries::nearest_each(std::span<const SceneInstance> shapes,
                                                                    double max_distance, const BodyFilter& filter,
                                                                    const BatchOptions& options) const {
  return ask_all(*world_, boxes_, revision_, filter, [&](const SearchedObjects& objects) {
    return nearest_objects(objects, shapes, max_distance, options);
  });
}

std::vector<std::vector<BodyId>> WorldQueries::within_each(std::span<const SceneInstance> shapes, double distance,
                                                           const BodyFilter& filter,
                                                           const BatchOptions& options) const {
  return ask_all(*world_, boxes_, revision_, filter, [&](const SearchedObjects& objects) {
    return objects_within_each(objects, shapes, distance, options);
  });
}

}  // namespace toccata
