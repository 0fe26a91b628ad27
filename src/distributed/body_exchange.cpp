#include <algorithm>
#include <cstring>
#include <iterator>

#include "distributed/body_bytes.hpp"
#include "distributed/distributed_state.hpp"
#include "distributed/pose_bytes.hpp"
#include "math/constants.hpp"
#include "toccata/broad/broad_phase.hpp"
#include "world/swept_box.hpp"

namespace toccata {
namespace {

/// What a body costs by itself, where a pair of boxes that overlap costs each of its two bodies 1.
constexpr std::uint64_t cost_of_body = 2;

bool has(std::span<const int> ascending, int rank) {
  return std::binary_search(ascending.begin(), ascending.end(), rank);
}

void put_head(MessageWriter& letter, const BodyHead& head, GlobalId id) {
  letter.put(static_cast<std::uint8_t>(static_cast<unsigned>(head.message) | static_cast<unsigned>(head.place) << 2 |
                                       unsigned{head.is_new_home} << 4 | unsigned{head.is_deformed} << 5 |
                                       unsigned{head.has_rules} << 6));
  letter.put_number(id);
}

BodyHead get_head(MessageReader& reader) {
  const unsigned bits = reader.get<std::uint8_t>();
  return {static_cast<BodyMessage>(bits & 3), static_cast<PlaceMessage>(bits >> 2 & 3), (bits >> 4 & 1) != 0,
          (bits >> 5 & 1) != 0, (bits >> 6 & 1) != 0};
}

bool is_same_turn(const Pose& a, const Pose& b) { return std::memcmp(&a.linear, &b.linear, sizeof(Mat3)) == 0; }

std::vector<int> without(std::span<const int> ranks, int left_out) {
  std::vector<int> others;
  std::copy_if(ranks.begin(), ranks.end(), std::back_inserter(others), [&](int rank) { return rank != left_out; });
  return others;
}

/// What the rank on which it comes to live has to know.
void put_holders(MessageWriter& letter, int home, std::span<const int> holders) {
  letter.put_all(std::span<const int>(without(holders, home)));
}

}  // namespace

std::vector<int> DistributedWorld::State::ranks_reached_by(const Aabb& reached, int home) const {
  std::vector<int> ranks;
  space_.visit_parts_meeting(reached, [&](int part) { ranks.push_back(part); });
  if (!has(ranks, home)) ranks.insert(std::lower_bound(ranks.begin(), ranks.end(), home), home);
  return ranks;
}

Aabb DistributedWorld::State::reached_box(BodyId local) const {
  if (ways_.empty() && rules_.empty()) return world_.broad_phase().box(local.index);
  const GlobalId id = copy(local).id;
  const auto way = ways_.find(id);
  if (way != ways_.end() && !is_empty(way->second.reached)) return way->second.reached;
  // The World knows of rules for two that are both here; which ranks have a body must not depend on where others are.
  const Aabb& known = world_.broad_phase().box(local.index);
  const double by = rule_reach(id);
  if (by == 0) return known;
  return merge(known, offset_outward(way != ways_.end() ? way->second.box : world_.box(local), by));
}

void DistributedWorld::State::go(std::span<const WantedPlace> places) {
  constexpr std::size_t few = 16384;  // what is made of them on the way stays in the cache
  // The last place of a body counts, so what follows each other goes together.
  while (!places.empty()) {
    const bool along = places.front().motion.has_value();
    const auto is_of_others = [&](const WantedPlace& place) { return place.motion.has_value() != along; };
    const std::span next = places.first(std::min(few, places.size()));
    const auto count = static_cast<std::size_t>(std::ranges::find_if(next, is_of_others) - next.begin());
    if (along)
      go_along(places.first(count));
    else
      go_there(places.first(count));
    places = places.subspan(count);
  }
}

void DistributedWorld::State::go_there(std::span<const WantedPlace> places) {
  std::vector<BodyId> ids;
  std::vector<Pose> poses;
  ids.reserve(places.size());
  poses.reserve(places.size());
  for (const WantedPlace& place : places) {
    ids.push_back(place.local);
    poses.push_back(place.pose);
    if (!ways_.empty()) ways_.erase(place.id);
  }
  world_.move(ids, poses);
}

void DistributedWorld::State::go_along(std::span<const WantedPlace> places) {
  std::vector<BodyId> ids;
  std::vector<RigidMotion> motions;
  for (const WantedPlace& place : places) {
    ids.push_back(place.local);
    motions.push_back(*place.motion);
  }
  world_.move_along(ids, motions);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const GlobalId id = places[i].id;
    ways_.insert_or_assign(
        id, GlobalWay{motions[i], swept_box(world_.body(ids[i]), motions[i], [&] { return name_of_body(id); }), {}});
  }
}

