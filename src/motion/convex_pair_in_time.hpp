#pragma once

#include <optional>

#include "motion/convex_gap.hpp"
#include "motion/first_contact.hpp"
#include "toccata/core/function_ref.hpp"

namespace toccata {

/// Two convex sets of which it is told where they are at a time; looked for is when they come as near as
/// `stop_before`.
template <PosedConvexSet A, PosedConvexSet B>
class ConvexPairInTime final : public MovingPair {
 public:
  ConvexPairInTime(FunctionRef<A(double)> a, FunctionRef<B(double)> b, double pad, double stop_before)
      : a_at_(a), b_at_(b), pad_(pad), stop_before_(stop_before) {}

  [[nodiscard]] Vec3 direction(double time) override {
    go_to(time);
    return parting_direction(*a_, *b_, kept_);
  }

  [[nodiscard]] double separation(double time, const Vec3& direction) override {
    go_to(time);
    return separation_along(*a_, *b_, direction) - (pad_ + stop_before_) * (1 + 0x1p-40);
  }

  [[nodiscard]] bool surely_meet(double time) override {
    go_to(time);
    if (stop_before_ > 2 * pad_) return distance_of(*a_, *b_).upper <= (stop_before_ - pad_) * (1 - 0x1p-40);
    return overlap_by(*a_, *b_, pad_);
  }

 private:
  void go_to(double time) {
    if (a_ && time == time_) return;
    a_.emplace(a_at_(time));
    b_.emplace(b_at_(time));
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
