#include <algorithm>
#include <cmath>
#include <optional>

#include "math/vec3_measures.hpp"
#include "narrow/smooth/distance/common_point.hpp"
#include "narrow/smooth/distance/quick_proof.hpp"
#include "narrow/smooth/distance/smooth_coherent.hpp"
#include "narrow/smooth/distance/smooth_nearest.hpp"
#include "narrow/smooth/distance/smooth_within.hpp"
#include "narrow/smooth/smooth_order.hpp"
#include "toccata/narrow/smooth.hpp"

namespace toccata {
namespace {

/// The search ends early: what it leaves, Newton's method gains faster, and where that fails it goes on.
constexpr double quick_parts[] = {0.7, 0.1, 1e-2, 1e-3};

/// What gaps in a pair's frame may be off by, with u = 2⁻⁵³. All coordinates of centres and columns are at most 2
/// there, and off by 6 u and 2 u. So the height of an atom is off by 21 u for its centre and 37 u for its growth, and
/// the gap of two support points differs from what their heights leave by 100 u: 216 u in all.
constexpr double gap_rounding = 0x1p-44;

/// In a pair's frame: the intervals of greater distances are narrow.
constexpr double hair = 0x1p-29;

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

bool is_moderate(double x) { return x > 0x1p-300 && x < 0x1p300; }
bool is_quick(const PosedSmooth& shape) {
  return is_moderate(shape.half().x) && is_moderate(shape.half().y) && is_moderate(shape.half().z);
}
bool is_quick(const PosedConvex& shape) { return shape.radius() == 0 || is_moderate(shape.radius()); }

template <class B>
bool is_quick(const PosedSmooth& a, const B& b, const PairFrame& frame) {
  return is_moderate(frame.factor) && is_quick(a) && is_quick(b);
}

/// One question about a pair, in doubles: what it answers is proved, and what it does not answer is left to
/// `nearest_of`.
template <class B>
class QuickPair {
 public:
  QuickPair(const PosedSmooth& a, const B& b, const PairFrame& frame, const Vec3& first_direction = {})
      : a_(a),
        b_(b),
        body_a_(a, frame),
        body_b_(b, frame),
        search_(body_a_, body_b_, first_direction == Vec3{} ? body_a_.middle() - body_b_.middle() : first_direction),
        polish_(body_a_, body_b_) {}

  /// Most pairs that are apart.
  std::optional<QuickDistance> distance() {
    for (const double part : quick_parts) {
      search_.run(part);
      if (search_.inside()) return {};
      begin_polish();
      if (polish_.run()) {
        is_guess_ = true;
        const auto found = proved_distance(a_, b_, polish_);
        return found || !polish_.refine() ? found : proved_distance(a_, b_, polish_);
      }
      if (search_.stalled()) return {};
    }
    return {};
  }

  /// What `distance` did not prove, if it ended where the conditions of the nearest points hold.
  [[nodiscard]] const QuickPolish* guess() const { return is_guess_ ? &polish_ : nullptr; }

  bool is_apart() {
    search_.run_until_apart();
    if (search_.best_gap() > gap_rounding) return true;
    return search_.best_gap() > 0 && lower_along(search_.best_direction()) > 0;
  }

  /// `factor` is that of the pair's frame.
  std::optional<bool> is_within(double tolerance, double factor) {
    search_.run_until_compared(factor * tolerance);
    // By so much more that the tolerance lies below the interval of the distance too, which is wider for hairs only.
    const double length = (1 + 0x1p-38) * plain_length(search_.best_direction());
    if (search_.best_gap() > length * (factor * tolerance) + hair) return false;
    begin_polish();
    if (proved_interval(a_, b_, polish_.on_a(), polish_.on_b(), polish_.direction()).upper <= tolerance) return true;
    return {};
  }

 private:
  void begin_polish() {
    std::array<SmoothSearch::Corner, 4> corner;
    const std::size_t count = search_.corners(corner);
    polish_.begin({corner.data(), count}, search_.nearest());
  }

  /// From the farthest points along the direction from B to A.
  double lower_along(const Vec3& direction) {
    const std::array<SmoothSearch::Corner, 1> corner{
        SmoothSearch::Corner{body_a_.support(-direction), body_b_.support(direction), 1}};
    polish_.begin(corner, direction);
    return proved_interval(a_, b_, polish_.on_a(), polish_.on_b(), direction).lower;
  }

  const PosedSmooth& a_;
  const B& b_;
  PlainBody body_a_;
  PlainBody body_b_;
  SmoothSearch search_;
  QuickPolish polish_;
  bool is_guess_ = false;
};

template <class B>
SmoothContact contact_of(const PosedSmooth& a, const B& b) {
  const PairFrame frame = pair_frame(a, b);
  if (is_quick(a, b, frame) && QuickPair(a, b, frame).is_apart()) return SmoothContact::apart;
  const Pair pair(a, b);
  const SmoothContact found = nearest_of(a, pair.a, b, pair.b, SmoothQuestion::meeting).contact;
  if (found != SmoothContact::undecided) return found;
  const SmoothNearest nearest = nearest_of(a, pair.a, b, pair.b, SmoothQuestion::distance);
  return common_point(a, b, nearest, frame) ? SmoothContact::contact : found;
}

/// The search begins with this direction, and leaves there that of the nearest points; zero: none.
template <class B>
Distance distance_of(const PosedSmooth& a, const B& b, Vec3& direction) {
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
  if (found.contact == SmoothContact::undecided)
    if (const auto point = common_point(a, b, found, frame)) return {.on_a = *point, .on_b = *point};
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
  if (!comes_before(b, a)) return distance_of(a, b, direction);
  direction = -direction;
  const Distance found = exchanged(distance_of(b, a, direction));
  direction = -direction;
  return found;
}
Distance coherent_distance(const PosedSmooth& a, const PosedConvex& b, Vec3& direction) {
  return distance_of(a, b, direction);
}

bool is_within(const PosedSmooth& a, const PosedSmooth& b, double tolerance) {
  return comes_before(b, a) ? is_within_of(b, a, tolerance) : is_within_of(a, b, tolerance);
}
bool is_within(const PosedSmooth& a, const PosedConvex& b, double tolerance) { return is_within_of(a, b, tolerance); }
bool is_within(const PosedSmooth& a, const PosedHalfSpace& b, double tolerance) {
  return tolerance == 0 ? overlap(a, b) : distance(a, b).lower <= tolerance;
}

Distance distance(const PosedSmooth& a, const PosedSmooth& b) {
  return comes_before(b, a) ? exchanged(distance_of(b, a)) : distance_of(a, b);
}
Distance distance(const PosedSmooth& a, const PosedConvex& b) { return distance_of(a, b); }
Distance distance(const PosedConvex& a, const PosedSmooth& b) { return exchanged(distance_of(b, a)); }

}  // namespace toccata
