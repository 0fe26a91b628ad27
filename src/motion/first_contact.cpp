#include "motion/first_contact.hpp"

#include <algorithm>
#include <cmath>

#include "math/constants.hpp"

namespace toccata {
namespace {

/// More than any pair was seen to need; what needs more is not converged.
constexpr int most_steps = 1 << 16;

/// How often the time after a contact is made four times as long to prove it: from 10⁻¹⁴ of the way to 10⁻⁵ of it.
constexpr int most_proofs = 15;

class ContactAdvance {
 public:
  ContactAdvance(MovingPair& pair, const TimeStretch& stretch, const GapBounds& bounds)
      : pair_(pair), end_(stretch.end), bounds_(bounds), time_(stretch.begin) {}

  std::optional<FirstContact> run() {
    for (int step = 0; step < most_steps; ++step) {
      look();
      // Not by a comparison that NaN passes.
      if (!(separation_ > bounds_.pad)) return contact(Status::undecided);
      const double reached = reach();
      if (reached >= end_) return {};
      if (!(reached > time_)) return contact(Status::undecided);
      time_ = reached;
    }
    return contact(Status::not_converged);
  }

 private:
  /// Takes the better of what seems best and of what was best before: close to contact the latter mostly is.
  void look() {
    const Vec3 found = pair_.direction(time_);
    const double of_last = direction_ == Vec3{} ? -infinity : pair_.separation(time_, direction_);
    const double of_found = found == Vec3{} ? -infinity : pair_.separation(time_, found);
    separation_ = of_last;
    if (!(of_found > of_last)) return;
    direction_ = found;
    separation_ = of_found;
  }

  /// A time up to which the direction keeps the two apart.
  double reach() {
    double step = first_step(), last = infinity;
    for (;;) {
      const double to = std::min(time_ + step, end_), taken = to - time_;
      // A shorter step that is rounded to the same time will not become shorter.
      if (!(to < last)) return time_;
      last = to;
      if (!(taken > 0) || bounds_.speed * taken * (1 + 0x1p-30) < separation_) return to;
      const double then = pair_.separation(to, direction_);
      closing_ = (separation_ - then) / taken;
      if (least_between(separation_, then, taken * (1 + 0x1p-50), bounds_) > 0) return to;
      step = shorter(taken);
    }
  }

  /// No longer than twice what would do if the gap stayed as it is, and until shortly before it closes if it closes as
  /// it did in the last step.
  [[nodiscard]] double first_step() const {
    const double by_speed = separation_ / bounds_.speed, by_bending = std::sqrt(8 * separation_ / bounds_.bending);
    const double free = 2 * std::max(by_speed, by_bending);
    const double closed = closing_ > 0 ? separation_ / closing_ * (63.0 / 64) : free;
    return std::min({free, std::max(closed, by_speed), end_ - time_});
  }

  /// Towards where the gap would close if it closed evenly, and by a third at least: this ends where the speed alone
  /// tells.
  [[nodiscard]] double shorter(double step) const {
    const double until_closed = closing_ > 0 ? separation_ / closing_ * (63.0 / 64) : step;
    return std::clamp(until_closed, step / 64, step / 1.5);
  }

  /// The time is where they come nearer than is certain: are they met then, or how soon after?
  [[nodiscard]] FirstContact contact(Status unproved) {
    FirstContact found{time_, time_, -direction_, unproved};
    const double least = std::max(0x1p-50 * time_, 0x1p-100);
    double later = bounds_.speed > 0 ? std::max(bounds_.pad / bounds_.speed, least) : least;
    double to = time_;
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

  /// Sets whose gap along some direction is not below −2 pads cannot be proved to meet, and this is known sooner.
  [[nodiscard]] bool surely_meet(double time) {
    const bool is_deep = direction_ == Vec3{} || !(pair_.separation(time, direction_) > -2 * bounds_.pad);
    return is_deep && pair_.surely_meet(time);
  }

  MovingPair& pair_;
  double end_;
  const GapBounds& bounds_;
  double time_;
  Vec3 direction_{};
  double separation_ = 0;
  double closing_ = 0;  ///< by how much in a unit of time, as last seen
};

}  // namespace

std::optional<FirstContact> first_contact(MovingPair& pair, const TimeStretch& stretch, const GapBounds& bounds) {
  return ContactAdvance(pair, stretch, bounds).run();
}

}  // namespace toccata
