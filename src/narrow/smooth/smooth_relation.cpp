#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "math/vec3_measures.hpp"

#include "narrow/smooth/smooth_containment.hpp"
#include "narrow/smooth/smooth_expansion.hpp"
#include "narrow/smooth/smooth_nearest.hpp"
#include "narrow/smooth/smooth_order.hpp"
#include "narrow/smooth/smooth_parting.hpp"
#include "toccata/core/error.hpp"
#include "toccata/math/trigonometry.hpp"
#include "toccata/narrow/smooth_penetration.hpp"

namespace toccata {
namespace {

constexpr std::size_t most_corners = 96;

/// Two bodies that certainly have a common inner point.
class DeepPair {
 public:
  DeepPair(const SmoothBody& a, const SmoothBody& b) : a_(a), b_(b), polish_(a, b) {}

  /// In the pair's frame.
  Penetration answer(const SmoothNearest& met) {
    if (met.is_around)
      expand(met.around);
    else
      expand_from_search();
    try_direction(unit_or(Vec3{}, a_.middle_point(), b_.middle_point()));
    for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
      try_direction(axis);
      try_direction(-axis);
    }
    for (const SmoothBody* body : {&a_, &b_})
      if (body->smooth_kind())
        for (const BoundedVector& axis : body->axes()) {
          try_direction(plain(axis));
          try_direction(-plain(axis));
        }
    try_spiral();
    result_.status = result_.upper - result_.lower <= 1e-12 * result_.upper ? Status::exact : Status::not_converged;
    return result_;
  }

 private:
  static Vec3 unit_or(const Vec3& other, const BoundedVector& p, const BoundedVector& q) {
    const Vec3 between = plain(q) - plain(p);
    return between == Vec3{} ? other : between;
  }

  void expand_from_search() {
    for (const Vec3& direction : {Vec3{0.36, 0.48, 0.8}, Vec3{-0.6, 0.7, -0.3}, Vec3{0.5, -0.2, -0.84}}) {
      SmoothSearch search(a_, b_, direction);
      search.run(0);
      std::array<SmoothSearch::Corner, 4> corner;
      if (search.corners(corner) == 4 && search.inside()) return expand(corner);
    }
  }

  void expand(const std::array<SmoothSearch::Corner, 4>& four) {
    SmoothExpansion expansion(a_, b_, four);
    expansion.grow(1e-6, most_corners);
    result_.lower = expansion.proved_depth();
    const SmoothExpansion::Facet facet = expansion.nearest();
    std::array<SmoothSearch::Corner, 3> corner;
    for (std::size_t i = 0; i < 3; ++i)
      corner[i] = {expansion.corner(facet.corner[i]).a, expansion.corner(facet.corner[i]).b, 1.0 / 3};
    take(fine(facet.normal));
    polish(corner, -facet.normal);
  }

  /// Direction from A to B: that along which B has to leave.
  void try_direction(const Vec3& along, double promising = 1.5) {
    if (along == Vec3{}) return;
    const SmoothSupport of_a = a_.support(along), of_b = b_.support(-along);
    const double height = dot(along, of_a.point - of_b.point) / std::sqrt(dot(along, along));
    if (!(height < promising * result_.upper)) return;
    take(fine(along));
    const std::array<SmoothSearch::Corner, 1> corner{SmoothSearch::Corner{of_a, of_b, 1}};
    polish(corner, -along);
  }

  void polish(std::span<const SmoothSearch::Corner> corners, const Vec3& direction) {
    polish_.begin(corners, direction, SmoothPolish::Attempt::first);
    if (!polish_.settle()) return;
    FineDirection d = polish_.direction();
    for (DoubleWord& x : d) x = -x;
    take(d);
  }

  /// Along the direction they are apart after the height of A − B; that of the direction as it is told.
  void take(const FineDirection& along) {
    const Vec3 d = unit_or_zero({along[0].high, along[1].high, along[2].high});
    const double height = -gap_along<BoundedNumber>(a_, b_, fine(-d));
    if (!(height < result_.upper)) return;
    result_.upper = height;
    result_.direction = d;
    result_.on_a = a_.support(d).point;
    result_.on_b = b_.support(-d).point;
  }

  /// From the best of directions all over the sphere (on a spiral of the golden angle).
  void try_spiral() {
    constexpr int count = 128;
    std::array<std::pair<double, Vec3>, count> found;
    for (int i = 0; i < count; ++i) {
      const double z = 1 - (2 * i + 1.0) / count, across = std::sqrt(1 - z * z);
      const SineCosine turn = sine_cosine_of_turns(0.3819660112501051 * i);
      const Vec3 d{across * turn.cosine, across * turn.sine, z};
      found[static_cast<std::size_t>(i)] = {dot(d, a_.support(d).point - b_.support(-d).point), d};
    }
    constexpr std::size_t tried = 6;
    std::partial_sort(found.begin(), found.begin() + tried, found.end(),
                      [](const auto& f, const auto& g) { return f.first < g.first; });
    for (std::size_t i = 0; i < tried; ++i) try_direction(found[i].second, HUGE_VAL);
  }

