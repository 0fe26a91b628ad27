#include <algorithm>
#include <cmath>
#include <optional>

#include "narrow/smooth/quick_proof.hpp"
#include "narrow/smooth/smooth_nearest.hpp"
#include "narrow/smooth/smooth_order.hpp"
#include "toccata/narrow/smooth.hpp"

namespace toccata {
namespace {

/// The search ends early: what it leaves, Newton's method gains faster, and where that fails it goes on.
constexpr double quick_parts[] = {0.7, 0.1, 1e-2, 1e-3};

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

template <class B>
SmoothContact contact_of(const PosedSmooth& a, const B& b) {
  const Pair pair(a, b);
  return nearest_of(pair.a, pair.b, SmoothQuestion::meeting).contact;
}

bool is_moderate(double x) { return x > 0x1p-300 && x < 0x1p300; }
bool is_quick(const PosedSmooth& shape) {
  return is_moderate(shape.half().x) && is_moderate(shape.half().y) && is_moderate(shape.half().z);
}
bool is_quick(const PosedConvex& shape) {
  return shape.in_world() && (shape.radius() == 0 || is_moderate(shape.radius()));
}

/// In doubles, where that does: most pairs that are apart.
template <class B>
std::optional<Distance> quick_distance(const PosedSmooth& a, const B& b, const PairFrame& frame) {
  if (!is_moderate(frame.factor) || !is_quick(a) || !is_quick(b)) return {};
  const PlainBody body_a(a, frame), body_b(b, frame);
  SmoothSearch search(body_a, body_b, body_a.middle() - body_b.middle());
  QuickPolish polish(body_a, body_b);
  for (const double part : quick_parts) {
    search.run(part);
    if (search.inside()) return {};
    std::array<SmoothSearch::Corner, 4> corner;
    const std::size_t count = search.corners(corner);
    if (!polish.run({corner.data(), count}, search.nearest())) {
      if (search.stalled()) return {};
      continue;
    }
    const auto found = proved_distance(a, b, polish);
    if (!found) return {};
    return Distance{.lower = found->lower, .upper = found->upper, .on_a = found->on_a, .on_b = found->on_b};
  }
  return {};
}

template <class B>
Distance distance_of(const PosedSmooth& a, const B& b) {
  if (const auto quick = quick_distance(a, b, pair_frame(a, b))) return *quick;
  const Pair pair(a, b);
  return in_world(nearest_of(pair.a, pair.b, SmoothQuestion::distance), pair.frame);
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

Distance distance(const PosedSmooth& a, const PosedSmooth& b) {
  return comes_before(b, a) ? exchanged(distance_of(b, a)) : distance_of(a, b);
}
Distance distance(const PosedSmooth& a, const PosedConvex& b) { return distance_of(a, b); }
Distance distance(const PosedConvex& a, const PosedSmooth& b) { return exchanged(distance_of(b, a)); }

}  // namespace toccata