void DistributedWorld::State::remove_here(GlobalId id) {
  const BodyId local = local_.at(id);
  world_.remove(local);
  if (copy(local).lives_here) cost_of_here_ -= copy(local).cost;
  copy(local) = {};
  local_.erase(id);
  forget_rules(id);
  removed_.insert(id);
}

void DistributedWorld::State::apply(const WantedChanges& changes, Letters& letters) {
  removed_.clear();
  ways_.clear();
  for (const GlobalBody& deformed : changes.bodies_deformed) {
    const BodyId local = local_.at(deformed.id);
    world_.replace(local, deformed.body);
    note(local, Change::replaced);
    copy(local).is_deformed = true;
  }
  for (const WantedPlace& moved : changes.moved) {
    const bool turns = moved.motion || !is_same_turn(moved.pose, world_.body(moved.local).pose);
    note(moved.local, turns ? Change::moved : Change::shifted);
  }
  go(changes.moved);
  for (const GlobalBody& replaced : changes.replaced) {
    const BodyId local = local_.at(replaced.id);
    world_.replace(local, replaced.body);
    note(local, Change::replaced);
    copy(local).is_deformed = false;
    ways_.erase(replaced.id);
  }
  for (const GlobalId id : changes.removed) {
    for (const int holder : copy(local_.at(id)).holders) {
      put_head(letters[holder], {BodyMessage::remove}, id);
    }
    ways_.erase(id);
    remove_here(id);
  }
  follow(changes);
}

void DistributedWorld::State::note(BodyId local, Change change) {
  Copy& one = copy(local);
  if (one.change == Change::none) changed_.push_back(local);
  one.change = std::max(one.change, change);
}

