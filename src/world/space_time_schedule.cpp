#include "world/space_time_schedule.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "math/vec3_measures.hpp"
#include "toccata/broad/broad_phase.hpp"
#include "toccata/core/parallel.hpp"

namespace toccata {
namespace {

/// Calls `work(i)` for each i, rows of them on several threads.
template <class Work>
void for_rows(std::size_t count, int threads, const Work& work) {
  constexpr std::size_t at_once = 512;
  parallel_for((count + at_once - 1) / at_once, threads, [&](std::size_t row) {
    const std::size_t end = std::min(count, (row + 1) * at_once);
    for (std::size_t i = row * at_once; i < end; ++i) work(i);
  });
}

/// What is known of boxes by their mean size: how many pairs of them overlap, if they lie anywhere.
class BoxCrowd {
 public:
  void add(const Aabb& box) {
    const Vec3 size = box.upper - box.lower;
    if (!is_finite(size)) return;
    sizes_ += size;
    around_ = merge(around_, box);
    ++count_;
  }
  [[nodiscard]] double expected_pairs() const {
    const double count = static_cast<double>(count_);
    double pairs = 0.5 * count * count;
    for (int axis = 0; axis < 3 && count > 0; ++axis) {
      const double room = around_.upper[axis] - around_.lower[axis];
      if (room > 0) pairs *= std::min(1.0, 2 * sizes_[axis] / (count * room));
    }
    return pairs;
  }
  /// Where others have so many.
  [[nodiscard]] double pairs_beside(const BoxCrowd& others, double pairs) const {
    const double most = 0.5 * static_cast<double>(count_) * static_cast<double>(count_);
    for (int axis = 0; axis < 3; ++axis)
      if (others.sizes_[axis] > 0) pairs *= sizes_[axis] / others.sizes_[axis];
    return std::min(pairs, most);
  }

