#include "toccata/world/world_queries.hpp"

#include <fmt/format.h>

#include "query/scenes/object_queries.hpp"
#include "toccata/core/error.hpp"
#include "world/pair_search.hpp"

namespace toccata {

BodyId WorldBodies::id_of(Index object) const { return *world->body_at(object); }

InstanceView WorldBodies::at(Index object) const {
  const Body& body = world->body(id_of(object));
  return {body.model, body.pose, body.solid};
}

std::string WorldBodies::name_of(Index object) const {
  const BodyId id = id_of(object);
  const std::string& name = world->body(id).name;
  return fmt::format("body {} (generation {}){}", id.index, id.generation,
                     name.empty() ? "" : fmt::format(" (\"{}\")", name));
}

bool WorldBodies::accepts(const BodyFilter& filter, Index object) const {
  const Body& body = world->body(id_of(object));
  if ((body.group & filter.mask) == 0 || (filter.group != 0 && (body.mask & filter.group) == 0)) return false;
  return !filter.accepts || filter.accepts(id_of(object));
}

void WorldBodies::require_unchanged() const {
  if (world->revision() != revision)
    throw Error("the bodies of the World have changed since these WorldQueries looked; call update() before asking");
}

WorldQueries::WorldQueries(const World& world) : ObjectQueries({&world}) { update(); }

void WorldQueries::update() {
  boxes_.update(objects_.world->boxes());
  objects_.revision = objects_.world->revision();
}

std::optional<BodyPair> WorldQueries::any_contact(const BodyPairs& pairs) const { return any_within(0, pairs); }

std::optional<BodyPair> WorldQueries::any_within(double distance, const BodyPairs& pairs) const {
  objects_.require_unchanged();
  Workspace workspace;
  return BodyPairSearch(objects_, boxes_, pairs).first_within(distance, workspace);
}

std::optional<BodyPairAnswer<Distance>> WorldQueries::least_distance(const BodyPairs& pairs,
                                                                     double max_distance) const {
  objects_.require_unchanged();
  Workspace workspace;
  return BodyPairSearch(objects_, boxes_, pairs).nearest(max_distance, workspace);
}

std::vector<std::optional<BodyPair>> WorldQueries::any_contact_each(std::span<const BodyPairs> pairs,
                                                                    const BatchOptions& options) const {
  objects_.require_unchanged();
  return ask_each(pairs, "pairs", options, [&](const BodyPairs& one, Workspace& workspace) {
    return BodyPairSearch(objects_, boxes_, one).first_within(0, workspace);
  });
}

std::vector<std::optional<BodyPairAnswer<Distance>>> WorldQueries::least_distance_each(
    std::span<const BodyPairs> pairs, double max_distance, const BatchOptions& options) const {
  objects_.require_unchanged();
  return ask_each(pairs, "pairs", options, [&](const BodyPairs& one, Workspace& workspace) {
    return BodyPairSearch(objects_, boxes_, one).nearest(max_distance, workspace);
  });
}

template class ObjectQueries<WorldBodies>;

}  // namespace toccata
