#include <algorithm>
#include <exception>
#include <iterator>

#include "core/empty_list.hpp"
#include "distributed/distributed_state.hpp"
#include "toccata/broad/broad_phase.hpp"
#include "toccata/core/error.hpp"
#include "world/narrow_phase.hpp"

namespace toccata {
namespace {

using PairOfIds = std::pair<GlobalId, GlobalId>;

template <class Pair>
PairOfIds ids_of(const Pair& pair) {
  return {pair.a, pair.b};
}

PairOfIds ids_of(const PairOfIds& ids) { return ids; }

/// Ascending pairs, of which some are looked for in their order.
template <class Pair>
class PairsInOrder {
 public:
  explicit PairsInOrder(std::span<const Pair> pairs) : rest_(pairs) {}

  /// Null where they do not hold it. What was looked for before comes before it.
  const Pair* find(const PairOfIds& ids) {
    while (!rest_.empty() && ids_of(rest_.front()) < ids) rest_ = rest_.subspan(1);
    return !rest_.empty() && ids_of(rest_.front()) == ids ? &rest_.front() : nullptr;
  }

 private:
  std::span<const Pair> rest_;
};

template <class Pair>
bool is_less_by_ids(const Pair& a, const Pair& b) {
  return ids_of(a) < ids_of(b);
}

/// Takes out of the list what does not ascend, and the one before it, as either may be out of its place.
template <class Pair>
std::vector<Pair> take_unordered(std::vector<Pair>& pairs) {
  std::vector<Pair> taken;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (kept == 0 || !is_less_by_ids(pairs[i], pairs[kept - 1])) {
      if (kept != i) pairs[kept] = std::move(pairs[i]);
      ++kept;
      continue;
    }
    taken.push_back(std::move(pairs[--kept]));
    taken.push_back(std::move(pairs[i]));
  }
  pairs.erase(pairs.begin() + static_cast<std::ptrdiff_t>(kept), pairs.end());
  return taken;
}

/// Puts ascending pairs among others that ascend, from the greatest on, so that each moves once.
template <class Pair>
void put_among(std::vector<Pair>& pairs, std::vector<Pair> more) {
  auto kept = static_cast<std::ptrdiff_t>(pairs.size());
  pairs.resize(pairs.size() + more.size());
  for (auto to = pairs.end(); !more.empty();) {
    const bool is_kept_next = kept > 0 && is_less_by_ids(more.back(), pairs[static_cast<std::size_t>(kept - 1)]);
    *--to = std::move(is_kept_next ? pairs[static_cast<std::size_t>(--kept)] : more.back());
    if (!is_kept_next) more.pop_back();
  }
}

/// Bodies mostly lie in the order of their ids, so that most pairs do: the few others are sorted by themselves. (C.
/// Levcopoulos, O. Petersson, "Splitsort: an adaptive sorting algorithm", 1991.)
template <class Pair>
void sort_by_ids(std::vector<Pair>& pairs) {
  std::vector<Pair> unordered = take_unordered(pairs);
  if (unordered.empty()) return;
  std::sort(unordered.begin(), unordered.end(), is_less_by_ids<Pair>);
  put_among(pairs, std::move(unordered));
}

void put_ids(MessageWriter& letter, const PairOfIds& ids) {
  letter.put_number(ids.first);
  letter.put_number(ids.second);
}

}  // namespace

/// What it reaches is then in this rank's part of space.
bool DistributedWorld::State::is_here_alone(BodyId local) const {
  const Copy& one = copy(local);
  return one.lives_here && one.holders.empty();
}

/// A pair is told by the rank whose part of space has the lower corner of what the boxes of the two, as far as the
/// bodies reach, have in common. That point is in both boxes, so the rank has both bodies; and it is in one part alone.
int DistributedWorld::State::teller_of(BodyId a, BodyId b) const {
  if (ranks_.count() == 1 || is_here_alone(a) || is_here_alone(b)) return ranks_.rank();
  const Aabb first = reached_box(a), second = reached_box(b);
  return space_.part_of({std::max(first.lower.x, second.lower.x), std::max(first.lower.y, second.lower.y),
                         std::max(first.lower.z, second.lower.z)});
}

