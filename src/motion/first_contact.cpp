#include "motion/first_contact.hpp"

#include <algorithm>
#include <cmath>

#include "math/constants.hpp"

namespace toccata {
namespace {

/// More than any pair was seen to need; what needs more is not converged.
constexpr int most_steps = 1 << 16;

/// How often the time after a contact is made four times as long to prove it: to 10⁹ times of the first.
constexpr int most_proofs = 15;

/// A direction, and how far the two are apart along it at some time.
struct Parting {
  Vec3 direction{};
  double separation = -infinity;
};

class ContactAdvance {
 public:
  ContactAdvance(MovingPair& pair, const TimeStretch& stretch, const GapBounds& bounds)
      : pair_(pair), end_(stretch.end), bounds_(bounds), time_(stretch.begin), now_(seeming_best(time_)) {}

  std::optional<FirstContact> run() {
    for (int step = 0; step < most_steps; ++step) {
      // Not by a comparison that NaN passes.
      if (!(now_.separation > bounds_.pad)) return contact(Status::undecided);
      if (!advance()) return contact(Status::undecided);
      if (time_ >= end_) return {};
    }
    return contact(Status::not_converged);
  }

 private:
  [[nodiscard]] Parting seeming_best(double time) {
    const Vec3 found = pair_.direction(time);
    return found == Vec3{} ? Parting{} : along(found, time);
  }

  [[nodiscard]] Parting along(const Vec3& direction, double time) {
    return {direction, pair_.separation(time, direction)};
  }

  /// To a time up to which one direction, at rest or turning, keeps the two apart; tells whether there is one.
  bool advance() {
    double step = first_step(), last = infinity;
    for (int tries = 0;; ++tries) {
      const double to = std::min(time_ + step, end_), taken = to - time_;
      // A shorter step that is rounded to the same time will not become shorter, and none is no advance.
      if (!(to < last) || !(taken > 0)) return false;
      last = to;
      const Parting of_last = along(now_.direction, to);
      const bool is_free = rests_free(of_last, taken);
      // At the end of the way no direction is needed any more.
      const Parting then = is_free && to == end_ ? of_last : better_of(seeming_best(to), of_last);
      if (is_free || turns_free(then, taken)) {
        note((now_.separation - then.separation) / taken, taken);
        now_ = then;
        time_ = to;
        return true;
      }
      step = shorter(taken, (now_.separation - of_last.separation) / taken, tries);
    }
  }

  /// The one that was found where both are as good: of a half-space all are, and it is its normal then.
  static Parting better_of(const Parting& found, const Parting& of_last) {
    return found.separation >= of_last.separation ? found : of_last;
  }

  /// A direction may turn within the step, evenly from the one n that is the best at its beginning to the one m that is
  /// at its end: with r the way from a point of one to a point of the other, the second derivative of n(t) · r(t) is
  /// n · r″ + 2 n′ · r′, of at most bending + 2 |m − n| / step · speed. With radii the points are of the cores, and a
  /// gap of n · r less both radii, with |n| ≤ 1, is one of no less along n / |n|.
  [[nodiscard]] bool turns_free(const Parting& then, double taken) const {
    if (!pair_.may_turn()) return false;
    GapBounds turning = bounds_;
    turning.bending += 2 * length(then.direction - now_.direction) / taken * bounds_.speed * (1 + 0x1p-40);
    turning.speed = infinity;
    return is_gap_until(then.separation, taken, turning);
  }

  [[nodiscard]] bool rests_free(const Parting& then, double taken) const {
    return bounds_.speed * taken * (1 + 0x1p-30) < now_.separation || is_gap_until(then.separation, taken, bounds_);
  }

  [[nodiscard]] bool is_gap_until(double then, double taken, const GapBounds& bounds) const {
    return least_between(now_.separation, then, taken * (1 + 0x1p-50), bounds) > 0;
  }