  const SmoothBody& a_;
  const SmoothBody& b_;
  SmoothPolish polish_;
  Penetration result_{.upper = HUGE_VAL};
};

Penetration penetration_of(const SmoothBody& a, const SmoothBody& b, const PairFrame& frame) {
  const SmoothNearest near = nearest_of(a, b, SmoothQuestion::distance);
  Penetration result;
  if (near.contact == SmoothContact::apart) return result;
  if (near.contact == SmoothContact::undecided) {
    result.status = Status::undecided;
    return result;
  }
  result = DeepPair(a, b).answer(near);
  // The direction is rounded: a little farther it certainly serves.
  result.upper = std::nextafter(result.upper * (1 + 0x1p-50) / frame.factor, HUGE_VAL);
  result.lower = std::nextafter(result.lower / frame.factor, 0);
  result.on_a = frame.back(result.on_a);
  result.on_b = frame.back(result.on_b);
  return result;
}

/// Of two that overlap: a containment that is proved, or that none is known to be.
Relation with_containment(Relation relation, Within a_in_b, Within b_in_a) {
  if (a_in_b == Within::yes || b_in_a == Within::yes) {
    relation.containment = a_in_b == b_in_a        ? Containment::equal
                           : a_in_b == Within::yes ? Containment::a_in_b
                                                   : Containment::b_in_a;
    return relation;
  }
  if (a_in_b == Within::undecided || b_in_a == Within::undecided)
    relation.status = Status::undecided;
  else if (a_in_b == Within::unfinished || b_in_a == Within::unfinished)
    relation.status = Status::not_converged;
  return relation;
}

bool may_hold(const Relation& found) {
  return found.kind == RelationKind::overlapping || found.kind == RelationKind::crossing;
}

Relation relation_of(const SmoothBody& a, const SmoothBody& b, bool b_solid) {
  Relation result;
  result.a_solid = true;
  result.b_solid = b_solid;
  const SmoothContact contact = nearest_of(a, b, SmoothQuestion::meeting).contact;
  if (contact == SmoothContact::apart) return result;
  if (contact == SmoothContact::undecided) {
    result.kind = RelationKind::touching;
    result.status = Status::undecided;
    return result;
  }
  result.kind = b_solid ? RelationKind::overlapping : RelationKind::crossing;
  return result;
}

}  // namespace

Penetration least_depth(const SmoothBody& a, const SmoothBody& b, const SmoothNearest& met) {
  return DeepPair(a, b).answer(met);
}

Relation relation(const PosedSmooth& a, const PosedSmooth& b) {
  if (comes_before(b, a)) return exchanged(relation(b, a));
  const PairFrame frame = pair_frame(a, b);
  const SmoothBody body_a(a, frame), body_b(b, frame);
  const Relation found = relation_of(body_a, body_b, true);
  if (!may_hold(found)) return found;
  if (a == b) return with_containment(found, Within::yes, Within::yes);
  return with_containment(found, is_held_by_smooth(body_a, body_b), is_held_by_smooth(body_b, body_a));
}

Relation relation(const PosedSmooth& a, const PosedConvex& b) {
  const PairFrame frame = pair_frame(a, b);
  const SmoothBody body_a(a, frame), body_b(b, frame);
  const Relation found = relation_of(body_a, body_b, b.solid());
  if (!may_hold(found)) return found;
  const Within b_in_a = is_held_by_smooth(b, body_b, a, body_a);
  const bool is_all = b_in_a == Within::yes || !b.solid();
  return with_containment(found, is_all ? Within::no : is_held_by_convex(body_a, b, body_b, frame), b_in_a);
}

Relation relation(const PosedConvex& a, const PosedSmooth& b) { return exchanged(relation(b, a)); }

Penetration penetration(const PosedSmooth& a, const PosedSmooth& b) {
  if (comes_before(b, a)) return exchanged(penetration(b, a));
  const PairFrame frame = pair_frame(a, b);
  return penetration_of(SmoothBody(a, frame), SmoothBody(b, frame), frame);
}

Penetration penetration(const PosedSmooth& a, const PosedConvex& b) {
  if (!b.solid())
    throw Error("penetration: the second shape is a surface, which has no interior to leave; ask for the distance");
  const PairFrame frame = pair_frame(a, b);
  return penetration_of(SmoothBody(a, frame), SmoothBody(b, frame), frame);
}

Penetration penetration(const PosedConvex& a, const PosedSmooth& b) {
  if (!a.solid())
    throw Error("penetration: the first shape is a surface, which has no interior to leave; ask for the distance");
  return exchanged(penetration(b, a));
}

}  // namespace toccata
