#include "toccata/world/world_queries.hpp"

#include <fmt/format.h>

#include "query/scenes/object_queries.hpp"
#include "toccata/core/error.hpp"

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

template class ObjectQueries<WorldBodies>;

}  // namespace toccata
