#include <algorithm>
#include <iterator>

#include "distributed/distributed_state.hpp"
#include "math/constants.hpp"
#include "toccata/broad/broad_phase.hpp"

namespace toccata {
namespace {

/// What a body costs by itself, where a pair of boxes that overlap costs each of its two bodies 1.
constexpr std::uint64_t cost_of_body = 2;

bool has(std::span<const int> ascending, int rank) {
  return std::binary_search(ascending.begin(), ascending.end(), rank);
}

std::vector<int> without(std::span<const int> ranks, int left_out) {
  std::vector<int> others;
  std::copy_if(ranks.begin(), ranks.end(), std::back_inserter(others), [&](int rank) { return rank != left_out; });
  return others;
}

}  // namespace

Vec3 place_of(const Aabb& box) {
  constexpr double most = 1e300;
  Vec3 place;
  for (int axis = 0; axis < 3; ++axis)
    place[axis] = 0.5 * std::clamp(box.lower[axis], -most, most) + 0.5 * std::clamp(box.upper[axis], -most, most);
  return place;
}

std::vector<int> DistributedWorld::State::ranks_reached_by(const Aabb& reached, int home) const {
  std::vector<int> ranks;
  space_.visit_parts_meeting(reached, [&](int part) { ranks.push_back(part); });
  if (!has(ranks, home)) ranks.insert(std::lower_bound(ranks.begin(), ranks.end(), home), home);
  return ranks;
}

void DistributedWorld::State::apply(const WantedChanges& changes, Letters& letters) {
  removed_.clear();
  std::vector<BodyId> ids;
  std::vector<Pose> poses;
  for (const auto& [id, pose] : changes.moved) {
    ids.push_back(local_.at(id));
    poses.push_back(pose);
    copy(ids.back()).change = std::max(copy(ids.back()).change, Change::moved);
  }
  world_.move(ids, poses);
  for (const GlobalBody& replaced : changes.replaced) {
    world_.replace(local_.at(replaced.id), replaced.body);
    copy(local_.at(replaced.id)).change = Change::replaced;
  }
  for (const GlobalId id : changes.removed) {
    const BodyId local = local_.at(id);
    for (const int holder : copy(local).holders) {
      letters[holder].put(BodyMessage::remove);
      letters[holder].put(id);
    }
    world_.remove(local);
    copy(local) = {};
    local_.erase(id);
    removed_.insert(id);
  }
}

double DistributedWorld::State::imbalance_of(const WantedChanges& changes) {
  std::vector<std::uint64_t> loads(static_cast<std::size_t>(ranks_.count()));
  const auto add = [&](const Aabb& box, std::uint64_t cost) {
    loads[static_cast<std::size_t>(space_.part_of(place_of(box)))] += cost;
  };
  for (const auto& [id, local] : local_)
    if (copy(local).lives_here) add(world_.box(local), copy(local).cost);
  for (const BodyBoxes& boxes : changes.boxes_of_added) add(boxes.own, cost_of_body);
  ranks_.add_up(loads);
  double sum = 0;
  for (const std::uint64_t load : loads) sum += static_cast<double>(load);
  if (sum == 0) return 1;
  return static_cast<double>(*std::max_element(loads.begin(), loads.end())) * ranks_.count() / sum;
}

void DistributedWorld::State::divide(const WantedChanges& changes) {
  last_.costs.was_divided = false;
  last_.costs.imbalance = 1;
  if (ranks_.count() == 1) return;
  last_.costs.imbalance = imbalance_of(changes);
  // Where no planes do better, as of bodies in one place, it is tried again only after some steps, or when it is worse.
  imbalance_left_ = std::max(1.0, 0.98 * imbalance_left_);
  if (last_.costs.imbalance <= options_.most_imbalance || last_.costs.imbalance <= 1.1 * imbalance_left_) return;
  std::vector<Vec3> places;
  std::vector<std::uint64_t> costs;
  for (const auto& [id, local] : local_) {
    if (!copy(local).lives_here) continue;
    places.push_back(place_of(world_.box(local)));
    costs.push_back(copy(local).cost);
  }
  for (const BodyBoxes& boxes : changes.boxes_of_added) {
    places.push_back(place_of(boxes.own));
    costs.push_back(cost_of_body);
  }
  space_ = SpaceOfRanks(ranks_, places, costs);
  last_.costs.was_divided = true;
  last_.costs.imbalance = imbalance_left_ = imbalance_of(changes);
}

/// Whether it lives there from now on, and what that rank then has to know.
void DistributedWorld::State::put_home(MessageWriter& letter, int to, int home, std::span<const int> holders) const {
  const bool is_new_home = to == home;
  letter.put(is_new_home);
  if (is_new_home) letter.put_all(std::span<const int>(without(holders, home)));
}

void DistributedWorld::State::send(BodyId local, Letters& letters) {
  Copy& own = copy(local);
  const Body& body = world_.body(local);
  const Aabb& box = world_.box(local);
  const int here = ranks_.rank(), home = space_.part_of(place_of(box));
  const std::vector<int> reached_ranks = ranks_reached_by(world_.broad_phase().box(local.index), home);
  const auto begin = [&](int to, BodyMessage message) -> MessageWriter& {
    letters[to].put(message);
    letters[to].put(own.id);
    return letters[to];
  };
  for (const int to : reached_ranks) {
    if (to == here) continue;
    const bool is_new_home = to == home;
    const bool has_it = has(own.holders, to);
    if (!has_it || own.change == Change::replaced) {
      MessageWriter& letter = begin(to, BodyMessage::put);
      put_home(letter, to, home, reached_ranks);
      put_body(letter, body, to);
    } else if (own.change == Change::moved || is_new_home) {
      MessageWriter& letter = begin(to, BodyMessage::move);
      put_home(letter, to, home, reached_ranks);
      letter.put(body.pose);
    }
  }
  for (const int to : own.holders) {
    if (has(reached_ranks, to)) continue;
    // In the step to come it is still there: so it has to be what it is now, or that rank would tell pairs of what it
    // was.
    if (own.change == Change::replaced) {
      MessageWriter& letter = begin(to, BodyMessage::put);
      put_home(letter, to, home, reached_ranks);
      put_body(letter, body, to);
    }
    begin(to, BodyMessage::leave).put(body.pose);
  }
  own.change = Change::none;
  own.lives_here = home == here;
  own.holders = own.lives_here ? without(reached_ranks, here) : std::vector<int>{};
  // Its pairs of the step before are told to go on or to end by this rank once more.
  if (!has(reached_ranks, here)) leaving_.push_back(local);
}

void DistributedWorld::State::send_new(const GlobalBody& added, const BodyBoxes& boxes, Letters& letters) {
  const int home = space_.part_of(place_of(boxes.own));
  const std::vector<int> reached_ranks = ranks_reached_by(boxes.reached, home);
  for (const int to : reached_ranks) {
    MessageWriter& letter = letters[to];
    letter.put(BodyMessage::put);
    letter.put(added.id);
    put_home(letter, to, home, reached_ranks);
    put_body(letter, added.body, to);
  }
}

void DistributedWorld::State::send_where_they_belong(const WantedChanges& changes, Letters& letters) {
  if (ranks_.count() > 1) {
    for (const BodyId local : world_.bodies())
      if (copy(local).lives_here && (last_.costs.was_divided || copy(local).change != Change::none))
        send(local, letters);
  }
  for (std::size_t i = 0; i < changes.added.size(); ++i) send_new(changes.added[i], changes.boxes_of_added[i], letters);
}

void DistributedWorld::State::put_body(MessageWriter& letter, const Body& body, int to) {
  models_.put(letter, body.model, to);
  letter.put(body.pose);
  letter.put(body.type);
  letter.put(body.solid);
  letter.put(body.group);
  letter.put(body.mask);
  letter.put(body.margin);
  letter.put(body.max_acceleration);
  letter.put(body.max_speed);
  letter.put(body.user_data);
  letter.put_text(body.name);
}

Body DistributedWorld::State::get_body(MessageReader& reader) {
  Body body{models_.get(reader)};
  body.pose = reader.get<Pose>();
  body.type = reader.get<BodyType>();
  body.solid = reader.get<Solid>();
  body.group = reader.get<std::uint64_t>();
  body.mask = reader.get<std::uint64_t>();
  body.margin = reader.get<double>();
  body.max_acceleration = reader.get<double>();
  body.max_speed = reader.get<double>();
  body.user_data = reader.get<std::uint64_t>();
  body.name = reader.get_text();
  return body;
}

void DistributedWorld::State::come_to_live_here(BodyId local, std::span<const int> holders) {
  copy(local).lives_here = true;
  copy(local).holders.assign(holders.begin(), holders.end());
  ++last_.costs.came;
}

void DistributedWorld::State::receive(std::span<const Received> letters) {
  std::vector<BodyId> moved, replaced, removed;
  std::vector<Pose> poses;
  std::vector<Body> bodies, replacements;
  std::vector<GlobalId> ids;
  std::vector<GlobalBody> put;
  std::vector<std::pair<GlobalId, std::vector<int>>> new_homes;
  for (const Received& received : letters)
    for (MessageReader reader(received.bytes); !reader.is_at_end();) {
      const auto message = reader.get<BodyMessage>();
      const auto id = reader.get<GlobalId>();
      const bool can_be_home = message == BodyMessage::put || message == BodyMessage::move;
      if (can_be_home && reader.get<bool>()) new_homes.emplace_back(id, reader.get_all<int>());
      if (message == BodyMessage::put) {
        put.push_back({id, get_body(reader)});
      } else if (message == BodyMessage::remove) {
        removed.push_back(local_.at(id));
        removed_.insert(id);
      } else {
        moved.push_back(local_.at(id));
        poses.push_back(reader.get<Pose>());
        if (message == BodyMessage::leave) leaving_.push_back(moved.back());
      }
    }
  for (const BodyId local : removed) {
    local_.erase(copy(local).id);
    copy(local) = {};
  }
  world_.remove(removed);
  // Only now: another rank may have given the id of a removed body to a new one.
  for (GlobalBody& one : put) {
    const auto known = local_.find(one.id);
    if (known == local_.end()) {
      ids.push_back(one.id);
      bodies.push_back(std::move(one.body));
    } else {
      replaced.push_back(known->second);
      replacements.push_back(std::move(one.body));
    }
  }
  // What is replaced and leaves is in both lists, and its pose may be one that its shape of before may not have.
  world_.replace(replaced, replacements);
  world_.move(moved, poses);
  const std::vector<BodyId> locals = world_.add(bodies);
  for (std::size_t i = 0; i < locals.size(); ++i) {
    if (locals[i].index >= copies_.size()) copies_.resize(locals[i].index + std::size_t{1});
    Copy& one = copy(locals[i]);
    one = {};
    one.id = ids[i];
    one.cost = cost_of_body;
    local_.emplace(ids[i], locals[i]);
  }
  for (const auto& [id, holders] : new_homes) come_to_live_here(local_.at(id), holders);
}

void DistributedWorld::State::give_up_what_left() {
  for (const BodyId local : leaving_) {
    local_.erase(copy(local).id);
    copy(local) = {};
  }
  world_.remove(leaving_);
  leaving_.clear();
}

void DistributedWorld::State::count_costs() {
  for (Copy& one : copies_) one.cost = cost_of_body;
  for (const IndexPair& pair : world_.broad_phase().pairs()) {
    ++copies_[pair.first].cost;
    ++copies_[pair.second].cost;
  }
}

}  // namespace toccata
