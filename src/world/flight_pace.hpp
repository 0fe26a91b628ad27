#pragma once

#include <cstddef>
#include <cstdint>

namespace toccata {

/// What a step of a World did, counted.
struct StepWork {
  std::size_t bodies = 0;   ///< that there are
  std::size_t placed = 0;   ///< given to the broad phase anew
  std::size_t started = 0;  ///< bodies that begin to fly
  std::size_t tested = 0;   ///< whether they left their bounds
  std::size_t looked = 0;   ///< pairs
  std::size_t asked = 0;    ///< pairs of which the shapes were looked at
};

/// How long stretches of steps are in which bodies fly, and how many steps are taken the plain way between them.
/// Decided by what was counted, so that it is the same in every run: a stretch costs less than as many plain steps, or
/// it ends, and the next one is tried later and later.
class FlightPace {
 public:
  /// The number of steps of the next stretch, or of the present one.
  [[nodiscard]] int steps() const { return steps_; }
  /// Takes note of the work of a step taken the plain way.
  void note_plain(const StepWork& work) {
    plain_ = cost_of(work);
    plain_pairs_ = static_cast<double>(work.looked);
  }
  /// How many pairs of boxes overlapped in the last plain step.
  [[nodiscard]] double plain_pairs() const { return plain_pairs_; }
  /// Whether a stretch may save time that begins with so many bodies, and about so many pairs of their boxes.
  [[nodiscard]] bool may_pay(std::size_t bodies, double pairs) const;
  /// Makes the next stretch shorter. False where it is as short as any.
  [[nodiscard]] bool shorten();
  /// A stretch begins.
  void begin();
  /// Takes note of the work of a step of a stretch. Returns whether the stretch goes on.
  [[nodiscard]] bool note_flown(const StepWork& work);
  /// The stretch is over. Returns how many plain steps come before the next.
  [[nodiscard]] int end_well();
  /// The stretch was broken off. Returns the same.
  [[nodiscard]] int end_badly();

 private:
  /// In nanoseconds, on a machine of about 2024. Only ratios matter.
  [[nodiscard]] static double cost_of(const StepWork& work);
  /// Chooses how many steps the next stretch has.
  void choose_steps();
  /// The length that was tried was no better.
  void end_trial();

  static constexpr int least_steps = 4, most_steps = 64;
  static constexpr int first_pause = 100, most_pause = 1600;
  static constexpr int stretches_between_plain = 16;  ///< after which it is seen anew what the plain way costs
  static constexpr int steps_seen = 3;
  static constexpr double enough = 0.85;  ///< of what the plain way costs, for a stretch to be worth its while
  int steps_ = 16;
  int pause_ = first_pause;
  int in_a_row_ = 0;
  double plain_pairs_ = 0;
  double plain_ = 0, spent_ = 0;  ///< a plain step; this stretch
  int kept_steps_ = 16, until_trial_ = 0;
  double kept_cost_ = 0;  ///< of a step, in the last stretch of that length
  bool tries_longer_ = true;
};

}  // namespace toccata
