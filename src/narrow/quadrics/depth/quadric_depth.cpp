#include <array>
#include <cmath>
#include <optional>

#include "math/vec3_measures.hpp"
#include "narrow/quadrics/contact/quadric_separation.hpp"
#include "narrow/quadrics/depth/lowest_place.hpp"
#include "narrow/quadrics/depth/quadric_expansion.hpp"
#include "narrow/quadrics/distance/fast_pair.hpp"
#include "narrow/quadrics/distance/newton_refinement.hpp"
#include "narrow/quadrics/distance/quadric_nearest.hpp"
#include "narrow/quadrics/quadric_order.hpp"
#include "toccata/core/error.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {
namespace {

/// What the depth's interval is asked to be as narrow as, in turn, until one is reached: where the shapes are nearly as
/// deep in many directions (balls around one centre, round bars along one axis), it would take corners without end.
constexpr std::array<double, 5> parts{0x1p-43, 1e-5, 1e-3, 1e-2, 0.05};

/// What a height of bodies of size 1 may change by where its direction is rounded.
constexpr double rounding_of_direction = 0x1p-50;

/// Two bodies, in the pair's frame.
class DeepPair {
 public:
  DeepPair(const QuadricBody& a, const QuadricBody& b) : a_(a), b_(b), expansion_(a, b) {}

  /// Looks for one place that is the lowest. Where that is proved, as narrowly as a direction of doubles tells, all is
  /// found and the bodies meet.
  bool find_lowest_place() {
    lowest_ = lowest_place(a_, b_);
    if (!lowest_) return false;
    result_.lower = lowest_->lower;
    take(fine(lowest_->axis));
    if (result_.upper - result_.lower <= 1e-12 * result_.upper + rounding_of_direction) return true;
    lowest_.reset();
    return false;
  }

  /// The search begins: where it is proved that the origin lies deep within A − B, they are known to meet.
  bool certainly_meet() {
    if (!lowest_ && attempts_ == 0) found_ = attempt();
    return result_.lower > 0;
  }

  /// The least depth of bodies that have a common inner point.
  Penetration answer() {
    while (!lowest_ && !found_ && attempts_ < 2 * parts.size()) found_ = attempt();
    if (!lowest_) {
      take(fine(expansion_.direction()));
      refinement();
    }
    result_.status = result_.upper - result_.lower <= 1e-12 * result_.upper ? Status::exact : Status::not_converged;
    return result_;
  }

 private:
  using Precision = QuadricExpansion::Precision;

  bool attempt() {
    const double part = parts[attempts_ % parts.size()];
    const bool reached = expansion_.run(part, attempts_ < parts.size() ? Precision::plain : Precision::fine);
    ++attempts_;
    result_.lower = std::fmax(result_.lower, expansion_.proved_depth());
    return reached && result_.lower >= expansion_.upper() * (1 - 2 * part);
  }

  /// Newton's method from the best direction, which makes the upper end as good as numbers are.
  void refinement() {
    if (result_.upper - result_.lower <= 1e-12 * result_.upper) return;
    const Vec3 d = result_.direction;
    const std::array<QuadricSearch::Corner, 1> corner{QuadricSearch::Corner{a_.support(d), b_.support(-d), 1}};
    NewtonRefinement refinement(a_, b_);
    refinement.begin(corner, -d, NewtonRefinement::Attempt::first);
    if (!refinement.settle()) return;
    FineDirection along = refinement.direction();
    for (DoubleWord& x : along) x = -x;
    take(along);
  }

  /// Along the direction they are apart after the height of A − B; that of the direction as it is told.
  void take(const FineDirection& along) {
    Vec3 d = unit_or_zero({along[0].high, along[1].high, along[2].high});
    // What is far below the rounding of a unit vector is none of an axis.
    for (int i = 0; i < 3; ++i)
      if (std::fabs(d[i]) < 0x1p-60) d[i] = 0;
    const bool do_doubles_tell = !lowest_ || lowest_->lower > shallow_height;
    double height = do_doubles_tell ? -gap_along<BoundedDouble>(a_, b_, fine(-d)) : HUGE_VAL;
    if (!do_doubles_tell || !(height - result_.lower <= 0.5e-12 * height))
      height = -gap_along<BoundedNumber>(a_, b_, fine(-d));
    if (!(height < result_.upper)) return;
    result_.upper = height;
    result_.direction = d;
    result_.on_a = lowest_ ? lowest_->on_a : a_.support(d).point;
    result_.on_b = lowest_ ? lowest_->on_b : b_.support(-d).point;
  }

  const QuadricBody& a_;
  const QuadricBody& b_;
  Penetration result_{.upper = HUGE_VAL};
  QuadricExpansion expansion_;
  std::optional<LowestPlace> lowest_;
  std::size_t attempts_ = 0;
  bool found_ = false;
};

}  // namespace

std::optional<Penetration> depth_of_lowest_place(const QuadricBody& a, const QuadricBody& b) {
  DeepPair pair(a, b);
  return pair.find_lowest_place() ? std::optional(pair.answer()) : std::nullopt;
}

Penetration least_depth(const QuadricBody& a, const QuadricBody& b) { return DeepPair(a, b).answer(); }

namespace {

/// The penetration of bodies that have no inner point in common, as far as is known.
Penetration shallow_penetration(const QuadricNearest& near) {
  Penetration result;
  if (near.contact == QuadricContact::apart) return result;
  if (near.shared) result.on_a = result.on_b = near.shared->point;
  if (is_touching(near))
    result.direction = near.shared->normal;
  else
    result.status = Status::undecided;
  return result;
}

template <class B>
Penetration penetration_of(const PosedQuadric& shape_a, const B& shape_b) {
  if (contact_before_depth(shape_a, shape_b) == QuadricContact::apart) return {};
  const PairFrame frame = pair_frame(shape_a, shape_b);
  const QuadricBody a(shape_a, frame), b(shape_b, frame);
  DeepPair pair(a, b);
  if (!pair.find_lowest_place()) {
    if (contact_after_depth(shape_a, shape_b) == QuadricContact::apart) return {};
    if (!pair.certainly_meet()) {
      const QuadricNearest near = nearest_of(shape_a, a, shape_b, b, QuadricQuestion::distance);
      if (near.contact != QuadricContact::contact || near.shared) return shallow_penetration(near);
    }
  }
  Penetration result = pair.answer();
  // The direction is rounded: a little farther it certainly serves.
  result.upper = std::nextafter(result.upper * (1 + 0x1p-50) / frame.factor, HUGE_VAL);
  result.lower = std::nextafter(result.lower / frame.factor, 0);
  result.on_a = frame.back(result.on_a);
  result.on_b = frame.back(result.on_b);
  return result;
}

}  // namespace

Penetration penetration(const PosedQuadric& a, const PosedQuadric& b) {
  if (comes_before(b, a)) return flipped(penetration(b, a));
  return penetration_of(a, b);
}

Penetration penetration(const PosedQuadric& a, const PosedPolytope& b) {
  if (!b.solid())
    throw Error("penetration: the second shape is a surface, which has no interior to leave; ask for the distance");
  return penetration_of(a, b);
}

Penetration penetration(const PosedPolytope& a, const PosedQuadric& b) {
  if (!a.solid())
    throw Error("penetration: the first shape is a surface, which has no interior to leave; ask for the distance");
  return flipped(penetration(b, a));
}

}  // namespace toccata
