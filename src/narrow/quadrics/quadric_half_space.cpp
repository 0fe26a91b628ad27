#include <cmath>
#include <utility>

#include "math/vec3_measures.hpp"
#include "narrow/quadrics/distance/quadric_proof.hpp"
#include "narrow/quadrics/exact_place.hpp"
#include "narrow/quadrics/quadric_order.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {
namespace {

/// A quadric above a plane, in a frame around the shape. Which side it is on is exact.
class Above {
 public:
  Above(const PosedQuadric& a, const PosedHalfSpace& b)
      : shape_(a), plane_(b), frame_(pair_frame(a, b)), body_(a, frame_), normal_(scaled_normal(b)) {
    const FineDirection down = fine(-normal_);
    const BoundedVector n = exactly(normal_);
    level_ = dot(n, frame_.place(b.point));
    gap_ = -(height_of<BoundedNumber>(body_, down) + level_);
    length_ = length(n);
    lowest_ = body_.support(-normal_).point;
    lowest_side_ = sign_or_exact(gap_, b.normal);
  }

  [[nodiscard]] QuadricContact contact() const {
    return lowest_side_ == Sign::positive ? QuadricContact::apart : QuadricContact::contact;
  }

  /// Where they meet the lowest point of the shape is one of both; that above which it lies need not be one of the
  /// shape.
  [[nodiscard]] Distance distance() const {
    Distance result;
    result.on_a = result.on_b = frame_.back(lowest_);
    if (contact() == QuadricContact::contact) return result;
    const BoundedNumber height = gap_ / length_;
    result.on_b = frame_.back(lowest_ - (middle(height) / middle(length_)) * normal_);
    result.lower = std::nextafter(std::fmax(floor_of(height), 0) / frame_.factor, 0);
    result.upper = std::nextafter(ceiling_of(height) / frame_.factor, HUGE_VAL);
    const bool narrow = result.upper - result.lower <= 1e-12 * result.upper;
    result.status = narrow ? Status::exact : Status::not_converged;
    return result;
  }

  [[nodiscard]] Relation relation() const {
    Relation result;
    result.a_solid = result.b_solid = true;
    if (contact() == QuadricContact::apart) return result;
    result.kind = lowest_side_ == Sign::negative ? RelationKind::overlapping : RelationKind::touching;
    if (lowest_side_ == Sign::negative && is_below()) result.containment = Containment::a_in_b;
    return result;
  }

  [[nodiscard]] Penetration penetration() const {
    Penetration result;
    if (contact() == QuadricContact::apart) return result;
    const BoundedNumber depth = -(gap_ / length_);
    result.direction = -unit_or_zero(normal_);
    result.on_a = frame_.back(lowest_);
    result.on_b = frame_.back(lowest_ + (middle(depth) / middle(length_)) * normal_);
    if (lowest_side_ == Sign::zero) return result;
    // The direction is rounded, so that a little more is to be gone.
    result.lower = std::nextafter(std::fmax(floor_of(depth), 0) / frame_.factor, 0);
    result.upper = std::nextafter((1 + 0x1p-50) * ceiling_of(depth) / frame_.factor, HUGE_VAL);
    result.status = result.upper - result.lower <= 1e-12 * result.upper ? Status::exact : Status::not_converged;
    return result;
  }

 private:
  /// That of the height above the plane seen along this normal.
  [[nodiscard]] Sign sign_or_exact(const BoundedNumber& height, const Vec3& normal) const {
    if (height.is_positive()) return Sign::positive;
    return height.is_negative() ? Sign::negative : exact_sign_of_height(shape_, plane_.point, normal);
  }

  /// Its highest point lies below the plane or in it.
  [[nodiscard]] bool is_below() const {
    const BoundedNumber top = height_of<BoundedNumber>(body_, fine(normal_)) - level_;
    return sign_or_exact(-top, -plane_.normal) != Sign::negative;
  }

  const PosedQuadric& shape_;
  const PosedHalfSpace& plane_;
  PairFrame frame_;
  QuadricBody body_;
  Vec3 normal_;
  BoundedNumber level_;  ///< of the plane along the normal
  BoundedNumber gap_;    ///< times the length of the normal
  BoundedNumber length_;
  Vec3 lowest_;
  Sign lowest_side_ = Sign::zero;
};

}  // namespace

QuadricContact quadric_contact(const PosedQuadric& a, const PosedHalfSpace& b) { return Above(a, b).contact(); }
QuadricContact quadric_contact(const PosedHalfSpace& a, const PosedQuadric& b) { return quadric_contact(b, a); }

bool overlap(const PosedQuadric& a, const PosedHalfSpace& b) { return quadric_contact(a, b) != QuadricContact::apart; }
bool overlap(const PosedHalfSpace& a, const PosedQuadric& b) { return overlap(b, a); }

Distance distance(const PosedQuadric& a, const PosedHalfSpace& b) { return Above(a, b).distance(); }

Relation relation(const PosedQuadric& a, const PosedHalfSpace& b) { return Above(a, b).relation(); }
Penetration penetration(const PosedQuadric& a, const PosedHalfSpace& b) { return Above(a, b).penetration(); }

Distance distance(const PosedHalfSpace& a, const PosedQuadric& b) { return flipped(distance(b, a)); }
Relation relation(const PosedHalfSpace& a, const PosedQuadric& b) { return flipped(relation(b, a)); }
Penetration penetration(const PosedHalfSpace& a, const PosedQuadric& b) { return flipped(penetration(b, a)); }

}  // namespace toccata
