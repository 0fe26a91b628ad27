#include <cmath>
#include <optional>

#include "math/vec3_measures.hpp"
#include "narrow/smooth/distance/axial_box.hpp"
#include "narrow/smooth/distance/ellipsoid_pair.hpp"
#include "narrow/smooth/distance/quick_pair.hpp"
#include "narrow/smooth/distance/smooth_coherent.hpp"
#include "narrow/smooth/distance/smooth_nearest.hpp"
#include "narrow/smooth/distance/smooth_within.hpp"
#include "narrow/smooth/smooth_order.hpp"
#include "toccata/narrow/smooth.hpp"

namespace toccata {
namespace {

struct Pair {
  Pair(const PosedSmooth& first, const PosedSmooth& second)
      : frame(pair_frame(first, second)), a(first, frame), b(second, frame) {}
  Pair(const PosedSmooth& first, const PosedConvex& second)
      : frame(pair_frame(first, second)), a(first, frame), b(second, frame) {}

  PairFrame frame;
  SmoothBody a;
  SmoothBody b;
};

Status status_of(const SmoothNearest& found) {
  if (found.narrow) return Status::exact;
  // The size of the pair is about 1.
  return found.contact == SmoothContact::undecided && found.upper <= 1e-12 ? Status::undecided : Status::not_converged;
}

Distance in_world(const SmoothNearest& found, const PairFrame& frame) {
  Distance result;
  if (found.contact == SmoothContact::apart) {
    const double back = 1 / frame.factor;
    // A power of two, but what is multiplied by it may leave the range of normal numbers.
    result.lower = found.lower * back;
    result.upper = found.upper * back;
    if (result.lower < 0x1p-1000) result.lower = std::nextafter(result.lower, 0);
    if (result.upper < 0x1p-1000) result.upper = std::nextafter(result.upper, HUGE_VAL);
  } else {
    result.upper = found.upper / frame.factor;
  }
  result.on_a = frame.back(found.on_a);
  result.on_b = frame.back(found.on_b);
  result.status = status_of(found);
  return result;
}

/// Of pairs that have a way of their own.
std::optional<SmoothContact> closed_contact(const PosedSmooth& a, const PosedSmooth& b) {
  return ellipsoid_contact(a, b);
}
std::optional<SmoothContact> closed_contact(const PosedSmooth& a, const PosedConvex& b) {
  return axial_box_contact(a, b);
}

template <class B>
SmoothContact contact_of(const PosedSmooth& a, const B& b) {
  if (const auto found = closed_contact(a, b)) return *found;
  const PairFrame frame = pair_frame(a, b);
  if (is_quick(a, b, frame))
    if (const auto quick = QuickPair(a, b, frame).contact()) return *quick;
  const Pair pair(a, b);
  return nearest_of(a, pair.a, b, pair.b, SmoothQuestion::meeting).contact;
}

/// Of pairs that have a way of their own.
std::optional<QuickDistance> closed_distance(const PosedSmooth& a, const PosedSmooth& b, const Vec3& direction) {
  return ellipsoid_distance(a, b, direction);
}
std::optional<QuickDistance> closed_distance(const PosedSmooth& a, const PosedConvex& b, const Vec3&) {
  return axial_box_distance(a, b);
}

/// The search begins with this direction, and leaves there that of the nearest points, of any length; zero: none.
template <class B>
Distance distance_of(const PosedSmooth& a, const B& b, Vec3& direction) {
  if (const auto found = closed_distance(a, b, direction)) {
    direction = found->on_a - found->on_b;
    return {.lower = found->lower, .upper = found->upper, .on_a = found->on_a, .on_b = found->on_b};
  }
  const PairFrame frame = pair_frame(a, b);
  std::optional<QuickPair<B>> quick;
  if (is_quick(a, b, frame)) {
    quick.emplace(a, b, frame, direction);
    const auto found = quick->distance();
    direction = quick->guess() != nullptr ? quick->guess()->direction() : Vec3{};
    if (found) return {.lower = found->lower, .upper = found->upper, .on_a = found->on_a, .on_b = found->on_b};
  }
  const Pair pair(a, b);
  const QuickPolish* const guess = quick ? quick->guess() : nullptr;
  const SmoothNearest found = nearest_of(a, pair.a, b, pair.b, SmoothQuestion::distance, guess);
  if (found.shared) return {.on_a = found.shared->point, .on_b = found.shared->point};
  return in_world(found, frame);
}

template <class B>
Distance distance_of(const PosedSmooth& a, const B& b) {
  Vec3 none;
  return distance_of(a, b, none);
}

template <class B>
bool is_within_of(const PosedSmooth& a, const B& b, double tolerance) {
  if (tolerance == 0) return contact_of(a, b) != SmoothContact::apart;
  const PairFrame frame = pair_frame(a, b);
  if (is_quick(a, b, frame))
    if (const auto quick = QuickPair(a, b, frame).is_within(tolerance, frame.factor)) return *quick;
  return distance_of(a, b).lower <= tolerance;
}

}  // namespace

SmoothContact smooth_contact(const PosedSmooth& a, const PosedSmooth& b) {
  return comes_before(b, a) ? contact_of(b, a) : contact_of(a, b);
}
SmoothContact smooth_contact(const PosedSmooth& a, const PosedConvex& b) { return contact_of(a, b); }
SmoothContact smooth_contact(const PosedConvex& a, const PosedSmooth& b) { return contact_of(b, a); }

bool overlap(const PosedSmooth& a, const PosedSmooth& b) { return smooth_contact(a, b) != SmoothContact::apart; }
bool overlap(const PosedSmooth& a, const PosedConvex& b) { return smooth_contact(a, b) != SmoothContact::apart; }
bool overlap(const PosedConvex& a, const PosedSmooth& b) { return overlap(b, a); }

Distance coherent_distance(const PosedSmooth& a, const PosedSmooth& b, Vec3& direction) {
  const bool turned = comes_before(b, a);
  Vec3 between = turned ? -direction : direction;
  const Distance found = turned ? flipped(distance_of(b, a, between)) : distance_of(a, b, between);
  direction = unit_or_zero(turned ? -between : between);
  return found;
}
Distance coherent_distance(const PosedSmooth& a, const PosedConvex& b, Vec3& direction) {
  const Distance found = distance_of(a, b, direction);
  direction = unit_or_zero(direction);
  return found;
}

bool is_within(const PosedSmooth& a, const PosedSmooth& b, double tolerance) {
  return comes_before(b, a) ? is_within_of(b, a, tolerance) : is_within_of(a, b, tolerance);
}
bool is_within(const PosedSmooth& a, const PosedConvex& b, double tolerance) { return is_within_of(a, b, tolerance); }
bool is_within(const PosedSmooth& a, const PosedHalfSpace& b, double tolerance) {
  return tolerance == 0 ? overlap(a, b) : distance(a, b).lower <= tolerance;
}

Distance distance(const PosedSmooth& a, const PosedSmooth& b) {
  return comes_before(b, a) ? flipped(distance_of(b, a)) : distance_of(a, b);
}
Distance distance(const PosedSmooth& a, const PosedConvex& b) { return distance_of(a, b); }
Distance distance(const PosedConvex& a, const PosedSmooth& b) { return flipped(distance_of(b, a)); }

}  // namespace toccata
