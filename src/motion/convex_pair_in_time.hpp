#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "motion/convex_gap.hpp"
#include "motion/first_contact.hpp"

namespace toccata {

/// What a gap has to be more than, for shapes that are posed within the pad.
[[nodiscard]] inline double wanted_gap(double pad, double stop_before) {
  return pad * (1 + 0x1p-40) + (stop_before + 4 * unit_roundoff * std::fabs(stop_before));
}

/// Two convex sets of which it is told where they are at a time; looked for is when they come nearer than
/// `stop_before`, or, where that is negative, when they are deeper in each other.
template <PosedConvexSet A, PosedConvexSet B>
class ConvexPairInTime final : public MovingPair {
 public:
  ConvexPairInTime(FunctionRef<A(double)> a, FunctionRef<B(double)> b, double pad, double stop_before)
      : a_at_(a), b_at_(b), pad_(pad), stop_before_(stop_before) {}

  [[nodiscard]] Vec3 direction(double time) override {
    const Placing& at = placed(time);
    const Vec3 found = separating_direction(*at.a, *at.b, kept_);
    return found == Vec3{} && stop_before_ < 0 ? direction_of_depth(at.a->set, at.b->set) : found;
  }

  [[nodiscard]] double separation(double time, const Vec3& direction) override {
    const Placing& at = placed(time);
    return separation_along(*at.a, *at.b, direction) - wanted_gap(pad_, stop_before_);
  }

  /// What is left of a gap is compared with a length, which a shorter direction makes shorter, too; not so a depth.
  [[nodiscard]] bool may_turn() const override { return stop_before_ >= 0; }

  [[nodiscard]] bool surely_meet(double time) override {
    const Placing& at = placed(time);
    if (stop_before_ > 2 * pad_)
      return distance_of(at.a->set, at.b->set).upper <= (stop_before_ - pad_) * (1 - 0x1p-40);
    // Where a depth is asked for, the corners that are less far find a meeting sooner.
    if (stop_before_ < 0) return overlap_by(at.a->set, at.b->set, pad_ - stop_before_, octahedron_corners);
    return overlap_by(at.a->set, at.b->set, pad_, tetrahedron_corners);
  }

 private:
  struct Placing {
    double time = -1;
    std::optional<PlacedSet<A>> a;
    std::optional<PlacedSet<B>> b;
  };

  /// Looked at are a time that is reached and a later one that is tried: of the two that are kept, the later makes way
  /// for a time before it, and else the earlier.
  const Placing& placed(double time) {
    for (const Placing& known : placings_)
      if (known.time == time) return known;
    const bool first_is_later = placings_[0].time > placings_[1].time;
    Placing &earlier = placings_[first_is_later ? 1 : 0], &later = placings_[first_is_later ? 0 : 1];
    Placing& place = time < later.time ? later : earlier;
    place.a.emplace([&] { return a_at_(time); });
    place.b.emplace([&] { return b_at_(time); });
    place.time = time;
    return place;
  }

  FunctionRef<A(double)> a_at_;
  FunctionRef<B(double)> b_at_;
  double pad_;
  double stop_before_;
  std::array<Placing, 2> placings_;
  VertexPairs kept_;
};

}  // namespace toccata
