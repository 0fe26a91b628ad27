#include <algorithm>
#include <iterator>
#include <utility>

#include "core/empty_list.hpp"
#include "toccata/core/error.hpp"
#include "world/world_state.hpp"

namespace toccata {
namespace {

bool comes_before_pair(const DecidedPair& decided, const IndexPair& pair) { return decided.pair < pair; }

std::pair<BodyId, BodyId> key_of(const PairReport& report) { return {report.a, report.b}; }

}  // namespace

bool World::State::may_meet(const Slot& a, const Slot& b) const {
  if (a.type != BodyType::dynamic_body && b.type != BodyType::dynamic_body) {
    const bool both_static = a.type == BodyType::static_body && b.type == BodyType::static_body;
    if (both_static || !options_.kinematic_pairs) return false;
  }
  return (a.category & b.mask) != 0 && (b.category & a.mask) != 0;
}

std::optional<double> World::State::margin_of(const IndexPair& pair) const {
  const Slot &a = slots_[pair.first], &b = slots_[pair.second];
  if (!may_meet(a, b)) return std::nullopt;
  double margin = a.margin + b.margin;
  if (!a.has_rules || !b.has_rules) return margin;
  if (const PairRules::Rule* rule = rules_.find(pair.first, pair.second)) {
    if (rule->excluded) return std::nullopt;
    margin = rule->margin.value_or(margin);
  }
  return margin;
}

/// Other pairs of the two may have larger margins than this one; what has none and does not fly is in the broad phase
/// with its own box, which is not fetched again.
bool World::State::may_be_near(const IndexPair& pair, double margin) const {
  const auto is_as_found = [&](const Slot& slot) { return slot.margin == 0 && !slot.has_rules; };
  if (!schedule_ && is_as_found(slots_[pair.first]) && is_as_found(slots_[pair.second])) return true;
  const Aabb &a = box_on_the_way(pair.first), &b = box_on_the_way(pair.second);
  return overlap(a, b) || (margin != 0 && overlap(offset_outward(a, margin), b));
}

/// The pairs to be decided, of which what is known already is filled in.
std::vector<DecidedPair> World::State::candidates(std::span<const IndexPair> looked, const WantedPairs* are_wanted,
                                                  UndecidedPairs& undecided) {
  std::vector<DecidedPair> found;
  found.reserve(looked.size());
  undecided.pairs.reserve(looked.size());
  auto known = decided_.begin();
  for (const IndexPair& pair : looked) {
    const std::optional<double> margin = margin_of(pair);
    if (!margin) continue;
    if (!may_be_near(pair, *margin)) {
      if (schedule_ && schedule_->are_flying(pair))
        schedule_->look_when_near(pair, reached_box(pair.first), reached_box(pair.second));
      continue;
    }
    if (are_wanted != nullptr && !(*are_wanted)(id_of(pair.first), id_of(pair.second))) continue;
    while (known != decided_.end() && comes_before_pair(*known, pair)) ++known;
    const bool was_looked_at = known != decided_.end() && known->pair == pair;
    const bool is_as_it_was = was_looked_at && !slots_[pair.first].has_changed && !slots_[pair.second].has_changed;
    const bool is_sure = was_looked_at && schedule_ && schedule_->is_sure(pair, known->sure_until);
    if (is_as_it_was || is_sure) {
      found.push_back(*known);
      if (!is_sure) found.back().sure_until = 0;
      continue;
    }
    undecided.pairs.push_back({found.size(), *margin});
    if (schedule_) undecided.lasting.push_back(lasting_of(pair, *margin));
    found.push_back(DecidedPair{pair});
  }
  return found;
}

template <class Visit>
void World::State::visit_reports(const Visit& visit) const {
  for (const DecidedPair& decided : decided_)
    if (is_told(decided.nearness))
      visit(PairReport{id_of(decided.pair.first), id_of(decided.pair.second), decided.nearness == BodyNearness::contact,
                       decided.details});
}

std::vector<PairReport> World::State::reports() const {
  std::vector<PairReport> now;
  now.reserve(decided_.size());
  visit_reports([&](PairReport report) { now.push_back(std::move(report)); });
  return now;
}

void World::State::tell(std::vector<PairReport> now) {
  const std::size_t most_kept = std::min(now.size(), pairs_.size());
  empty_list(last_.begin, now.size() - most_kept);
  empty_list(last_.persist, most_kept);
  empty_list(last_.end, pairs_.size() - most_kept);
  auto before = pairs_.begin();
  for (const PairReport& report : now) {
    for (; before != pairs_.end() && key_of(*before) < key_of(report); ++before) last_.end.push_back(*before);
    const bool is_kept = before != pairs_.end() && key_of(*before) == key_of(report);
    (is_kept ? last_.persist : last_.begin).push_back(report);
    if (is_kept) ++before;
  }
  last_.end.insert(last_.end.end(), before, pairs_.end());
  pairs_ = std::move(now);
}

void World::State::forget_pairs() {
  free_list(pairs_);
  free_list(last_.begin);
  free_list(last_.persist);
  free_list(last_.end);
}

const WorldStep& World::State::step(const Asking& asking) {
  if (asking.are_wanted != nullptr && schedule_)
    throw Error(
        "a World with space_time looks at all pairs: take one without it to look at those alone that are wanted");
  const std::span<const IndexPair> looked = pairs_to_look_at();
  UndecidedPairs undecided;
  std::vector<DecidedPair> found = candidates(looked, asking.are_wanted, undecided);
  narrow_.decide(bodies_, on_the_way_, undecided, found, asking.progress != nullptr ? *asking.progress : Progress());
  decided_ = std::move(found);
  last_.candidates = decided_.size();
  last_.asked = undecided.pairs.size();
  if (schedule_) end_scheduled_step(looked.size(), undecided);
  for (const Index index : changed_) slots_[index].has_changed = false;
  changed_.clear();
  arrive();
  if (asking.see == nullptr) {
    tell(reports());
  } else {
    forget_pairs();
    visit_reports(*asking.see);
  }
  return last_;
}

}  // namespace toccata
