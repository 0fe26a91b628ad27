#include <algorithm>

#include "world/world_state.hpp"

// What a step does besides with space_time.
namespace toccata {

std::span<const IndexPair> World::State::pairs_to_look_at() {
  if (schedule_) {
    const std::span<const Index> landed = schedule_->begin_step(bodies_, changed_);
    if (schedule_->is_start()) let_fly();
    place(landed);
  }
  phase_.update();
  return schedule_ ? schedule_->pairs_of_step(phase_.pairs(), count_) : phase_.pairs();
}

void World::State::let_fly() {
  std::vector<Index> there;
  for (Index i = 0; i < slots_.size(); ++i)
    if (slots_[i].is_used && !on_the_way_.contains(i)) there.push_back(i);
  std::vector<Aabb> reached;
  for (const Index index : there) reached.push_back(reached_box(index));
  const std::span<const Index> starting = schedule_->start(bodies_, there, reached);
  work_.started = starting.size();
  reached_boxes_.clear();
  for (const Index index : starting) reached_boxes_.push_back(schedule_->box_of_flight(index, reached_box(index)));
  give_to_phase(starting);
}

void World::State::give_to_phase(std::span<const Index> indices) {
  if (schedule_ && schedule_->counts_work())
    for (std::size_t i = 0; i < indices.size(); ++i)
      if (phase_.box(indices[i]) != reached_boxes_[i]) ++work_.placed;
  phase_.move(indices, reached_boxes_);
}

void World::State::want_beyond(const IndexPair& pair, bool was_apart, UndecidedPair& wanted) const {
  if (!schedule_->are_flying(pair)) return;
  // Of two that were not as far apart as for the whole stretch less is asked, and not always: it mostly costs more than
  // it saves.
  if (was_apart && schedule_->is_odd()) return;
  constexpr int few = 4;
  const int steps = was_apart ? std::min(few, schedule_->steps_left()) : schedule_->steps_left();
  if (steps < 2) return;
  const double beyond = (wanted.margin + schedule_->closing_in(pair, steps)) * (1 + 0x1p-50);
  wanted.beyond = beyond;
  wanted.steps = steps;
}

void World::State::end_scheduled_step(std::size_t looked, std::span<const UndecidedPair> undecided) {
  auto next = undecided.begin();
  for (std::size_t i = 0; schedule_->count_flying() > 0 && i < decided_.size(); ++i) {
    const bool was_asked = next != undecided.end() && next->number == i;
    const bool is_beyond = decided_[i].nearness == BodyNearness::beyond;
    if (schedule_->are_flying(decided_[i].pair)) schedule_->look_again(decided_[i].pair, is_beyond ? next->steps : 1);
    if (is_beyond) decided_[i].nearness = BodyNearness::apart;
    if (was_asked) ++next;
  }
  work_.bodies = count_;
  work_.tested = schedule_->count_tested();
  work_.looked = looked;
  work_.asked = undecided.size();
  schedule_->end_step(bodies_, work_);
  work_ = {};
}

}  // namespace toccata
