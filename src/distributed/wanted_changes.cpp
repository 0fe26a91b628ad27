#include <algorithm>
#include <unordered_set>

#include <fmt/format.h>

#include "distributed/distributed_state.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"
#include "world/body_box.hpp"

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

/// Of an id that is given or ends, to the rank where it is registered.
struct Registration {
  GlobalId id = 0;
  bool is_new = false;
};

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

/// As a World has them.
std::vector<BodyBoxes> boxes_of(std::span<const GlobalBody> wanted) {
  World world;
  std::vector<BodyBoxes> boxes;
  for (const BodyId id : added_to(world, wanted)) boxes.push_back({world.box(id), world.broad_phase().box(id.index)});
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

bool DistributedWorld::State::check_here(WantedChanges& changes) const {
  std::unordered_set<GlobalId> given, ended;
  changes.boxes_of_added = boxes_of(changes.added);
  for (const GlobalBody& added : changes.added)
    if (!given.insert(added.id).second) throw Error(fmt::format("{} is given twice", name_of_body(added)));
  for (const auto& [id, pose] : changes.moved)
    static_cast<void>(body_box(world_.body(require(id)), pose, [id = id] { return name_of_body(id); }));
  for (const GlobalBody& replaced : changes.replaced) static_cast<void>(require(replaced.id));
  static_cast<void>(boxes_of(changes.replaced));
  for (const GlobalId id : changes.removed) {
    static_cast<void>(require(id));
    if (!ended.insert(id).second) throw Error(fmt::format("{} is to be removed twice", name_of_body(id)));
  }
  return !given.empty() || !ended.empty();
}

void DistributedWorld::State::check(WantedChanges& changes) {
  if (ranks_.all_do([&] { return check_here(changes); })) register_ids(changes);
}

int DistributedWorld::State::registrar_of(GlobalId id) const {
  return static_cast<int>(Random(id).below(static_cast<std::uint64_t>(ranks_.count())));
}

void DistributedWorld::State::register_ids(const WantedChanges& changes) {
  Letters letters;
  for (const GlobalId id : changes.removed) letters[registrar_of(id)].put(Registration{id, false});
  for (const GlobalBody& added : changes.added) letters[registrar_of(added.id)].put(Registration{added.id, true});
  std::unordered_set<GlobalId> ended;
  std::unordered_map<GlobalId, int> given;
  const std::vector<Received> all = ranks_.exchange(letters);
  for (const Received& received : all)
    for (MessageReader reader(received.bytes); !reader.is_at_end();)
      if (const auto one = reader.get<Registration>(); !one.is_new) ended.insert(one.id);
  ranks_.all_do([&] {
    for (const Received& received : all)
      for (MessageReader reader(received.bytes); !reader.is_at_end();) {
        const auto one = reader.get<Registration>();
        if (!one.is_new) continue;
        const auto there = registered_.find(one.id);
        if (there != registered_.end() && !ended.contains(one.id))
          throw Error(fmt::format("{} is given on rank {} and is there already, given on rank {}", name_of_body(one.id),
                                  received.from, there->second));
        const auto [place, is_first] = given.emplace(one.id, received.from);
        if (!is_first)
          throw Error(fmt::format("{} is given twice, on rank {} and on rank {}", name_of_body(one.id), place->second,
                                  received.from));
      }
    return false;
  });
  for (const GlobalId id : ended) registered_.erase(id);
  registered_.merge(given);
}

}  // namespace toccata