bool DistributedWorld::State::was_told(BodyId a, BodyId b) const {
  const PairOfIds ids = std::minmax(copy(a).id, copy(b).id);
  return std::ranges::binary_search(told_, ids, {}, ids_of<GlobalPairReport>);
}

/// Those that this rank tells, if they are pairs. And those that it told in the step before: it has to know whether
/// they end, where another tells them now. What else is here several ranks have, and one of them looks at it.
PairsFoundHere DistributedWorld::State::find_pairs() {
  for (auto& [id, way] : ways_) way.reached = reached_box(local_.at(id));
  struct ToldElsewhere {
    std::pair<BodyId, BodyId> pair;
    int teller;
  };
  std::vector<ToldElsewhere> elsewhere;
  const auto is_wanted = [&](BodyId a, BodyId b) {
    const int teller = teller_of(a, b);
    if (teller == ranks_.rank()) return true;
    if (!was_told(a, b)) return false;
    elsewhere.push_back({{a, b}, teller});
    return true;
  };
  PairsFoundHere found{std::exchange(spare_, {}), {}};
  empty_list(found.told, told_.size() + told_.size() / 16);
  std::size_t next = 0;  // of those elsewhere
  const auto see = [&](const PairReport& pair) {
    const auto [a, b] = std::minmax(copy(pair.a).id, copy(pair.b).id);
    const std::pair<BodyId, BodyId> here(pair.a, pair.b);
    while (next < elsewhere.size() && elsewhere[next].pair < here) ++next;
    if (next < elsewhere.size() && elsewhere[next].pair == here)
      found.handed.push_back({a, b, elsewhere[next].teller});
    else
      found.told.push_back({a, b, pair.in_contact});
  };
  last_.costs.candidates = world_.step(is_wanted, see).candidates;
  sort_by_ids(found.told);
  sort_by_ids(found.handed);
  return found;
}

/// As a World tells them of (a, b), whichever of the two has the lesser index here.
void DistributedWorld::State::add_details(std::span<GlobalPairReport> pairs) const {
  const bool of_all = tells_details(options_.world);
  if (!of_all && ways_.empty()) return;
  std::vector<Body> bodies;
  BodiesOnTheWay on_the_way;
  UndecidedPairs undecided;
  std::vector<DecidedPair> decided;
  std::vector<GlobalPairReport*> asked;
  const auto take = [&](GlobalId id, BodyId local) {
    const auto index = static_cast<Index>(bodies.size());
    bodies.push_back(world_.body(local));
    if (const auto way = ways_.find(id); way != ways_.end())
      on_the_way.insert_or_assign(index, BodyOnTheWay{way->second.motion, way->second.box});
    return index;
  };
  for (GlobalPairReport& pair : pairs) {
    if (!of_all && !ways_.contains(pair.a) && !ways_.contains(pair.b)) continue;
    const BodyId a = local_.at(pair.a), b = local_.at(pair.b);
    const Index first = take(pair.a, a), second = take(pair.b, b);
    undecided.pairs.push_back({decided.size(), world_.pair_margin(a, b).value_or(0)});
    decided.push_back({{first, second}});
    asked.push_back(&pair);
  }
  NarrowPhase(options_.world).decide(bodies, on_the_way, undecided, decided, {});
  for (std::size_t i = 0; i < asked.size(); ++i) asked[i]->details = decided[i].details;
}

bool DistributedWorld::State::is_of_removed(GlobalId a, GlobalId b) const {
  return !removed_.empty() && (removed_.contains(a) || removed_.contains(b));
}

/// Who tells a pair now is told that it goes on. The bodies are both still here, as what goes elsewhere is given up
/// only after this.
std::vector<std::pair<GlobalId, GlobalId>> DistributedWorld::State::hand_over(std::span<const HandedPair> handed) {
  Letters letters;
  for (const HandedPair& pair : handed) put_ids(letters[pair.teller], ids_of(pair));
  std::vector<PairOfIds> taken_over;
  for (const Received& received : ranks_.exchange(letters))
    for (MessageReader reader(received.bytes); !reader.is_at_end();) {
      const GlobalId a = reader.get_number();
      taken_over.emplace_back(a, reader.get_number());
    }
  sort_by_ids(taken_over);
  return taken_over;
}

