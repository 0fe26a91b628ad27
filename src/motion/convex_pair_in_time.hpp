#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "motion/convex_gap.hpp"
#include "motion/first_contact.hpp"
#include "toccata/core/function_ref.hpp"

namespace toccata {

/// What a gap has to be more than, for shapes that are posed within the pad.
[[nodiscard]] inline double wanted_gap(double pad, double stop_before) {
  return pad * (1 + 0x1p-40) + (stop_before + 4 * unit_roundoff * std::fabs(stop_before));
}

/// Becomes the set where it is needed: an optional of it need not copy it.
template <class S>
struct MadeInPlace {
  FunctionRef<S(double)> at;
  double time;
  operator S() const { return at(time); }
};

/// Two convex sets of which it is told where they are at a time; looked for is when they come nearer than
/// `stop_before`, or, where that is negative, when they are deeper in each other.
template <PosedConvexSet A, PosedConvexSet B>
class ConvexPairInTime final : public MovingPair {
 public:
  ConvexPairInTime(FunctionRef<A(double)> a, FunctionRef<B(double)> b, double pad, double stop_before)
      : a_at_(a), b_at_(b), pad_(pad), stop_before_(stop_before) {}

  [[nodiscard]] Vec3 direction(double time) override {
    go_to(time);
    const Vec3 found = parting_direction(*a_, *b_, kept_);
    return found == Vec3{} && stop_before_ < 0 ? direction_of_depth(*a_, *b_) : found;
  }

  [[nodiscard]] double separation(double time, const Vec3& direction) override {
    go_to(time);
    return separation_along(*a_, *b_, direction) - wanted_gap(pad_, stop_before_);
  }

  [[nodiscard]] bool surely_meet(double time) override {
    go_to(time);
    if (stop_before_ > 2 * pad_) return distance_of(*a_, *b_).upper <= (stop_before_ - pad_) * (1 - 0x1p-40);
    return overlap_by(*a_, *b_, pad_ + std::max(0.0, -stop_before_));
  }

 private:
  void go_to(double time) {
    if (a_ && time == time_) return;
    a_.emplace(MadeInPlace<A>{a_at_, time});
    b_.emplace(MadeInPlace<B>{b_at_, time});
    time_ = time;
  }

  FunctionRef<A(double)> a_at_;
  FunctionRef<B(double)> b_at_;
  double pad_;
  double stop_before_;
  double time_ = 0;
  std::optional<A> a_;
  std::optional<B> b_;
  VertexPairs kept_;
};

}  // namespace toccata
