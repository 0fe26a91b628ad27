#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "support/sweep.hpp"
#include "toccata/core/error.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/world/world.hpp"
#include "world/random_bodies.hpp"

namespace toccata::test {
namespace {

using Key = std::pair<BodyId, BodyId>;
using Truth = std::map<Key, bool>;  ///< the pairs, and whether they are in contact

Key key_of(const PairReport& report) { return {report.a, report.b}; }
PairQuery query_of(const Body& a, const Body& b) { return {a.pose, b.pose, a.solid, b.solid}; }

bool are_near(const Body& a, const Body& b, double margin) {
  const Distance apart = distance(a.model, b.model, query_of(a, b));
  if (apart.upper <= margin) return true;
  return apart.lower <= margin && within_distance(a.model, b.model, margin, query_of(a, b));
}

/// Ids are the same in two Worlds to which the same was done, but for the World.
bool same_body(const BodyId& a, const BodyId& b) { return a.index == b.index && a.generation == b.generation; }

bool same(const PairReport& a, const PairReport& b) {
  if (!same_body(a.a, b.a) || !same_body(a.b, b.b) || a.in_contact != b.in_contact || !a.details != !b.details)
    return false;
  return !a.details || *a.details == *b.details;
}

bool same(const std::vector<PairReport>& a, const std::vector<PairReport>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const PairReport& one, const PairReport& other) { return same(one, other); });
}

/// With space_time (b) there may be fewer candidates.
bool same(const WorldStep& a, const WorldStep& b, bool space_time) {
  return same(a.begin, b.begin) && same(a.persist, b.persist) && same(a.end, b.end) &&
         (space_time ? a.candidates >= b.candidates : a.candidates == b.candidates);
}

WorldOptions options_of(std::uint64_t seed, BroadPhaseMethod method, int threads, bool space_time) {
  WorldOptions options;
  // Without details a World with space_time need not ask about what it tells.
  const bool tells_details = seed % 5 < 3;
  options.relation = tells_details && (seed & 1) != 0;
  options.distance = tells_details && (seed & 2) != 0;
  options.contacts = tells_details && (seed & 4) != 0;
  options.manifold = tells_details && (seed & 8) != 0;
  options.penetration = tells_details && (seed & 15) == 11;
  options.kinematic_pairs = (seed & 16) == 0;
  options.broad_phase = method;
  options.threads = threads;
  options.space_time = space_time;
  return options;
}

/// Two of every three lives use space-time: in one of these most bodies glide on, in the other they do what they
/// please.
bool is_space_time(std::uint64_t seed) { return seed % 3 != 0; }
bool is_gliding(std::uint64_t seed) { return seed % 3 == 1; }

Body random_living_body(std::string_view family, Random& random) {
  Body body = random_body(family, random);
  // Mostly lies.
  if (random.below(3) == 0) body.max_acceleration = random.between(0, 0.01);
  if (random.below(4) == 0) body.max_speed = random.between(0, 0.1);
  return body;
}

/// A World whose bodies live: some move a little, some teleport, some come and go, rules and margins change. What it
/// should tell is kept in the plainest way: all pairs are asked about, one by one. A second World by another method, on
/// two threads and with space_time, has to tell the same; now and then it is made anew from the first.
class WorldLife {
 public:
  WorldLife(std::string_view family, std::uint64_t seed)
      : family_(family),
        is_gliding_(is_gliding(seed)),
        world_(options_of(seed, BroadPhaseMethod::automatic, 1, false)),
        other_(options_of(seed, seed % 2 == 0 ? BroadPhaseMethod::dynamic_tree : BroadPhaseMethod::sort_and_sweep, 2,
                          is_space_time(seed))) {}

  /// Says what is wrong; empty when nothing is.
  std::string live(int frame, Random& random) {
    if (frame % 4 == 2) remove(some(random, 0.2));
    if (frame % 12 == 7) remove(some(random, 0.9));
    std::string wrong;
    if (frame % 3 == 0) wrong = add(frame == 0 ? 30 : random.below(8), random);
    if (is_gliding_) glide();
    move(some(random, is_gliding_ ? 0.05 : frame % 3 == 1 ? 1 : 0.2), frame % 5 == 0, random);
    replace(some(random, 0.05), random);
    for (int i = 0; i < (is_gliding_ ? 1 : 4); ++i) set_rule(random);
    if (frame % 6 == 5) restore();
    return wrong.empty() ? step() : wrong;
  }

 private:
  std::string add(std::size_t count, Random& random) {
    std::vector<Body> bodies;
    while (bodies.size() < count) bodies.push_back(random_living_body(family_, random));
    const std::vector<BodyId> ids = world_.add(bodies);
    const std::vector<BodyId> others = other_.add(bodies);
    if (!std::equal(ids.begin(), ids.end(), others.begin(), others.end(), same_body))
      return "other ids in the other World";
    if (!others.empty()) number_of_other_ = others[0].world;
    for (std::size_t i = 0; i < count; ++i)
      if (!bodies_.emplace(ids.at(i), bodies[i]).second || was_removed(ids[i])) return "an id is given out twice";
    return {};
  }

