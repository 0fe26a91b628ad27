#include <cmath>
#include <optional>

#include "math/vec3_measures.hpp"
#include "narrow/near.hpp"
#include "narrow/quadrics/distance/axial_box.hpp"
#include "narrow/quadrics/distance/ellipsoid_pair.hpp"
#include "narrow/quadrics/distance/fast_pair.hpp"
#include "narrow/quadrics/distance/quadric_coherent.hpp"
#include "narrow/quadrics/distance/quadric_nearest.hpp"
#include "narrow/quadrics/quadric_order.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {
namespace {

struct Pair {
  Pair(const PosedQuadric& first, const PosedQuadric& second)
      : frame(pair_frame(first, second)), a(first, frame), b(second, frame) {}
  Pair(const PosedQuadric& first, const PosedPolytope& second)
      : frame(pair_frame(first, second)), a(first, frame), b(second, frame) {}

  PairFrame frame;
  QuadricBody a;
  QuadricBody b;
};

Status status_of(const QuadricNearest& found) {
  if (found.narrow) return Status::exact;
  // The size of the pair is about 1.
  return found.contact == QuadricContact::undecided && found.upper <= 1e-12 ? Status::undecided : Status::not_converged;
}

Distance in_world(const QuadricNearest& found, const PairFrame& frame) {
  Distance result;
  if (found.contact == QuadricContact::apart) {
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
QuadricContact contact_of(const PosedQuadric& a, const B& b) {
  if (const auto found = fast_contact(a, b)) return *found;
  const Pair pair(a, b);
  return nearest_of(a, pair.a, b, pair.b, QuadricQuestion::meeting).contact;
}

/// The distance of pairs that have a way of their own.
std::optional<FastDistance> closed_distance(const PosedQuadric& a, const PosedQuadric& b, const Vec3& direction) {
  return ellipsoid_distance(a, b, direction);
}
std::optional<FastDistance> closed_distance(const PosedQuadric& a, const PosedPolytope& b, const Vec3&) {
  return axial_box_distance(a, b);
}

/// The search begins with this direction, and leaves there that of the nearest points, of any length; zero: none.
template <class B>
Distance distance_of(const PosedQuadric& a, const B& b, Vec3& direction) {
  if (const auto found = closed_distance(a, b, direction)) {
    direction = found->on_a - found->on_b;
    return {.lower = found->lower, .upper = found->upper, .on_a = found->on_a, .on_b = found->on_b};
  }
  const PairFrame frame = pair_frame(a, b);
  std::optional<FastPair<B>> quick;
  if (is_fast(a, b, frame)) {
    quick.emplace(a, b, frame, direction);
    const auto found = quick->distance();
    direction = quick->guess() != nullptr ? quick->guess()->direction() : Vec3{};
    if (found) return {.lower = found->lower, .upper = found->upper, .on_a = found->on_a, .on_b = found->on_b};
    if (const auto common = quick->common_point()) {
      const Vec3 at = frame.back(*common);
      return {.on_a = at, .on_b = at};
    }
  }
  const Pair pair(a, b);
  const FastRefinement* const guess = quick ? quick->guess() : nullptr;
  const QuadricNearest found = nearest_of(a, pair.a, b, pair.b, QuadricQuestion::distance, guess);
  if (found.shared) return {.on_a = found.shared->point, .on_b = found.shared->point};
  return in_world(found, frame);
}

template <class B>
Distance distance_of(const PosedQuadric& a, const B& b) {
  Vec3 none;
  return distance_of(a, b, none);
}

/// False is proved. It is told as soon as a plane or two points show it.
template <class B>
bool is_within(const PosedQuadric& a, const B& b, double length) {
  if (length == 0) return contact_of(a, b) != QuadricContact::apart;
  const PairFrame frame = pair_frame(a, b);
  if (is_fast(a, b, frame))
    if (const auto quick = FastPair(a, b, frame).is_within(length, frame.factor)) return *quick;
  return distance_of(a, b).lower <= length;
}

template <class B>
std::optional<Nearby> nearby_of(const PosedQuadric& a, const B& b, const WantedDistance& wanted) {
  return nearby_by(
      wanted, Quicker::comparison, [&](double length) { return is_within(a, b, length); },
      [&] { return distance_of(a, b); });
}

}  // namespace

QuadricContact quadric_contact(const PosedQuadric& a, const PosedQuadric& b) {
  return comes_before(b, a) ? contact_of(b, a) : contact_of(a, b);
}
QuadricContact quadric_contact(const PosedQuadric& a, const PosedPolytope& b) { return contact_of(a, b); }
QuadricContact quadric_contact(const PosedPolytope& a, const PosedQuadric& b) { return contact_of(b, a); }

bool overlap(const PosedQuadric& a, const PosedQuadric& b) { return quadric_contact(a, b) != QuadricContact::apart; }
bool overlap(const PosedQuadric& a, const PosedPolytope& b) { return quadric_contact(a, b) != QuadricContact::apart; }
bool overlap(const PosedPolytope& a, const PosedQuadric& b) { return overlap(b, a); }

Distance coherent_distance(const PosedQuadric& a, const PosedQuadric& b, Vec3& direction) {
  const bool turned = comes_before(b, a);
  Vec3 between = turned ? -direction : direction;
  const Distance found = turned ? flipped(distance_of(b, a, between)) : distance_of(a, b, between);
  direction = unit_or_zero(turned ? -between : between);
  return found;
}
Distance coherent_distance(const PosedQuadric& a, const PosedPolytope& b, Vec3& direction) {
  const Distance found = distance_of(a, b, direction);
  direction = unit_or_zero(direction);
  return found;
}

std::optional<Nearby> nearby(const PosedQuadric& a, const PosedQuadric& b, const WantedDistance& wanted) {
  return comes_before(b, a) ? flipped(nearby_of(b, a, wanted)) : nearby_of(a, b, wanted);
}
std::optional<Nearby> nearby(const PosedQuadric& a, const PosedPolytope& b, const WantedDistance& wanted) {
  return nearby_of(a, b, wanted);
}
std::optional<Nearby> nearby(const PosedQuadric& a, const PosedHalfSpace& b, const WantedDistance& wanted) {
  return nearby_by(
      wanted, Quicker::distance,
      [&](double length) { return length == 0 ? overlap(a, b) : distance(a, b).lower <= length; },
      [&] { return distance(a, b); });
}

Distance distance(const PosedQuadric& a, const PosedQuadric& b) {
  return comes_before(b, a) ? flipped(distance_of(b, a)) : distance_of(a, b);
}
Distance distance(const PosedQuadric& a, const PosedPolytope& b) { return distance_of(a, b); }
Distance distance(const PosedPolytope& a, const PosedQuadric& b) { return flipped(distance_of(b, a)); }

}  // namespace toccata
