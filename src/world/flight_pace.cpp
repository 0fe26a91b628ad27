#include "world/flight_pace.hpp"

#include <algorithm>

namespace toccata {

double FlightPace::cost_of(const StepWork& work) {
  const auto of = [](std::size_t count, double nanoseconds) { return static_cast<double>(count) * nanoseconds; };
  // The broad phase keeps what rests when few move.
  const bool are_few = of(work.placed, 1) < 0.12 * of(work.bodies, 1);
  const double broad = are_few ? of(work.bodies, 20) + of(work.placed, 500) : of(work.bodies, 150);
  return (work.placed == 0 ? 0 : broad) + of(work.tested, 30) + of(work.looked, 30) + of(work.asked, 200);
}

bool FlightPace::may_pay(std::size_t bodies, double pairs) const {
  constexpr double of_body = 400, of_pair = 60;
  return of_body * static_cast<double>(bodies) + of_pair * pairs < 0.6 * plain_ * steps_;
}

bool FlightPace::shorten() {
  if (steps_ == least_steps) return false;
  steps_ = std::max(steps_ / 2, least_steps);
  return true;
}

void FlightPace::begin() {
  spent_ = first_ = 0;
  flown_ = 0;
}

bool FlightPace::note_flown(const StepWork& work) {
  const double cost = cost_of(work);
  if (flown_++ == 0) first_ = cost;
  spent_ += cost;
  return spent_ < enough * plain_ * steps_;
}

int FlightPace::end_well() {
  // What the first step costs is spread over all; what the others cost grows with their number.
  const double rest = spent_ - first_;
  if (first_ > 2 * rest) steps_ = std::min(2 * steps_, most_steps);
  if (2 * first_ < rest) steps_ = std::max(steps_ / 2, least_steps);
  pause_ = first_pause;
  if (++in_a_row_ % stretches_between_plain != 0) return 0;
  return steps_seen;
}

int FlightPace::end_badly() {
  steps_ = std::max(steps_ / 2, least_steps);
  in_a_row_ = 0;
  const int pause = pause_;
  pause_ = std::min(4 * pause_, most_pause);
  return pause;
}

}  // namespace toccata