  BodyId in_other(BodyId id) const { return {id.index, id.generation, number_of_other_}; }

  std::vector<BodyId> in_other(std::vector<BodyId> ids) const {
    for (BodyId& id : ids) id = in_other(id);
    return ids;
  }

  bool was_removed(BodyId id) const { return std::find(removed_.begin(), removed_.end(), id) != removed_.end(); }

  void remove(const std::vector<BodyId>& ids) {
    world_.remove(ids);
    other_.remove(in_other(ids));
    for (const BodyId id : ids) {
      bodies_.erase(id);
      removed_.push_back(id);
      std::erase_if(rules_, [&](const auto& rule) { return rule.first.first == id || rule.first.second == id; });
    }
  }

  void move(const std::vector<BodyId>& ids, bool teleport, Random& random) {
    std::vector<Pose> poses;
    for (const BodyId id : ids) {
      Pose pose = random_place(family_, random);
      if (!teleport) pose = {bodies_.at(id).pose.linear, bodies_.at(id).pose.offset + vector_in(random, -0.05, 0.05)};
      bodies_.at(id).pose = pose;
      poses.push_back(pose);
    }
    world_.move(ids, poses);
    other_.move(in_other(ids), poses);
  }

  /// Each goes on in its own way, or rests, and turns.
  void glide() {
    std::vector<BodyId> ids;
    std::vector<Pose> poses;
    for (auto& [id, body] : bodies_) {
      Random own(id.index);
      if (own.below(4) == 0) continue;
      const Vec3 way = vector_in(own, -0.02, 0.02);
      const Mat3 turn = family_ == "whole" ? Mat3{} : rotation_about(vector_in(own, -1, 1), own.between(0, 2));
      body.pose = {turn * body.pose.linear, body.pose.offset + way};
      ids.push_back(id);
      poses.push_back(body.pose);
    }
    world_.move(ids, poses);
    other_.move(in_other(ids), poses);
  }

  void replace(const std::vector<BodyId>& ids, Random& random) {
    std::vector<Body> bodies;
    for (const BodyId id : ids) bodies.push_back(bodies_.at(id) = random_living_body(family_, random));
    world_.replace(ids, bodies);
    other_.replace(in_other(ids), bodies);
  }

  void set_rule(Random& random) {
    if (bodies_.size() < 2) return;
    const auto any = [&] { return std::next(bodies_.begin(), static_cast<long>(random.below(bodies_.size())))->first; };
    PairRule rule{any(), any()};
    if (rule.a == rule.b) return;
    if (random.below(3) == 0) rule.excluded = true;
    if (random.below(2) == 0) rule.margin = random_margin(random);
    world_.set_rule(rule);
    other_.set_rule({in_other(rule.a), in_other(rule.b), rule.excluded, rule.margin});
    rules_[std::minmax(rule.a, rule.b)] = rule;
  }

  void restore() {
    const World snapshot = other_;
    other_.remove(other_.bodies());
    other_.step();
    other_ = snapshot;
  }

  std::vector<BodyId> some(Random& random, double share) const {
    std::vector<BodyId> ids;
    for (const auto& [id, body] : bodies_)
      if (random.unit() < share) ids.push_back(id);
    return ids;
  }

  /// Whether the two are a pair, and in contact.
  std::pair<bool, bool> truth_of(const Key& pair) const {
    const Body &a = bodies_.at(pair.first), &b = bodies_.at(pair.second);
    if (a.type == BodyType::static_body && b.type == BodyType::static_body) return {};
    if (!world_.options().kinematic_pairs && a.type != BodyType::dynamic_body && b.type != BodyType::dynamic_body)
      return {};
    if ((a.category & b.mask) == 0 || (b.category & a.mask) == 0) return {};
    double margin = a.margin + b.margin;
    if (const auto rule = rules_.find(pair); rule != rules_.end()) {
      if (rule->second.excluded) return {};
      margin = rule->second.margin.value_or(margin);
    }
    const bool contact = relation(a.model, b.model, query_of(a, b)).kind != RelationKind::apart;
    return {contact || (margin > 0 && are_near(a, b, margin)), contact};
  }

  Truth truth() const {
    Truth pairs;
    for (auto a = bodies_.begin(); a != bodies_.end(); ++a)
      for (auto b = std::next(a); b != bodies_.end(); ++b) {
        const Key key{a->first, b->first};
        if (const auto [is_pair, contact] = truth_of(key); is_pair) pairs.emplace(key, contact);
      }
    return pairs;
  }

