#include "toccata/world/world_queries.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "math/constants.hpp"
#include "query/scenes/object_queries.hpp"
#include "toccata/core/error.hpp"
#include "toccata/query/overlap.hpp"
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
  if ((body.category & filter.mask) == 0 || (filter.category != 0 && (body.mask & filter.category) == 0)) return false;
  return !filter.accepts || filter.accepts(id_of(object));
}

void WorldBodies::require_unchanged() const {
  if (world->revision() != revision)
    throw Error("the bodies of the World have changed since these WorldQueries looked; call update() before asking");
}

WorldQueries::WorldQueries(const World& world) : ObjectQueries({&world}) { update(); }

void WorldQueries::update() {
  if (objects_.revision == objects_.world->revision()) return;  // that of a World without bodies is 0, as of no update
  boxes_.update(objects_.world->boxes());
  objects_.revision = objects_.world->revision();
}

std::optional<BodyPair> WorldQueries::any_contact(const BodyPairs& pairs) const { return any_within(0, pairs); }

std::optional<BodyPair> WorldQueries::any_within(double max_distance, const BodyPairs& pairs) const {
  objects_.require_unchanged();
  Workspace workspace;
  return BodyPairSearch(objects_, boxes_, pairs).first_within(max_distance, workspace);
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

namespace {

bool bodies_overlap(const WorldBodies& bodies, Index i, Index j, Workspace& workspace) {
  const InstanceView a = bodies.at(i), b = bodies.at(j);
  try {
    return overlap(a.model, b.model, {a.pose, b.pose, a.solid, b.solid}, workspace);
  } catch (const Error& error) {
    throw Error(bodies.name_of(i) + " and " + bodies.name_of(j) + ": " + error.what());
  }
}

/// The axis along which the boxes begin farthest apart.
int axis_of_box_begins(std::span<const Aabb> boxes) {
  int longest = 0;
  double length = -1;
  for (int axis = 0; axis < 3; ++axis) {
    double least = infinity, greatest = -infinity;
    for (const Aabb& box : boxes) {
      if (!std::isfinite(box.lower[axis])) continue;
      least = std::min(least, box.lower[axis]);
      greatest = std::max(greatest, box.lower[axis]);
    }
    if (greatest - least > length) {
      length = greatest - least;
      longest = axis;
    }
  }
  return longest;
}

struct BoxBegin {
  double at;
  Index body;
};

}  // namespace

bool any_overlap(const World& world) {
  const WorldBodies bodies{&world, world.revision()};
  const std::span<const Aabb> boxes = world.boxes();
  const int axis = axis_of_box_begins(boxes);
  std::vector<BoxBegin> sorted;
  sorted.reserve(boxes.size());
  for (Index i = 0; i < boxes.size(); ++i)
    if (!is_empty(boxes[i])) sorted.push_back({boxes[i].lower[axis], i});
  std::ranges::sort(sorted, {}, &BoxBegin::at);
  Workspace workspace;
  for (auto first = sorted.begin(); first != sorted.end(); ++first) {
    const Aabb& box = boxes[first->body];
    for (auto second = first + 1; second != sorted.end() && second->at <= box.upper[axis]; ++second)
      if (overlap(box, boxes[second->body]) && bodies_overlap(bodies, first->body, second->body, workspace))
        return true;
  }
  return false;
}

bool WorldQueries::any_overlap() const {
  objects_.require_unchanged();
  Workspace workspace;
  bool found = false;
  for (Index i = 0; i < boxes_.size() && !found; ++i) {
    if (is_empty(boxes_.box(i))) continue;
    boxes_.visit_overlapping(boxes_.box(i), [&](Index j) {
      found = j > i && bodies_overlap(objects_, i, j, workspace);
      return !found;
    });
  }
  return found;
}

template class ObjectQueries<WorldBodies>;

}  // namespace toccata