void DistributedWorld::State::tell(PairsFoundHere found) {
  std::erase_if(found.handed, [&](const HandedPair& pair) { return is_of_removed(pair.a, pair.b); });
  const std::vector<PairOfIds> taken_over = hand_over(found.handed);
  const std::size_t most_kept = std::min(found.told.size(), told_.size() + taken_over.size());
  empty_list(last_.begin, found.told.size() - most_kept);
  empty_list(last_.persist, most_kept);
  empty_list(last_.end, told_.size() + taken_over.size() - most_kept);
  PairsInOrder handed{std::span<const HandedPair>(found.handed)};
  PairsInOrder taken{std::span<const PairOfIds>(taken_over)};
  auto before = told_.begin();
  const auto end_those_before = [&](const auto& is_before) {
    for (; before != told_.end() && is_before(*before); ++before)
      if (handed.find(ids_of(*before)) == nullptr) last_.end.push_back(*before);
  };
  for (const GlobalPairReport& report : found.told) {
    const PairOfIds ids = ids_of(report);
    end_those_before([&](const GlobalPairReport& told) { return ids_of(told) < ids; });
    const bool was_told_here = before != told_.end() && ids_of(*before) == ids;
    const bool is_of_others = was_told_here && is_of_removed(report.a, report.b);
    if (is_of_others) last_.end.push_back(*before);
    if (was_told_here) ++before;
    const bool is_kept = was_told_here ? !is_of_others : taken.find(ids) != nullptr;
    (is_kept ? last_.persist : last_.begin).push_back(report);
  }
  end_those_before([](const GlobalPairReport&) { return true; });
  spare_ = std::exchange(told_, std::move(found.told));
  spare_.clear();
}

void DistributedWorld::State::require_whole() const {
  if (!broken_.empty()) throw Error(broken_);
}

/// Once what is wanted is found right.
void DistributedWorld::State::make_step(WantedChanges& changes, LapClock& clock) {
  DistributedSeconds& seconds = last_.costs.seconds;
  const auto all_do = [&](auto work) {
    ranks_.all_do([&] {
      work();
      return false;
    });
  };
  Letters letters;
  all_do([&] { apply(changes, letters); });
  seconds.changes = clock.lap();
  divide(changes);
  seconds.division = clock.lap();
  all_do([&] { send_where_they_belong(changes, letters); });
  changes.free_bodies();
  std::vector<Received> received = ranks_.exchange(letters);
  letters = {};
  seconds.sending = clock.lap();
  PairsFoundHere found;
  all_do([&] {
    receive(changes, received);
    free_list(received);  // in the first step as much as all bodies
    seconds.receiving = clock.lap();
    found = find_pairs();
  });
  seconds.pairs = clock.lap();
  all_do([&] { add_details(found.told); });
  tell(std::move(found));
  arrive();
  count_costs();
  give_up_what_left();
  last_.costs.ghosts = world_.size() - last_.costs.bodies;
  seconds.telling = clock.lap();
}

const DistributedStep& DistributedWorld::State::step() {
  WantedChanges changes = std::exchange(wanted, {});
  require_whole();
  box_of_here_.reset();
  const std::uint64_t sent_before = ranks_.bytes_sent(), collectives_before = ranks_.collectives();
  const double waited_before = ranks_.seconds_waited();
  LapClock clock;
  check(changes);
  last_.costs.came = 0;
  try {
    make_step(changes, clock);
  } catch (const std::exception& error) {
    broken_ = std::string("nothing more can be asked of bodies whose step failed: ") + error.what();
    throw;
  }
  last_.costs.bytes_sent = ranks_.bytes_sent() - sent_before;
  last_.costs.collectives = ranks_.collectives() - collectives_before;
  last_.costs.seconds.waiting = ranks_.seconds_waited() - waited_before;
  return last_;
}

}  // namespace toccata
