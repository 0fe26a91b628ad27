#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "toccata/bounds/aabb.hpp"
#include "toccata/core/index.hpp"
#include "toccata/world/body.hpp"
#include "world/bodies_on_the_way.hpp"
#include "world/flight.hpp"
#include "world/flight_pace.hpp"
#include "world/narrow_phase.hpp"

namespace toccata {

/// Which pairs of bodies a step has to look at, after P. M. Hubbard (1995).
///
/// For a stretch of steps bodies *fly*: each has a bound in space and time on where it can be (Flight), and the broad
/// phase has the box around that of all the stretch. For two bodies that fly, whose boxes overlap, it is computed when
/// they can meet at the earliest, and until then nobody looks at them. At each step it is tested for each body whether
/// it is where its bound says. One that is not *lands*: it is in the broad phase with its own box again, as all bodies
/// are without space_time, and its pairs are looked at each step.
class SpaceTimeSchedule {
 public:
  explicit SpaceTimeSchedule(int threads) : threads_(threads) {}

  /// The body has come, has become another, or is on its way along a motion.
  void put(Index index, const Body& body);
  void land(Index index);
  [[nodiscard]] bool is_flying(Index index) const { return index < states_.size() && states_[index] != State::landed; }
  [[nodiscard]] bool are_flying(const IndexPair& pair) const { return is_flying(pair.first) && is_flying(pair.second); }

  /// A step begins. The bodies that have landed now, ascending: they left their bounds, or the stretch is over.
  /// `moved`: whose pose is another than at the step before, in any order.
  std::span<const Index> begin_step(std::span<const Body> bodies, std::span<const Index> moved);
  /// Whether bodies are to fly from this step on.
  [[nodiscard]] bool is_start() const { return now_ == start_; }
  /// Lets fly what can, of these bodies, if by a guess it may pay. `reached`: their boxes, in which are all that may
  /// make a pair with them. Returns who flies.
  std::span<const Index> start(std::span<const Body> bodies, std::span<const Index> there,
                               std::span<const Aabb> reached);
  /// The box around where a body that has just begun to fly can be in the whole stretch.
  [[nodiscard]] Aabb box_of_flight(Index index, const Aabb& reached) const;

  /// The pairs to look at in this step, ascending, out of all that overlap in the broad phase. `count`: of bodies.
  std::span<const IndexPair> pairs_of_step(std::span<const IndexPair> overlapping, std::size_t count);

  // The following are about a pair that has been looked at, both of which fly.
  /// They are apart, as boxes that hold what reaches to the other: looked at again when these can meet.
  void look_when_near(const IndexPair& pair, const Aabb& reached_a, const Aabb& reached_b);
  /// How far the points of the two move against each other until so many steps from now, and a little more.
  [[nodiscard]] double closing_in(const IndexPair& pair, int steps) const;
  /// A ball within the difference of the first and the second, of radius 0 where none is known.
  [[nodiscard]] Ball inner_difference(const IndexPair& pair, std::span<const Body> bodies) const;
  /// After how many steps the pair has to be looked at again: 1 or more, and no more than are left.
  [[nodiscard]] int steps_until(const IndexPair& pair, const AnswerLasts& lasts) const;
  void look_again(const IndexPair& pair, int steps);
  [[nodiscard]] std::uint64_t step_after(int steps) const { return now_ + static_cast<std::uint64_t>(steps); }
  /// What was sure of a pair until that step in this stretch is so now: neither has landed.
  [[nodiscard]] bool is_sure(const IndexPair& pair, std::uint64_t until) const {
    return now_ < until && are_flying(pair);
  }
  /// How many steps there are from this one to the end of the stretch.
  [[nodiscard]] int steps_left() const { return static_cast<int>(end_ - now_); }
  [[nodiscard]] std::size_t count_flying() const { return count_flying_; }
  /// How many bodies were tested in this step whether they left their bounds.
  [[nodiscard]] std::size_t count_tested() const { return count_flying_ == 0 ? 0 : moving_.size(); }
  /// Whether what is done now says something about stretches: in one, and just before it.
  [[nodiscard]] bool counts_work() const { return now_ < end_ || now_ + 4 >= start_; }
  /// What the step has done.
  void end_step(std::span<const Body> bodies, const StepWork& work);

 private:
  enum class State : std::uint8_t {
    landed,
    starting,  ///< in this step
    flying,
  };
  /// A pair that is looked at again at some step, if both still fly as they did.
  struct Appointment {
    IndexPair pair;
    std::uint32_t flight_a, flight_b;
  };

  void prepare_flights(std::span<const Body> bodies, std::span<const Index> there);
  void start_flights();
  void put_off_start();
  void see(std::span<const Body> bodies);
  /// When the stretch ends, and the next begins.
  void plan(const StepWork& work);
  void land_all();
  void break_off();
  /// Whether it has gone on as it was said; to be asked once in a step.
  [[nodiscard]] bool goes_on(Index index, const Body& body);
  /// From now on, with this speed added to the errors.
  [[nodiscard]] SpaceTimeMotion motion_now(Index index, double turning_speed) const;
  [[nodiscard]] SpaceTimeMotion motion_now(Index index) const {
    return motion_now(index, flights_[index].turning_speed());
  }
  [[nodiscard]] int steps_apart(const IndexPair& pair, const DirectedGap& gap) const;
  [[nodiscard]] int steps_held(const IndexPair& pair, const AnswerLasts& lasts) const;
  [[nodiscard]] int whole_steps(double time) const;

  int threads_;
  FlightPace pace_;
  std::uint64_t now_ = 0;    ///< steps since the World began
  std::uint64_t begin_ = 0;  ///< of the stretch
  std::uint64_t end_ = 0;    ///< of the stretch; not after `now_` where none is
  std::uint64_t start_ = 3;  ///< of the next
  bool is_in_step_ = false;  ///< begun, and not ended
  // By index.
  std::vector<State> states_;
  std::vector<std::uint32_t> numbers_;  ///< of flights
  std::vector<Flight> flights_;
  std::vector<TurningParts> parts_;
  std::vector<std::uint64_t> put_;  ///< when the body came
  std::vector<Sight> before_, earlier_;
  // What belongs to the stretch.
  std::vector<Index> moving_;                           ///< what flies, or has flown, and does not rest
  std::vector<Index> starting_;                         ///< ascending
  std::vector<std::vector<Appointment>> appointments_;  ///< by step of the stretch
  std::size_t count_flying_ = 0;
  // Memory to work in.
  std::vector<Index> landed_;
  std::vector<std::uint8_t> is_lost_;
  std::vector<IndexPair> due_, looked_;
};

}  // namespace toccata
