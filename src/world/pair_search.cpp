#include "world/pair_search.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <fmt/format.h>

#include "bounds/box_bounds.hpp"
#include "math/constants.hpp"
#include "query/search_scratch.hpp"
#include "toccata/core/error.hpp"
#include "toccata/query/overlap.hpp"
#include "world/body_box.hpp"

namespace toccata {
namespace {

void require_distance(double distance, const char* name) {
  if (!(distance >= 0)) throw Error(fmt::format("{} is {}; it has to be a length of 0 or more", name, distance));
}

IndexPair ordered(Index one, Index other) { return {std::min(one, other), std::max(one, other)}; }

/// The nearest pair so far, and up to which distance another is of interest.
class NearestPair {
 public:
  explicit NearestPair(double max_distance) : max_distance_(max_distance) {}

  /// Intervals are as wide as 10⁻¹² of the distance, or as two doubles are apart: what may widen that of the nearest is
  /// looked at, too.
  [[nodiscard]] double limit() const {
    if (!found_) return max_distance_;
    if (found_->upper == 0) return 0;
    return std::min(std::nextafter(found_->upper * (1 + 0x1p-38), infinity), max_distance_);
  }

  /// It can neither take the place of the nearest nor widen its interval.
  [[nodiscard]] bool is_needless(const IndexPair& pair) const { return found_ && found_->upper == 0 && pair_ < pair; }

  void take(const Distance& distance, const IndexPair& pair) {
    const double lower = found_ ? std::min(found_->lower, distance.lower) : distance.lower;
    if (!found_ || std::tie(distance.upper, pair) < std::tie(found_->upper, pair_)) {
      found_ = distance;
      pair_ = pair;
    }
    found_->lower = lower;
  }

  [[nodiscard]] const std::optional<Distance>& found() const { return found_; }
  [[nodiscard]] const IndexPair& pair() const { return pair_; }

 private:
  double max_distance_;
  std::optional<Distance> found_;
  IndexPair pair_{};
};

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
  const std::uint64_t a = world.body(ids.a).group, b = world.body(ids.b).group;
  const bool are_chosen = ((a & pairs_.first_groups) != 0 && (b & pairs_.second_groups) != 0) ||
                          ((a & pairs_.second_groups) != 0 && (b & pairs_.first_groups) != 0);
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

std::optional<BodyPair> BodyPairSearch::first_within(double distance, Workspace& workspace) const {
  require_distance(distance, "the distance");
  if (!placed_.empty()) {
    std::vector<IndexPair> pairs;
    for (const Placed& one : placed_) {
      const std::vector<IndexPair> some = near_pairs(one.index, distance);
      pairs.insert(pairs.end(), some.begin(), some.end());
    }
    std::ranges::sort(pairs);
    return first_of(pairs, distance, workspace);
  }
  for (const BodyId body : bodies_.world->bodies())
    if (const auto found = first_of(near_pairs(body.index, distance), distance, workspace)) return found;
  return std::nullopt;
}

std::optional<BodyPairAnswer<Distance>> BodyPairSearch::nearest(double max_distance, Workspace& workspace) const {
  require_distance(max_distance, "the greatest distance");
  NearestPair nearest(max_distance);
  const auto consider = [&](Index one, Index other) {
    const IndexPair pair = ordered(one, other);
    if (nearest.is_needless(pair) || !is_wanted(pair)) return;
    const double limit = nearest.limit();
    const auto found =
        ask(pair, workspace, [&](const Model& a, const Model& b, const PairQuery& query, Workspace& memory) {
          return distance_within(a, b, limit, query, memory);
        });
    if (found) nearest.take(*found, pair);
  };
  const auto search_from = [&](Index body) {
    const bool is_placed = placed(body) != nullptr;
    if (is_empty(box(body))) return;
    boxes_.visit_nearest(box(body), nearest.limit(), [&](Index other) {
      if (is_placed ? !placed(other) : other > body) consider(body, other);
      return nearest.limit();
    });
  };
  for (const Placed& one : placed_) {
    search_from(one.index);
    for (const Placed& other : placed_)
      if (other.index > one.index && box_gap(one.box, other.box) <= nearest.limit()) consider(one.index, other.index);
  }
  if (placed_.empty())
    for (const BodyId body : bodies_.world->bodies()) search_from(body.index);
  if (!nearest.found()) return std::nullopt;
  return BodyPairAnswer<Distance>{*nearest.found(), named(nearest.pair())};
}

}  // namespace toccata
