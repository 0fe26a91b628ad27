#include <algorithm>

#include "math/constants.hpp"
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

double World::State::greatest_depth(const IndexPair& pair) const {
  const Aabb &a = boxes_[pair.first], &b = boxes_[pair.second];
  double depth = infinity;
  for (int axis = 0; axis < 3; ++axis)
    depth = std::min({depth, a.upper[axis] - b.lower[axis], b.upper[axis] - a.lower[axis]});
  return depth;
}

WantedLasting World::State::lasting_of(const IndexPair& pair, double margin) const {
  constexpr int few = 4;
  WantedLasting wanted;
  if (!schedule_->are_flying(pair) || schedule_->steps_left() < 2) return wanted;
  wanted.enough = schedule_->closing_in(pair, schedule_->steps_left());
  if (tells_details(options_) || schedule_->steps_left() <= few) return wanted;
  wanted.inner = schedule_->inner_difference(pair, bodies_);
  // For two that stay a pair this is asked for besides, and it costs as much as some steps.
  const double most = std::max(std::min(greatest_depth(pair), wanted.inner.radius), 0.5 * margin);
  wanted.of_told = most > schedule_->closing_in(pair, few);
  return wanted;
}

void World::State::end_scheduled_step(std::size_t looked, const UndecidedPairs& undecided) {
  for (std::size_t i = 0; i < undecided.pairs.size(); ++i) {
    DecidedPair& decided = decided_[undecided.pairs[i].number];
    if (!schedule_->are_flying(decided.pair)) continue;
    const int steps = schedule_->steps_until(decided.pair, undecided.lasting[i].lasts);
    decided.sure_until = schedule_->step_after(steps);
    if (!is_told(decided.nearness)) schedule_->look_again(decided.pair, steps);
  }
  // What is told is told at every step. What was taken over from the step before has no other appointment.
  if (schedule_->count_flying() > 0)
    for (const DecidedPair& decided : decided_)
      if ((is_told(decided.nearness) || decided.sure_until == 0) && schedule_->are_flying(decided.pair))
        schedule_->look_again(decided.pair, 1);
  work_.bodies = count_;
  work_.tested = schedule_->count_tested();
  work_.looked = looked;
  work_.asked = undecided.pairs.size();
  schedule_->end_step(bodies_, work_);
  work_ = {};
}

}  // namespace toccata