  /// The lists tell these pairs, begun, kept and ended since those of before.
  static std::string wrong_in(const WorldStep& step, const Truth& before, const Truth& now) {
    auto begin = step.begin.begin(), persist = step.persist.begin(), end = step.end.begin();
    for (const auto& [key, contact] : now) {
      auto& next = before.contains(key) ? persist : begin;
      const auto& list = before.contains(key) ? step.persist : step.begin;
      if (next == list.end() || key_of(*next) != key || (next++)->in_contact != contact)
        return fmt::format("bodies {} and {} should be told next", key.first.index, key.second.index);
    }
    for (const auto& [key, contact] : before)
      if (!now.contains(key) && (end == step.end.end() || key_of(*end) != key || (end++)->in_contact != contact))
        return fmt::format("bodies {} and {} should have ended", key.first.index, key.second.index);
    const bool all = begin == step.begin.end() && persist == step.persist.end() && end == step.end.end();
    return all ? "" : "more pairs are told than there are";
  }

  std::string wrong_details(const PairReport& report) const {
    const WorldOptions& asked = world_.options();
    const Body &a = bodies_.at(report.a), &b = bodies_.at(report.b);
    const PairQuery query = query_of(a, b);
    const bool any = asked.relation || asked.distance || asked.contacts || asked.manifold || asked.penetration;
    if (any != (report.details != nullptr)) return "details are told unasked, or not told";
    if (!any) return {};
    const PairDetails& told = *report.details;
    if (told.relation != (asked.relation ? std::optional(relation(a.model, b.model, query)) : std::nullopt))
      return "another relation";
    if (told.distance != (asked.distance ? std::optional(distance(a.model, b.model, query)) : std::nullopt))
      return "another distance";
    if (told.contacts.size() != (asked.contacts ? contacts(a.model, b.model, query).size() : 0))
      return "other contacts";
    const bool has_manifold =
        asked.manifold && report.in_contact &&
        pair_cell(ShapeQuestion::manifold, kind_of(a.model.shape()), kind_of(b.model.shape())).state ==
            PairState::defined;
    if (told.manifold != (has_manifold ? std::optional(manifold(a.model, b.model, query)) : std::nullopt))
      return "another manifold";
    if (told.manifolds !=
        (asked.manifold && report.in_contact ? manifolds(a.model, b.model, query) : std::vector<ModelManifold>{}))
      return "other manifolds";
    if (told.penetration && told.penetration != penetration(a.model, b.model, query)) return "another penetration";
    return {};
  }

  std::string wrong_bodies() const {
    if (world_.size() != bodies_.size()) return "another number of bodies";
    std::vector<BodyId> ids;
    for (const auto& [id, body] : bodies_) {
      ids.push_back(id);
      const Body& persist = world_.body(id);
      if (persist.pose != body.pose || persist.margin != body.margin || persist.user_data != body.user_data ||
          persist.category != body.category)
        return "another body than was given";
    }
    if (world_.bodies() != ids) return "other ids";
    for (const BodyId id : removed_)
      if (world_.contains(id)) return "a removed body is there";
    return {};
  }

  std::string step() {
    const Truth now = truth();
    const WorldStep& found = world_.step();
    std::string wrong = wrong_in(found, pairs_, now);
    if (wrong.empty() && !same(found, other_.step(), other_.options().space_time))
      wrong = "the other World tells something else";
    for (const PairReport& report : world_.pairs())
      if (wrong.empty()) wrong = wrong_details(report);
    pairs_ = now;
    return wrong.empty() ? wrong_bodies() : wrong;
  }

  std::string_view family_;
  bool is_gliding_;
  World world_;
  World other_;
  std::uint32_t number_of_other_ = 0;  ///< in the ids that it gives out
  std::map<BodyId, Body> bodies_;
  std::map<Key, PairRule> rules_;
  Truth pairs_;  ///< of the last step
  std::vector<BodyId> removed_;
};

SweepResult run_world(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  SweepResult result;
  for (; result.cases < cases; ++result.cases) {
    const std::uint64_t number = 1'000'003 * seed + result.cases;
    Random random(number);
    WorldLife life(family, number);
    std::string wrong;
    for (int frame = 0; frame < 24 && wrong.empty(); ++frame) {
      wrong = life.live(frame, random);
      if (!wrong.empty()) wrong = fmt::format("{} with seed {}, frame {}: {}", family, number, frame, wrong);
    }
    if (!wrong.empty() && result.wrong++ == 0) result.first_failure = wrong;
  }
  return result;
}

std::vector<std::string> families() { return {body_families.begin(), body_families.end()}; }

const bool world_known = register_sweep({"world", families(), 1000, 3, run_world, 50, 1});

}  // namespace
}  // namespace toccata::test
