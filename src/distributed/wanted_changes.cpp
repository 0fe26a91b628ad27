#include <algorithm>
#include <unordered_set>

#include <fmt/format.h>

#include "core/require_length.hpp"
#include "distributed/distributed_state.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"
#include "world/body_box.hpp"
#include "world/swept_box.hpp"

namespace toccata {
namespace {

struct OptionValue {
  const char* name;
  double value;
};

std::vector<OptionValue> values_of(const DistributedOptions& options) {
  const WorldOptions& world = options.world;
  return {
      {"world.relation", world.relation ? 1. : 0.},       {"world.distance", world.distance ? 1. : 0.},
      {"world.contacts", world.contacts ? 1. : 0.},       {"world.manifold", world.manifold ? 1. : 0.},
      {"world.penetration", world.penetration ? 1. : 0.}, {"world.kinematic_pairs", world.kinematic_pairs ? 1. : 0.},
      {"most_imbalance", options.most_imbalance}};
}

/// Goes to the rank where the id is registered, when it is given or ends.
void put_registration(MessageWriter& letter, GlobalId id, bool is_new) {
  letter.put(is_new);
  letter.put_number(id);
}

/// Throws Error naming the body as the World does that refuses one.
std::vector<BodyId> added_to(World& world, std::span<const GlobalBody> wanted) {
  std::vector<BodyId> ids;
  for (const GlobalBody& one : wanted) try {
      ids.push_back(world.add(one.body));
    } catch (const Error& error) {
      throw Error(fmt::format("{}: {}", name_of_body(one), error.what()));
    }
  return ids;
}

/// As a World has them. It is one of few bodies at a time, so that it takes little memory.
std::vector<BodyBoxes> boxes_of(std::span<const GlobalBody> wanted) {
  constexpr std::size_t at_a_time = 4096;
  std::vector<BodyBoxes> boxes;
  boxes.reserve(wanted.size());
  while (!wanted.empty()) {
    World world;
    const std::size_t count = std::min(at_a_time, wanted.size());
    for (const BodyId id : added_to(world, wanted.first(count)))
      boxes.push_back({world.box(id), world.broad_phase().box(id.index)});
    wanted = wanted.subspan(count);
  }
  return boxes;
}

}  // namespace

std::string name_of_body(GlobalId id) { return fmt::format("body {}", id); }

std::string name_of_body(const GlobalBody& body) {
  return body.body.name.empty() ? name_of_body(body.id) : fmt::format("body {} (\"{}\")", body.id, body.body.name);
}

void DistributedWorld::State::require_equal_options() {
  Letters letters;
  for (const OptionValue& option : values_of(options_))
    for (int to = 0; to < ranks_.count() && ranks_.rank() == 0; ++to) letters[to].put(option.value);
  const std::vector<Received> first = ranks_.exchange(letters);
  ranks_.all_do([&] {
    if (!(options_.most_imbalance > 1))
      throw Error(fmt::format("most_imbalance is {}; it has to be above 1", options_.most_imbalance));
    if (options_.world.space_time) throw Error("world.space_time is of one World alone: leave it out");
    MessageReader reader(first.at(0).bytes);
    for (const OptionValue& option : values_of(options_))
      if (const auto other = reader.get<double>(); option.value != other)
        throw Error(fmt::format("{} is {} here and {} on rank 0; give all ranks the same options", option.name,
                                option.value, other));
    return false;
  });
}

BodyId DistributedWorld::State::require(GlobalId id) const {
  const auto found = local_.find(id);
  if (found == local_.end() || !copy(found->second).lives_here)
    throw Error(fmt::format("{} does not live on this rank: bodies() tells which do", name_of_body(id)));
  return found->second;
}

void DistributedWorld::State::check_deformed(WantedChanges& changes) const {
  for (WantedShape& shape : changes.deformed) {
    const auto same = [&](const GlobalBody& one) { return one.id == shape.id; };
    const BodyId local = require(shape.id);
    auto deformed = std::find_if(changes.bodies_deformed.begin(), changes.bodies_deformed.end(), same);
    if (deformed == changes.bodies_deformed.end())
      deformed = changes.bodies_deformed.insert(deformed, GlobalBody{shape.id, world_.body(local)});
    try {
      deformed->body.model.deform(std::move(shape.vertices), options_.world.threads);
    } catch (const Error& error) {
      throw Error(fmt::format("{}: {}", name_of_body(*deformed), error.what()));
    }
    const auto who = [&] { return name_of_body(shape.id); };
    static_cast<void>(body_box(deformed->body, deformed->body.pose, who));
  }
}

/// Bodies that are deformed too are checked as they are afterwards.
void DistributedWorld::State::check_places(WantedChanges& changes) const {
  std::unordered_map<GlobalId, const Body*> deformed;
  for (const GlobalBody& one : changes.bodies_deformed) deformed.emplace(one.id, &one.body);
  for (WantedPlace& moved : changes.moved) {
    const BodyId local = moved.local = require(moved.id);
    const auto other = deformed.empty() ? deformed.end() : deformed.find(moved.id);
    const Body& body = other == deformed.end() ? world_.body(local) : *other->second;
    const auto who = [&] { return name_of_body(moved.id); };
    if (!moved.motion) {
      static_cast<void>(body_box(body, moved.pose, who));
      continue;
    }
    if (moved.motion->pieces().size() != 1)
      throw Error(fmt::format("{}: its motion {}; give one move for a step", who(),
                              moved.motion->pieces().empty() ? "is told by a function, which is on this rank alone"
                                                             : "is of several pieces"));
    static_cast<void>(body_box(body, moved.motion->at(1), who));
    static_cast<void>(swept_box(body, *moved.motion, who));
  }
}

void DistributedWorld::State::check_rules(const WantedChanges& changes) {
  for (const GlobalPairRule& rule : changes.rules) {
    if (rule.a == rule.b) throw Error(fmt::format("a rule is given for {} with itself", name_of_body(rule.a)));
    if (const double margin = rule.margin.value_or(0); !(margin >= 0))
      require_length(margin,
                     fmt::format("the rule for {} and {}: its margin", name_of_body(rule.a), name_of_body(rule.b)));
  }
}

bool DistributedWorld::State::check_here(WantedChanges& changes) const {
  std::unordered_set<GlobalId> given, ended;
  changes.boxes_of_added = boxes_of(changes.added);
  for (const GlobalBody& added : changes.added)
    if (!given.insert(added.id).second) throw Error(fmt::format("{} is given twice", name_of_body(added)));
  check_deformed(changes);
  check_places(changes);
  check_rules(changes);
  for (const GlobalBody& replaced : changes.replaced) static_cast<void>(require(replaced.id));
  static_cast<void>(boxes_of(changes.replaced));
  for (const GlobalId id : changes.removed) {
    static_cast<void>(require(id));
    if (!ended.insert(id).second) throw Error(fmt::format("{} is to be removed twice", name_of_body(id)));
  }
  return !given.empty() || !ended.empty() || !changes.rules.empty();
}

void DistributedWorld::State::check(WantedChanges& changes) {
  if (!ranks_.all_do([&] { return check_here(changes); })) return;
  share_rules(changes);
  register_ids(changes);
}

int DistributedWorld::State::registrar_of(GlobalId id) const {
  return static_cast<int>(Random(id).below(static_cast<std::uint64_t>(ranks_.count())));
}

void DistributedWorld::State::register_ids(const WantedChanges& changes) {
  Letters letters;
  for (const GlobalId id : changes.removed) put_registration(letters[registrar_of(id)], id, false);
  for (const GlobalBody& added : changes.added) put_registration(letters[registrar_of(added.id)], added.id, true);
  std::unordered_set<GlobalId> ended;
  std::vector<std::pair<GlobalId, int>> begun;
  for (const Received& received : ranks_.exchange(letters))
    for (MessageReader reader(received.bytes); !reader.is_at_end();)
      if (reader.get<bool>())
        begun.emplace_back(reader.get_number(), received.from);
      else
        ended.insert(reader.get_number());
  std::unordered_map<GlobalId, int> given;
  ranks_.all_do([&] {
    for (const auto& [id, rank] : begun) {
      const auto there = registered_.find(id);
      if (there != registered_.end() && !ended.contains(id))
        throw Error(fmt::format("{} is given on rank {} and is there already, given on rank {}", name_of_body(id), rank,
                                there->second));
      const auto [place, is_first] = given.emplace(id, rank);
      if (!is_first)
        throw Error(fmt::format("{} is given twice, on rank {} and on rank {}", name_of_body(id), place->second, rank));
    }
    return false;
  });
  for (const GlobalId id : ended) registered_.erase(id);
  registered_.merge(given);
}

}  // namespace toccata
