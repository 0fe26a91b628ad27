#include "narrow/quadrics/casts/quadric_advance.hpp"

#include <array>
#include <cmath>

#include "math/vec3_measures.hpp"
#include "narrow/quadrics/distance/fast_refinement.hpp"

namespace toccata {
namespace {

constexpr int most_advance_steps = 24;
/// A step that gains less, of the whole way, is the last one.
constexpr double least_gain = 0x1p-46;

BodyPoint body_point(const FastSide& side) {
  BodyPoint point;
  for (std::size_t i = 0; i < side.size; ++i) point.append(side.generator[i], {side.weight[i], 0});
  for (std::size_t j = 0; j < 3; ++j) point.round[j] = {side.round[static_cast<int>(j)], 0};
  return point;
}

/// What is nearest, as far as is seen, and the direction from B to A there.
class NearestSeen {
 public:
  explicit NearestSeen(const Vec3& direction) : direction_(direction) {}

  /// Newton's method from what was nearest before; false where that leads nowhere.
  bool follow(const PlainBody& a, const PlainBody& b) {
    if (corners_ == 0) return false;
    FastRefinement refinement(a, b);
    refinement.begin({corner_.data(), corners_}, direction_);
    if (!refinement.run()) return false;
    keep(refinement);
    return true;
  }

  /// Searches from anew; false where nothing parts them.
  bool search(const PlainBody& a, const PlainBody& b) {
    QuadricSearch search(a, b, direction_);
    FastRefinement refinement(a, b);
    corners_ = 0;
    on_a_ = on_b_ = {};
    for (const double part : {0.3, 1e-2}) {
      search.run(part);
      if (search.inside()) return false;
      refinement.begin(search.simplex(), search.nearest());
      if (refinement.run()) {
        keep(refinement);
        return true;
      }
      if (search.stalled()) break;
    }
    direction_ = search.best_direction();
    return search.best_gap() > 0;
  }

  [[nodiscard]] const Vec3& direction() const { return direction_; }
  [[nodiscard]] const BodyPoint& on_a() const { return on_a_; }
  [[nodiscard]] const BodyPoint& on_b() const { return on_b_; }

 private:
  /// The points of both sides in pairs that share their weights.
  void keep(const FastRefinement& refinement) {
    direction_ = refinement.direction();
    const FastSide &a = refinement.on_a(), &b = refinement.on_b();
    on_a_ = body_point(a);
    on_b_ = body_point(b);
    std::array<double, 3> of_a = a.weight, of_b = b.weight;
    corners_ = 0;
    for (std::size_t i = 0, j = 0; i < a.size && j < b.size;) {
      const double weight = std::fmin(of_a[i], of_b[j]);
      corner_[corners_++] = {{a.generator[i], a.round, {}}, {b.generator[j], b.round, {}}, weight};
      of_a[i] -= weight;
      of_b[j] -= weight;
      (of_a[i] <= of_b[j] ? i : j) += 1;
    }
  }

  std::array<QuadricSearch::Corner, 6> corner_;
  std::size_t corners_ = 0;
  BodyPoint on_a_;
  BodyPoint on_b_;
  Vec3 direction_;
};

/// Does the plane across `d` keep them apart, and until when? They are free until a time as it is.
QuadricAdvance parted_by(const Vec3& d, const PlainBody& a, const Vec3& motion, const PlainBody& b, double free_until) {
  const double of_a = a.height_at_most(-d), of_b = b.height_at_most(d);
  const double gap = -(of_a + of_b) - 0x1p-50 * (std::fabs(of_a) + std::fabs(of_b));
  // It comes nearer by no more than this in the whole time.
  const double approach = 0x1p-50 * dot(magnitudes(d), magnitudes(motion)) - dot(d, motion) + 0x1p-1000;
  if (approach <= 0) return {free_until, gap - free_until * approach * (1 - 0x1p-50) > 0, d, {}, {}};
  return {gap > 0 ? (1 - 0x1p-50) * (gap / approach) : 0, false, d, {}, {}};
}

/// By conservative advancement (B. Mirtich, "Impulse-based dynamic simulation of rigid body systems", 1996).
class Advance {
 public:
  Advance(const PlainBody& a, const Vec3& motion, const PlainBody& b)
      : a_(a), motion_(motion), b_(b), nearest_(a.middle() - b.middle()) {}

  QuadricAdvance until(double limit) {
    const QuadricAdvance beside = passes_beside();
    if (beside.for_ever || beside.free_until > 1) return beside;
    for (int step = 0; step < most_advance_steps; ++step) {
      const double before = best_.free_until;
      const PlainBody moved = a_.moved(before * motion_);
      // What is followed is a guess that may gain nothing.
      const bool gained = (nearest_.follow(moved, b_) && gains()) || (nearest_.search(moved, b_) && gains());
      if (!gained || best_.for_ever) break;
      if (best_.free_until > limit || best_.free_until - before < least_gain) break;
    }
    best_.on_a = nearest_.on_a();
    best_.on_b = nearest_.on_b();
    return best_;
  }

 private:
  /// The plane along the motion, across the way from the middle of B to the line on which that of A moves.
  [[nodiscard]] QuadricAdvance passes_beside() const {
    const Vec3 between = a_.middle() - b_.middle(), along = unit_or_zero(motion_);
    const Vec3 d = unit_or_zero(between - dot(between, along) * along);
    return parted_by((1 - 0x1p-50) * d, a_, motion_, b_, 0);
  }

  bool gains() {
    const Vec3& d = nearest_.direction();
    if (!is_finite(d)) return false;
    const QuadricAdvance next = parted_by(d, a_, motion_, b_, best_.free_until);
    // Asked so that NaN is no gain.
    if (!next.for_ever && !(next.free_until > best_.free_until)) return false;
    best_ = next;
    return true;
  }

  const PlainBody& a_;
  Vec3 motion_;
  const PlainBody& b_;
  NearestSeen nearest_;
  QuadricAdvance best_;
};

}  // namespace

QuadricAdvance advance_in_doubles(const PlainBody& a, const Vec3& motion, const PlainBody& b, double limit) {
  return Advance(a, motion, b).until(limit);
}

}  // namespace toccata
