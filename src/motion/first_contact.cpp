#include "motion/first_contact.hpp"

#include <algorithm>
#include <cmath>

#include "math/constants.hpp"

namespace toccata {
namespace {

/// More than any pair was seen to need; what needs more is not converged.
constexpr int most_steps = 1 << 16;

/// How often the time after a contact is doubled to prove it: from 10⁻¹⁴ of the way of a size to 10⁻⁵ of it.
constexpr int most_doublings = 30;

class Advance {
 public:
  Advance(MovingPair& pair, const Stretch& stretch, const GapBounds& bounds)
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
    double step = first_step();
    for (;;) {
      const double to = std::min(time_ + step, end_), taken = to - time_;
      if (!(taken > 0) || bounds_.speed * taken * (1 + 0x1p-30) < separation_) return to;
      const double then = pair_.separation(to, direction_);
      if (least_between(separation_, then, taken * (1 + 0x1p-50), bounds_) > 0) return to;
      step = shorter(taken, then);
    }
  }

  /// No longer than eight times what would do if the gap stayed as it is.
  [[nodiscard]] double first_step() const {
    const double by_speed = separation_ / bounds_.speed, by_bending = std::sqrt(8 * separation_ / bounds_.bending);
    return std::min(8 * std::max(by_speed, by_bending), end_ - time_);
  }

  /// Towards where the gap would close if it closed evenly, and halves at least: this ends where the speed alone tells.
  [[nodiscard]] double shorter(double step, double then) const {
    const double closing = separation_ - then;
    const double until_closed = closing > 0 ? step * (separation_ / closing) * (63.0 / 64) : step;
    return std::clamp(until_closed, step / 64, step / 2);
  }

  /// The time is where they come nearer than is certain: how soon after are they certainly met?
  [[nodiscard]] FirstContact contact(Status unproved) {
    FirstContact found{time_, time_, -direction_, unproved};
    const double least = 0x1p-50 * std::max(time_, 0x1p-50);
    double later = bounds_.speed > 0 ? std::max(bounds_.pad / bounds_.speed, least) : least;
    for (int i = 0; i < most_doublings; ++i, later *= 2) {
      const double to = std::min(time_ + later, end_);
      if (pair_.surely_meet(to)) {
        found.upper = to;
        found.status = Status::exact;
        break;
      }
      if (to == end_) break;
    }
    return found;
  }

  MovingPair& pair_;
  double end_;
  const GapBounds& bounds_;
  double time_;
  Vec3 direction_{};
  double separation_ = 0;
};

}  // namespace

std::optional<FirstContact> first_contact(MovingPair& pair, const Stretch& stretch, const GapBounds& bounds) {
  return Advance(pair, stretch, bounds).run();
}

}  // namespace toccata