 private:
  std::size_t count_ = 0;
  Vec3 sizes_{};
  Aabb around_{};
};

}  // namespace

void SpaceTimeSchedule::put(Index index, const Body& body) {
  if (index >= states_.size()) {
    const std::size_t size = std::size_t{index} + 1;
    states_.resize(size);
    numbers_.resize(size);
    flights_.resize(size);
    parts_.resize(size);
    put_.resize(size);
    before_.resize(size);
    earlier_.resize(size);
  }
  land(index);
  parts_[index] = turning_parts(body);
  put_[index] = now_;
}

void SpaceTimeSchedule::land(Index index) {
  if (!is_flying(index)) return;
  states_[index] = State::landed;
  ++numbers_[index];
  --count_flying_;
}

void SpaceTimeSchedule::land_all() {
  for (Index i = 0; i < states_.size(); ++i) {
    if (is_flying(i)) landed_.push_back(i);
    land(i);
  }
}

/// The step before was broken off by an exception, so nobody has looked at what was due in it: the stretch ends here.
void SpaceTimeSchedule::break_off() {
  starting_.clear();
  end_ = now_;
  start_ = now_ + 3;
}

bool SpaceTimeSchedule::goes_on(Index index, const Body& body) {
  return flights_[index].goes_on(parts_[index], sight_of(parts_[index], body.pose), static_cast<double>(now_ - begin_));
}

std::span<const Index> SpaceTimeSchedule::begin_step(std::span<const Body> bodies, std::span<const Index> moved) {
  ++now_;
  landed_.clear();
  if (std::exchange(is_in_step_, true)) break_off();
  if (count_flying_ == 0) return landed_;
  if (now_ == end_) {
    land_all();
    return landed_;
  }
  const auto is_lost = [&](Index index) { return is_flying(index) && !goes_on(index, bodies[index]); };
  is_lost_.resize(moving_.size());
  for_rows(moving_.size(), threads_, [&](std::size_t i) { is_lost_[i] = is_lost(moving_[i]) ? 1 : 0; });
  for (std::size_t i = 0; i < moving_.size(); ++i)
    if (is_lost_[i] != 0) landed_.push_back(moving_[i]);
  for (const Index index : moved)
    if (is_flying(index) && flights_[index].is_at_rest() && is_lost(index)) landed_.push_back(index);
  for (const Index index : landed_) land(index);
  return landed_;
}

std::span<const Index> SpaceTimeSchedule::start(std::span<const Body> bodies, std::span<const Index> there,
                                                std::span<const Aabb> reached) {
  do {
    prepare_flights(bodies, there);
    BoxCrowd now, flown;
    for (std::size_t i = 0, next = 0; i < there.size() && next < starting_.size(); ++i) {
      if (there[i] != starting_[next]) continue;
      now.add(reached[i]);
      flown.add(box_of_flight(starting_[next++], reached[i]));
    }
    if (pace_.may_pay(starting_.size(),
                      std::max(flown.expected_pairs(), flown.pairs_beside(now, pace_.plain_pairs())))) {
      start_flights();
      return starting_;
    }
  } while (pace_.shorten());
  put_off_start();
  return {};
}

void SpaceTimeSchedule::prepare_flights(std::span<const Body> bodies, std::span<const Index> there) {
  begin_ = now_;
  end_ = start_ = now_ + static_cast<std::uint64_t>(pace_.steps());
  is_lost_.assign(there.size(), 1);
  for_rows(there.size(), threads_, [&](std::size_t i) {
    const Index index = there[i];
    if (put_[index] + 3 > now_) return;  // it was not there at both steps before
    const LastSights sights{sight_of(parts_[index], bodies[index].pose), before_[index], earlier_[index]};
    const std::optional<Flight> flight = flight_from(bodies[index], parts_[index], sights, pace_.steps());
    if (!flight) return;
    flights_[index] = *flight;
    is_lost_[i] = 0;
  });
  starting_.clear();
  for (std::size_t i = 0; i < there.size(); ++i)
    if (is_lost_[i] == 0) starting_.push_back(there[i]);
}

void SpaceTimeSchedule::start_flights() {
  appointments_.resize(static_cast<std::size_t>(pace_.steps()));
  for (std::vector<Appointment>& some : appointments_) some.clear();
  moving_.clear();
  for (const Index index : starting_) {
    states_[index] = State::starting;
    if (!flights_[index].is_at_rest()) moving_.push_back(index);
  }
  count_flying_ = starting_.size();
  pace_.begin();
}

void SpaceTimeSchedule::put_off_start() {
  starting_.clear();
  end_ = now_;
  start_ = now_ + static_cast<std::uint64_t>(pace_.end_badly());
}

Aabb SpaceTimeSchedule::box_of_flight(Index index, const Aabb& reached) const {
  return box_until({reached, motion_now(index)}, static_cast<double>(end_ - begin_ - 1));
}

std::span<const IndexPair> SpaceTimeSchedule::pairs_of_step(std::span<const IndexPair> overlapping, std::size_t count) {
  if (count_flying_ == 0) return overlapping;
  due_.clear();
  for (const Appointment& at : appointments_[now_ - begin_])
    if (numbers_[at.pair.first] == at.flight_a && numbers_[at.pair.second] == at.flight_b) due_.push_back(at.pair);
  if (!std::is_sorted(due_.begin(), due_.end())) std::sort(due_.begin(), due_.end());
  if (count_flying_ == count && starting_.empty()) return due_;
  // No pair comes twice: appointments are of bodies that fly.
  const auto flies = [&](Index index) { return states_[index] == State::flying; };
  looked_.clear();
  auto due = due_.begin();
  for (const IndexPair& pair : overlapping) {
    if (flies(pair.first) && flies(pair.second)) continue;
    for (; due != due_.end() && *due < pair; ++due) looked_.push_back(*due);
    looked_.push_back(pair);
  }
  looked_.insert(looked_.end(), due, due_.end());
  return looked_;
}

SpaceTimeMotion SpaceTimeSchedule::motion_now(Index index, double turning_speed) const {
  SpaceTimeMotion motion = flights_[index].motion();
  const double gone = static_cast<double>(now_ - begin_) * motion.max_acceleration;
  motion.velocity_error = (motion.velocity_error + gone + turning_speed) * (1 + 0x1p-50);
  return motion;
}

void SpaceTimeSchedule::look_when_near(const IndexPair& pair, const Aabb& reached_a, const Aabb& reached_b) {
  look_again(pair, whole_steps(earliest_contact(SpaceTimeBox{reached_a, motion_now(pair.first)},
                                                {reached_b, motion_now(pair.second)})));
}

int SpaceTimeSchedule::whole_steps(double time) const {
  return time < steps_left() ? std::max(1, static_cast<int>(std::ceil(time))) : steps_left();
}

Ball SpaceTimeSchedule::inner_difference(const IndexPair& pair, std::span<const Body> bodies) const {
  if (!flights_[pair.first].is_rigid() || !flights_[pair.second].is_rigid()) return {{}, 0};
  const Ball a = inner_ball(parts_[pair.first], bodies[pair.first].pose);
  const Ball b = inner_ball(parts_[pair.second], bodies[pair.second].pose);
  return {a.centre - b.centre, a.radius > 0 && b.radius > 0 ? a.radius + b.radius : 0};
}

int SpaceTimeSchedule::steps_until(const IndexPair& pair, const AnswerLasts& lasts) const {
  if (lasts.gap.length > 0) return steps_apart(pair, lasts.gap);
  return lasts.radius > 0 ? steps_held(pair, lasts) : 1;
}

int SpaceTimeSchedule::steps_apart(const IndexPair& pair, const DirectedGap& gap) const {
  const Vec3 along = unit_or_zero(gap.direction);
  const auto motion = [&](Index index) {
    return motion_now(index, flights_[index].turning_speed(parts_[index], along));
  };
  return whole_steps(earliest_contact(gap.length, along, motion(pair.first), motion(pair.second)));
}

/// The length of a vector that moves evenly, and what errors add, are convex in time: between two steps at which they
/// are within the radius they are so too.
int SpaceTimeSchedule::steps_held(const IndexPair& pair, const AnswerLasts& lasts) const {
  const auto motion = [&](Index index) { return motion_now(index, lasts.turning * flights_[index].turning_speed()); };
  const SpaceTimeMotion a = motion(pair.first), b = motion(pair.second);
  const Vec3 velocity = a.velocity - b.velocity;
  const auto is_held = [&](int steps) {
    const double off = length(lasts.offset + steps * velocity) + (greatest_error(a, steps) + greatest_error(b, steps));
    return off <= lasts.radius * (1 - 0x1p-40);
  };
  if (!is_held(1)) return 1;
  int held = 1, not_held = steps_left();
  while (not_held - held > 1) (is_held((held + not_held) / 2) ? held : not_held) = (held + not_held) / 2;
  return not_held;
}

double SpaceTimeSchedule::closing_in(const IndexPair& pair, int steps) const {
  const double last = steps - 1;
  const SpaceTimeMotion a = motion_now(pair.first), b = motion_now(pair.second);
  const double errors = greatest_error(a, last) + greatest_error(b, last);
  return (length(b.velocity - a.velocity) * last + errors) * (1 + 0x1p-20);
}

void SpaceTimeSchedule::look_again(const IndexPair& pair, int steps) {
  if (steps >= steps_left()) return;  // then all pairs are looked at
  appointments_[now_ - begin_ + static_cast<std::uint64_t>(steps)].push_back(
      {pair, numbers_[pair.first], numbers_[pair.second]});
}

void SpaceTimeSchedule::see(std::span<const Body> bodies) {
  std::swap(before_, earlier_);
  for_rows(states_.size(), threads_, [&](std::size_t i) { before_[i] = sight_of(parts_[i], bodies[i].pose); });
}

void SpaceTimeSchedule::plan(const StepWork& work) {
  if (now_ >= end_) {
    pace_.note_plain(work);
  } else if (!pace_.note_flown(work)) {
    end_ = now_ + 1;
    start_ = end_ + static_cast<std::uint64_t>(pace_.end_badly());
  } else if (now_ + 1 == end_) {
    start_ = end_ + static_cast<std::uint64_t>(pace_.end_well());
  }
}

void SpaceTimeSchedule::end_step(std::span<const Body> bodies, const StepWork& work) {
  for (const Index index : starting_)
    if (is_flying(index)) states_[index] = State::flying;
  starting_.clear();
  plan(work);
  if (now_ + 2 >= start_ && now_ < start_) see(bodies);
  is_in_step_ = false;
}

}  // namespace toccata
