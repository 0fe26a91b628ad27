#include "world/pair_search.hpp"

#include <algorithm>
#include <tuple>

#include <fmt/format.h>

#include "bounds/box_bounds.hpp"
#include "core/require_length.hpp"
#include "query/keep_least.hpp"
#include "query/search_scratch.hpp"
#include "toccata/core/error.hpp"
#include "toccata/query/overlap.hpp"
#include "world/body_box.hpp"

namespace toccata {
namespace {

IndexPair ordered(Index one, Index other) { return {std::min(one, other), std::max(one, other)}; }

struct NearPair : Distance {
  IndexPair pair;
};

/// The pair can neither take the place of the nearest nor widen its interval.
bool is_needless(const IndexPair& pair, const std::optional<NearPair>& nearest) {
  return nearest && nearest->upper == 0 && nearest->pair < pair;
}

}  // namespace

BodyPairSearch::BodyPairSearch(const WorldBodies& bodies, const BoxBvh& boxes, const BodyPairs& pairs)
    : bodies_(bodies), boxes_(boxes), pairs_(pairs) {
  for (const PlacedBody& one : pairs.placed) {
    const Body& body = bodies.world->body(one.body);
    const Index index = one.body.index;
    placed_.push_back({index, &one.pose, body_box(body, one.pose, [&] { return bodies_.name_of(index); })});
  }
  std::ranges::sort(placed_, {}, &Placed::index);
  const auto twice = std::ranges::adjacent_find(placed_, {}, &Placed::index);
  if (twice != placed_.end()) throw Error(fmt::format("{} is placed twice", bodies_.name_of(twice->index)));
}

const BodyPairSearch::Placed* BodyPairSearch::placed(Index body) const {
  const auto found = std::ranges::lower_bound(placed_, body, {}, &Placed::index);
  return found != placed_.end() && found->index == body ? &*found : nullptr;
}

const Aabb& BodyPairSearch::box(Index body) const {
  const Placed* there = placed(body);
  return there ? there->box : boxes_.box(body);
}

InstanceView BodyPairSearch::at(Index body) const {
  const InstanceView view = bodies_.at(body);
  const Placed* there = placed(body);
  return there ? InstanceView{view.model, *there->pose, view.solid} : view;
}

bool BodyPairSearch::is_wanted(const IndexPair& pair) const {
  const World& world = *bodies_.world;
  const BodyPair ids = named(pair);
  const std::uint64_t a = world.body(ids.a).category, b = world.body(ids.b).category;
  const bool are_chosen = ((a & pairs_.first_categories) != 0 && (b & pairs_.second_categories) != 0) ||
                          ((a & pairs_.second_categories) != 0 && (b & pairs_.first_categories) != 0);
  return are_chosen && world.pair_margin(ids.a, ids.b).has_value();
}

BodyPair BodyPairSearch::named(const IndexPair& pair) const {
  return {bodies_.id_of(pair.first), bodies_.id_of(pair.second)};
}

std::vector<IndexPair> BodyPairSearch::near_pairs(Index body, double distance) const {
  std::vector<IndexPair> pairs;
  const Aabb& from = box(body);
  if (is_empty(from)) return pairs;
  const bool is_placed = placed(body) != nullptr;
  boxes_.visit_nearest(from, distance, [&](Index other) {
    // Without placed bodies each pair is found from its lesser body; placed ones are not where the tree has them.
    if (is_placed ? !placed(other) : other > body) pairs.push_back(ordered(body, other));
    return distance;
  });
  for (const Placed& other : placed_)
    if (other.index > body && box_gap(from, other.box) <= distance) pairs.push_back({body, other.index});
  std::erase_if(pairs, [&](const IndexPair& pair) { return !is_wanted(pair); });
  std::ranges::sort(pairs);
  return pairs;
}

template <class Ask>
auto BodyPairSearch::ask(const IndexPair& pair, Workspace& workspace, const Ask& question) const {
  const InstanceView a = at(pair.first), b = at(pair.second);
  workspace.scratch().convex = {};  // it was another pair's
  try {
    return question(a.model, b.model, PairQuery{a.pose, b.pose, a.solid, b.solid}, workspace);
  } catch (const Error& error) {
    throw Error(bodies_.name_of(pair.first) + " and " + bodies_.name_of(pair.second) + ": " + error.what());
  }
}

std::optional<BodyPair> BodyPairSearch::first_of(const std::vector<IndexPair>& pairs, double distance,
                                                 Workspace& workspace) const {
  const auto is_near = [&](const Model& a, const Model& b, const PairQuery& query, Workspace& memory) {
    return distance == 0 ? overlap(a, b, query, memory) : within_distance(a, b, distance, query, memory);
  };
  for (const IndexPair& pair : pairs)
    if (ask(pair, workspace, is_near)) return named(pair);
  return std::nullopt;
}

std::optional<BodyPair> BodyPairSearch::first_within(double max_distance, Workspace& workspace) const {
  require_length(max_distance, "the greatest distance");
  if (!placed_.empty()) {
    std::vector<IndexPair> pairs;
    for (const Placed& one : placed_) {
      const std::vector<IndexPair> some = near_pairs(one.index, max_distance);
      pairs.insert(pairs.end(), some.begin(), some.end());
    }
    std::ranges::sort(pairs);
    return first_of(pairs, max_distance, workspace);
  }
  for (const BodyId body : bodies_.world->bodies())
    if (const auto found = first_of(near_pairs(body.index, max_distance), max_distance, workspace)) return found;
  return std::nullopt;
}

std::optional<BodyPairAnswer<Distance>> BodyPairSearch::nearest(double max_distance, Workspace& workspace) const {
  require_length(max_distance, "the greatest distance");
  std::optional<NearPair> nearest;
  const auto limit = [&] { return last_distance(nearest, max_distance); };
  const auto consider = [&](Index one, Index other) {
    const IndexPair pair = ordered(one, other);
    if (is_needless(pair, nearest) || !is_wanted(pair)) return;
    const auto found =
        ask(pair, workspace, [&](const Model& a, const Model& b, const PairQuery& query, Workspace& memory) {
          return distance_within(a, b, limit(), query, memory);
        });
    if (found)
      keep_least(nearest, {*found, pair}, [](const NearPair& near) { return std::tie(near.upper, near.pair); });
  };
  const auto search_from = [&](Index body) {
    const bool is_placed = placed(body) != nullptr;
    if (is_empty(box(body))) return;
    boxes_.visit_nearest(box(body), limit(), [&](Index other) {
      if (is_placed ? !placed(other) : other > body) consider(body, other);
      return limit();
    });
  };
  for (const Placed& one : placed_) {
    search_from(one.index);
    for (const Placed& other : placed_)
      if (other.index > one.index && box_gap(one.box, other.box) <= limit()) consider(one.index, other.index);
  }
  if (placed_.empty())
    for (const BodyId body : bodies_.world->bodies()) search_from(body.index);
  if (!nearest) return std::nullopt;
  return BodyPairAnswer<Distance>{*nearest, named(nearest->pair)};
}

}  // namespace toccata