double DistributedWorld::State::imbalance_of(const WantedChanges& changes) {
  std::vector<std::uint64_t> loads(static_cast<std::size_t>(ranks_.count()));
  const auto add = [&](const Aabb& box, std::uint64_t cost) {
    loads[static_cast<std::size_t>(space_.part_of(place_of(box)))] += cost;
  };
  // What has not changed is where it was: in this rank's part, unless that is another now.
  std::uint64_t& here = loads[static_cast<std::size_t>(ranks_.rank())];
  if (!last_.costs.was_divided) here = cost_of_here_;
  for (const BodyId local : last_.costs.was_divided ? world_.bodies() : changed_) {
    if (!copy(local).lives_here) continue;
    if (!last_.costs.was_divided) here -= copy(local).cost;
    add(world_.box(local), copy(local).cost);
  }
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
  for (const BodyId local : world_.bodies()) {
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

/// To a rank that has it as it was in the step before.
PlaceMessage DistributedWorld::State::place_message_of(BodyId local) const {
  const Copy& own = copy(local);
  if (ways_.contains(own.id)) return PlaceMessage::way;
  if (own.change == Change::moved) return PlaceMessage::pose;
  return own.change == Change::shifted ? PlaceMessage::offset : PlaceMessage::none;
}

void DistributedWorld::State::put_place(MessageWriter& letter, PlaceMessage place, BodyId local) const {
  if (place == PlaceMessage::way) letter.put(ways_.at(copy(local).id).motion.pieces().front());
  if (place == PlaceMessage::pose) put_pose(letter, world_.body(local).pose);
  if (place == PlaceMessage::offset) letter.put(world_.body(local).pose.offset);
}

void DistributedWorld::State::put_whole(MessageWriter& letter, BodyId local, int to, int home,
                                        std::span<const int> holders) {
  const Copy& own = copy(local);
  const PlaceMessage place = ways_.contains(own.id) ? PlaceMessage::way : PlaceMessage::none;
  const bool has_rules = rules_.contains(own.id);
  put_head(letter, {BodyMessage::put, place, to == home, own.is_deformed, has_rules}, own.id);
  if (to == home) put_holders(letter, home, holders);
  put_body(letter, world_.body(local), models_, to, own.is_deformed ? ModelGoes::each_time : ModelGoes::once);
  put_place(letter, place, local);
  if (has_rules) put_rules(letter, own.id);
}

bool DistributedWorld::State::is_inside(const Aabb& reached) const {
  bool is_here = false, is_elsewhere = false;
  space_.visit_parts_meeting(reached, [&](int part) { (part == ranks_.rank() ? is_here : is_elsewhere) = true; });
  return is_here && !is_elsewhere;
}

void DistributedWorld::State::send(BodyId local, Letters& letters) {
  Copy& own = copy(local);
  if (own.holders.empty() && is_inside(reached_box(local))) return;  // as most are: no other rank has it or gets it
  const int here = ranks_.rank(), home = space_.part_of(place_of(world_.box(local)));
  const std::vector<int> reached_ranks = ranks_reached_by(reached_box(local), home);
  const PlaceMessage place = place_message_of(local);
  for (const int to : reached_ranks) {
    if (to == here) continue;
    if (!has(own.holders, to) || own.change == Change::replaced) {
      put_whole(letters[to], local, to, home, reached_ranks);
    } else if (place != PlaceMessage::none || to == home) {
      put_head(letters[to], {BodyMessage::move, place, to == home}, own.id);
      if (to == home) put_holders(letters[to], home, reached_ranks);
      put_place(letters[to], place, local);
    }
  }
  for (const int to : own.holders) {
    if (has(reached_ranks, to)) continue;
    // In the step to come it is still there: so it has to be what it is now, or that rank would tell pairs of what it
    // was.
    const bool is_new = own.change == Change::replaced;
    if (is_new) put_whole(letters[to], local, to, home, reached_ranks);
    put_head(letters[to], {BodyMessage::leave, is_new ? PlaceMessage::none : place}, own.id);
    put_place(letters[to], is_new ? PlaceMessage::none : place, local);
  }
  own.lives_here = home == here;
  own.holders = own.lives_here ? without(reached_ranks, here) : std::vector<int>{};
  // Its pairs of the step before are told to go on or to end by this rank once more.
  if (!has(reached_ranks, here)) leaving_.push_back(local);
}

void DistributedWorld::State::send_new(const GlobalBody& added, const BodyBoxes& boxes, Letters& letters) {
  const int home = space_.part_of(place_of(boxes.own));
  const double by = rule_reach(added.id);
  const Aabb reached = by > 0 ? merge(boxes.reached, offset_outward(boxes.own, by)) : boxes.reached;
  const std::vector<int> reached_ranks = ranks_reached_by(reached, home);
  for (const int to : reached_ranks) {
    MessageWriter& letter = letters[to];
    const bool has_rules = rules_.contains(added.id);
    put_head(letter, {BodyMessage::put, PlaceMessage::none, to == home, false, has_rules}, added.id);
    if (to == home) put_holders(letter, home, reached_ranks);
    put_body(letter, added.body, models_, to, ModelGoes::once);
    if (has_rules) put_rules(letter, added.id);
  }
}

void DistributedWorld::State::send_where_they_belong(const WantedChanges& changes, Letters& letters) {
  std::vector<BodyId> changed = std::exchange(changed_, {});
  if (ranks_.count() > 1) {
    if (last_.costs.was_divided) changed = world_.bodies();
    if (!std::is_sorted(changed.begin(), changed.end())) std::sort(changed.begin(), changed.end());
    for (const BodyId local : changed)
      if (copy(local).lives_here) send(local, letters);
  }
  for (const BodyId local : changed) copy(local).change = Change::none;
  for (std::size_t i = 0; i < changes.added.size(); ++i) send_new(changes.added[i], changes.boxes_of_added[i], letters);
}

void DistributedWorld::State::come_to_live_here(BodyId local, std::span<const int> holders) {
  copy(local).lives_here = true;
  copy(local).holders.assign(holders.begin(), holders.end());
  ++last_.costs.came;
}

WantedPlace DistributedWorld::State::get_place(MessageReader& reader, PlaceMessage place, GlobalId id) const {
  if (place == PlaceMessage::way) {
    const auto piece = reader.get<RigidMotion::Piece>();
    return {id, {}, RigidMotion(piece.start, piece.move)};
  }
  if (place == PlaceMessage::pose) return {id, get_pose(reader)};
  return {id, {world_.body(local_.at(id)).pose.linear, reader.get<Vec3>()}};
}

/// They stand at the beginning of a letter.
void DistributedWorld::State::read_removed(MessageReader& reader) {
  while (!reader.is_at_end()) {
    MessageReader rest = reader;
    if (get_head(rest).message != BodyMessage::remove) return;
    remove_here(rest.get_number());
    reader = rest;
  }
}

void DistributedWorld::State::read_next(MessageReader& reader, News& news) {
  constexpr std::size_t few = 16384;  // a copy of all that come would be as much memory as they are
  const BodyHead head = get_head(reader);
  const GlobalId id = reader.get_number();
  if (head.is_new_home) news.homes.emplace_back(id, reader.get_all<int>());
  if (head.message == BodyMessage::put) news.put.push_back({{id, get_body(reader, models_)}, head.is_deformed});
  if (head.message == BodyMessage::leave) news.leaving.push_back(id);
  if (head.place != PlaceMessage::none) news.places.push_back(get_place(reader, head.place, id));
  if (head.has_rules) {
    news.put.back().rules = get_rules(reader);
    news.with_rules.push_back(id);
  }
  if (news.put.size() == few) put_here(news.put);
}

/// The message of the least id is the next one. So bodies that are given in the order of their ids lie here in that
/// order, whichever ranks they come from, and who goes through them goes through memory as it lies.
void DistributedWorld::State::read(std::span<MessageReader> readers, News& news) {
  const auto id_of_next = [](MessageReader reader) {
    static_cast<void>(get_head(reader));
    return reader.get_number();
  };
  std::vector<std::pair<GlobalId, MessageReader*>> waiting;
  for (MessageReader& reader : readers)
    if (!reader.is_at_end()) waiting.emplace_back(id_of_next(reader), &reader);
  while (!waiting.empty()) {
    const auto next = std::ranges::min_element(waiting, {}, &std::pair<GlobalId, MessageReader*>::first);
    read_next(*next->second, news);
    if (next->second->is_at_end())
      waiting.erase(next);
    else
      next->first = id_of_next(*next->second);
  }
}

/// Those that come, and those that are here and are others now.
void DistributedWorld::State::put_here(std::vector<PutBody>& put) {
  std::vector<BodyId> replaced;
  std::vector<Body> bodies, replacements;
  std::vector<GlobalId> ids;
  for (PutBody& one : put) {
    const auto known = local_.find(one.given.id);
    if (known == local_.end()) {
      ids.push_back(one.given.id);
      bodies.push_back(std::move(one.given.body));
    } else {
      replaced.push_back(known->second);
      replacements.push_back(std::move(one.given.body));
    }
  }
  world_.replace(replaced, replacements);
  const std::vector<BodyId> locals = world_.add(bodies);
  for (std::size_t i = 0; i < locals.size(); ++i) {
    if (locals[i].index >= copies_.size()) copies_.resize(locals[i].index + std::size_t{1});
    Copy& one = copy(locals[i]);
    one = {};
    one.id = ids[i];
    one.cost = cost_of_body;
    local_.emplace(ids[i], locals[i]);
  }
  for (PutBody& one : put) {
    copy(local_.at(one.given.id)).is_deformed = one.is_deformed;
    if (!one.rules.empty()) rules_[one.given.id] = std::move(one.rules);
  }
  put.clear();
}

void DistributedWorld::State::receive(const WantedChanges& changes, std::span<const Received> letters) {
  std::vector<MessageReader> readers;
  for (const Received& received : letters) readers.emplace_back(received.bytes);
  // First: another rank may have given the id of a removed body to a new one.
  for (MessageReader& reader : readers) read_removed(reader);
  News news;
  read(readers, news);
  put_here(news.put);
  // What is replaced and leaves is in both lists, and its pose may be one that its shape of before may not have.
  for (WantedPlace& place : news.places) place.local = local_.at(place.id);
  go(news.places);
  for (const GlobalId id : news.leaving) leaving_.push_back(local_.at(id));
  for (const auto& [id, holders] : news.homes) come_to_live_here(local_.at(id), holders);
  tell_rules(changes, news);
}

void DistributedWorld::State::give_up_what_left() {
  for (const BodyId local : leaving_) {
    local_.erase(copy(local).id);
    forget_rules(copy(local).id);
    copy(local) = {};
  }
  world_.remove(leaving_);
  leaving_.clear();
}

/// What went along a motion reaches less far now: in the next step it is seen to which ranks.
void DistributedWorld::State::arrive() {
  for (const auto& [id, way] : ways_) {
    const BodyId local = local_.at(id);
    if (copy(local).lives_here) note(local, Change::reach);
  }
  ways_.clear();
}

void DistributedWorld::State::count_costs() {
  for (Copy& one : copies_) one.cost = cost_of_body;
  for (const IndexPair& pair : world_.broad_phase().pairs()) {
    ++copies_[pair.first].cost;
    ++copies_[pair.second].cost;
  }
  DistributedCosts& costs = last_.costs;
  costs.bodies = costs.ghosts_elsewhere = 0;
  cost_of_here_ = 0;
  std::vector<bool> has_ghosts(static_cast<std::size_t>(ranks_.count()));
  for (const Copy& one : copies_) {
    if (!one.lives_here) continue;
    ++costs.bodies;
    cost_of_here_ += one.cost;
    costs.ghosts_elsewhere += one.holders.size();
    for (const int holder : one.holders) has_ghosts[static_cast<std::size_t>(holder)] = true;
  }
  costs.neighbours = static_cast<std::size_t>(std::count(has_ghosts.begin(), has_ghosts.end(), true));
}

}  // namespace toccata