  /// No longer than twice what would do if the gap stayed as it is, and until shortly before it closes if it closes as
  /// it did in the last step.
  [[nodiscard]] double first_step() const {
    const double gap = now_.separation;
    const double by_speed = gap / bounds_.speed, by_bending = std::sqrt(8 * gap / bounds_.bending);
    const double free = 2 * std::max(by_speed, by_bending);
    return std::min({free, std::max(until_closed(free), by_speed), end_ - time_});
  }

  /// Towards where the gap would close if it closed evenly: the first time by a 64th at least, and every later time by
  /// a third, so that this ends where the speed alone tells.
  [[nodiscard]] double shorter(double step, double closing, int tries) const {
    const double until_closed = closing > 0 ? (63.0 / 64) * now_.separation / closing : step;
    return std::clamp(until_closed, step / 64, tries == 0 ? step * (63.0 / 64) : step / 1.5);
  }

  /// Shortly before the gap closes as it was last seen to close. By then the closing may be faster by
  /// change · (half of the step in which it was seen and of that to come), as a share of the gap when it is closed; so
  /// much of it is left, a 64th at most, and half a pad at least. What is left is so with every step the square of what
  /// was left before, but for a factor.
  [[nodiscard]] double until_closed(double otherwise) const {
    if (!(seen_.closing > 0)) return otherwise;
    const double gap = now_.separation, step = gap / seen_.closing;
    const double faster = 0.5 * seen_.change * (seen_.step + step) / seen_.closing;
    const double left = std::max(std::min(faster, 1.0 / 64) * gap, 0.5 * bounds_.pad);
    return (gap - left) / seen_.closing;
  }

  /// The closing changes as the points bend and as the direction turns: twice as fast at most, it is thought, as it did
  /// between the last two steps.
  void note(double closing, double step) {
    const double change = 2 * std::fabs(closing - seen_.closing) / (0.5 * (step + seen_.step));
    seen_ = {step, closing, seen_.step > 0 ? change : infinity};
  }

  /// The time is where they come nearer than is certain: are they met then, or how soon after?
  [[nodiscard]] FirstContact contact(Status unproved) {
    FirstContact found{time_, time_, -now_.direction, unproved};
    double later = first_proof(), to = time_;
    for (int i = 0; i <= most_proofs; ++i, later *= 4) {
      if (surely_meet(to)) {
        found.upper = to;
        found.status = Status::exact;
        break;
      }
      if (to == end_) break;
      to = std::min(time_ + later, end_);
    }
    return found;
  }

  /// How long they take, as fast as they were last seen to close, until what surely_meet asks for can be: from a gap of
  /// two pads to a depth of some 2 √3.
  [[nodiscard]] double first_proof() const {
    const double least = std::max(0x1p-50 * time_, 0x1p-100);
    if (seen_.closing > 0) return std::max(6 * bounds_.pad / seen_.closing, least);
    return bounds_.speed > 0 ? std::max(bounds_.pad / bounds_.speed, least) : least;
  }

  /// Sets whose gap along some direction is not below −2 pads cannot be proved to meet, and this is known sooner.
  [[nodiscard]] bool surely_meet(double time) {
    const bool is_deep = now_.direction == Vec3{} || !(pair_.separation(time, now_.direction) > -2 * bounds_.pad);
    return is_deep && pair_.surely_meet(time);
  }

  /// How much the gap last closed in a unit of time, in what step, and how fast that may change.
  struct Closing {
    double step = 0;
    double closing = 0;
    double change = infinity;
  };

  MovingPair& pair_;
  double end_;
  const GapBounds& bounds_;
  double time_;
  Parting now_;
  Closing seen_;
};

}  // namespace

std::optional<FirstContact> first_contact(MovingPair& pair, const TimeStretch& stretch, const GapBounds& bounds) {
  return ContactAdvance(pair, stretch, bounds).run();
}

}  // namespace toccata
