#include "world/flight_pace.hpp"

#include <algorithm>

namespace toccata {

double FlightPace::cost_of(const StepWork& work) {
  const auto of = [](std::size_t count, double nanoseconds) { return static_cast<double>(count) * nanoseconds; };
  // The broad phase keeps what rests when few move.
  const bool are_few = of(work.placed, 1) < 0.12 * of(work.bodies, 1);
  const double broad = are_few ? of(work.bodies, 20) + of(work.placed, 500) : of(work.bodies, 150);
  return (work.placed == 0 ? 0 : broad) + of(work.started, 400) + of(work.tested, 50) + of(work.looked, 30) +
         of(work.asked, 200);
}

/// What is looked at in plain steps, and told again as it is, may have to be looked at in flight too.
bool FlightPace::may_pay(std::size_t bodies, double pairs) const {
  constexpr double of_body = 400, of_pair = 60;
  return of_body * static_cast<double>(bodies) + of_pair * pairs < 0.6 * (plain_ - 30 * plain_pairs_) * steps_;
}

bool FlightPace::shorten() {
  if (steps_ == least_steps) return false;
  steps_ = kept_steps_ = std::max(steps_ / 2, least_steps);
  return true;
}

void FlightPace::begin() { spent_ = 0; }

bool FlightPace::note_flown(const StepWork& work) {
  spent_ += cost_of(work);
  return spent_ < enough * plain_ * steps_;
}

/// Goes from the present length to one that is better by so much, and now and then tries the next longer or shorter.
void FlightPace::choose_steps() {
  constexpr double clearly_better = 0.97;
  const double cost = spent_ / steps_;
  if (steps_ != kept_steps_ && !(cost < clearly_better * kept_cost_)) {
    end_trial();
    return;
  }
  kept_steps_ = steps_;
  kept_cost_ = cost;
  if (until_trial_-- > 0) return;
  const int next = tries_longer_ ? 2 * steps_ : steps_ / 2;
  if (next < least_steps || next > most_steps)
    tries_longer_ = !tries_longer_;
  else
    steps_ = next;
}

void FlightPace::end_trial() {
  constexpr int stretches_between_trials = 6;
  steps_ = kept_steps_;
  tries_longer_ = !tries_longer_;
  until_trial_ = stretches_between_trials;
}

int FlightPace::end_well() {
  choose_steps();
  pause_ = first_pause;
  if (++in_a_row_ % stretches_between_plain != 0) return 0;
  return steps_seen;
}

int FlightPace::end_badly() {
  if (steps_ != kept_steps_) {
    end_trial();
    return steps_seen;
  }
  steps_ = kept_steps_ = std::max(steps_ / 2, least_steps);
  in_a_row_ = 0;
  const int pause = pause_;
  pause_ = std::min(4 * pause_, most_pause);
  return pause;
}

}  // namespace toccata
