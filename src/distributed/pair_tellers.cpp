#include <algorithm>
#include <exception>
#include <iterator>

#include "distributed/distributed_state.hpp"
#include "toccata/broad/broad_phase.hpp"
#include "toccata/core/error.hpp"
#include "world/narrow_phase.hpp"

namespace toccata {
namespace {

using PairOfIds = std::pair<GlobalId, GlobalId>;

PairOfIds ids_of(const GlobalPairReport& report) { return {report.a, report.b}; }

void put_ids(MessageWriter& letter, const PairOfIds& ids) {
  letter.put_number(ids.first);
  letter.put_number(ids.second);
}

bool is_of_lesser_ids(const LocalPair& a, const LocalPair& b) { return ids_of(a.report) < ids_of(b.report); }

}  // namespace

/// A pair is told by the rank whose part of space has the lower corner of what the boxes of the two, as far as the
/// bodies reach, have in common. That point is in both boxes, so the rank has both bodies; and it is in one part alone.
int DistributedWorld::State::teller_of(BodyId a, BodyId b) const {
  const Aabb first = reached_box(a), second = reached_box(b);
  return space_.part_of({std::max(first.lower.x, second.lower.x), std::max(first.lower.y, second.lower.y),
                         std::max(first.lower.z, second.lower.z)});
}

std::vector<LocalPair> DistributedWorld::State::found_pairs() const {
  std::vector<LocalPair> found;
  found.reserve(world_.pairs().size());
  for (const PairReport& pair : world_.pairs()) {
    const auto [a, b] = std::minmax(copy(pair.a).id, copy(pair.b).id);
    found.push_back({{a, b, pair.in_contact}, teller_of(pair.a, pair.b)});
  }
  std::sort(found.begin(), found.end(), is_of_lesser_ids);
  return found;
}

bool DistributedWorld::State::was_told(BodyId a, BodyId b) const {
  const PairOfIds ids = std::minmax(copy(a).id, copy(b).id);
  return std::ranges::binary_search(told_, ids, {}, ids_of);
}

/// Those that this rank tells, if they are pairs. And those that it told in the step before: it has to know whether
/// they end, where another tells them now. What else is here several ranks have, and one of them looks at it.
void DistributedWorld::State::find_pairs() {
  for (auto& [id, way] : ways_) way.reached = reached_box(local_.at(id));
  if (ranks_.count() == 1)
    world_.step();
  else
    world_.step([&](BodyId a, BodyId b) { return teller_of(a, b) == ranks_.rank() || was_told(a, b); });
  last_.costs.candidates = world_.last_step().candidates;
}

/// As a World tells them of (a, b), whichever of the two has the lesser index here.
void DistributedWorld::State::add_details(std::span<GlobalPairReport> pairs) const {
  const bool of_all = tells_details(options_.world);
  if (!of_all && ways_.empty()) return;
  std::vector<Body> bodies;
  BodiesOnTheWay on_the_way;
  std::vector<UndecidedPair> undecided;
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
    undecided.push_back({decided.size(), world_.pair_margin(a, b).value_or(0)});
    decided.push_back({{first, second}});
    asked.push_back(&pair);
  }
  NarrowPhase(options_.world).decide(bodies, on_the_way, undecided, decided);
  for (std::size_t i = 0; i < asked.size(); ++i) asked[i]->details = decided[i].details;
}

void DistributedWorld::State::tell(std::span<const LocalPair> found, std::vector<GlobalPairReport> now) {
  // What this rank told before and another tells now: that rank is told that it goes on. The bodies are both still
  // here, as what goes elsewhere is given up only after this.
  Letters letters;
  std::vector<GlobalPairReport> ended;
  std::vector<PairOfIds> before;
  for (const GlobalPairReport& told : told_) {
    const auto at = std::lower_bound(found.begin(), found.end(), LocalPair{told}, is_of_lesser_ids);
    const bool is_found = at != found.end() && ids_of(at->report) == ids_of(told);
    if (!is_found || removed_.contains(told.a) || removed_.contains(told.b))
      ended.push_back(told);
    else if (at->teller == ranks_.rank())
      before.push_back(ids_of(told));
    else
      put_ids(letters[at->teller], ids_of(told));
  }
  for (const Received& received : ranks_.exchange(letters))
    for (MessageReader reader(received.bytes); !reader.is_at_end();) {
      const GlobalId a = reader.get_number();
      before.emplace_back(a, reader.get_number());
    }
  std::sort(before.begin(), before.end());

  last_.begin.clear();
  last_.persist.clear();
  for (const GlobalPairReport& report : now)
    (std::binary_search(before.begin(), before.end(), ids_of(report)) ? last_.persist : last_.begin).push_back(report);
  last_.end = std::move(ended);
  told_ = std::move(now);
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
  const std::vector<Received> received = ranks_.exchange(letters);
  seconds.sending = clock.lap();
  all_do([&] {
    receive(changes, received);
    seconds.receiving = clock.lap();
    find_pairs();
  });
  seconds.pairs = clock.lap();
  std::vector<LocalPair> found;
  std::vector<GlobalPairReport> now;
  all_do([&] {
    found = found_pairs();
    for (const LocalPair& pair : found)
      if (pair.teller == ranks_.rank()) now.push_back(pair.report);
    add_details(now);
  });
  tell(found, std::move(now));
  arrive();
  count_costs();
  give_up_what_left();
  last_.costs.ghosts = world_.size() - last_.costs.bodies;
  seconds.telling = clock.lap();
}

const DistributedStep& DistributedWorld::State::step() {
  WantedChanges changes = std::exchange(wanted, {});
  require_whole();
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
