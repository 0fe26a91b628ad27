#include <cmath>
#include <utility>

#include "narrow/smooth/smooth_proof.hpp"
#include "toccata/narrow/smooth.hpp"

namespace toccata {
namespace {

/// A smooth shape above a plane, in a frame around the shape.
class Above {
 public:
  Above(const PosedSmooth& a, const PosedHalfSpace& b) : frame_(pair_frame(a, a)), body_(a, frame_) {
    const double largest = std::fmax(std::fmax(std::fabs(b.normal.x), std::fabs(b.normal.y)), std::fabs(b.normal.z));
    const double scale = std::scalbn(1.0, -std::ilogb(largest));
    normal_ = scale * b.normal;
    const FineDirection down = fine(-normal_);
    const BoundedVector n = exactly(normal_);
    gap_ = -(height_of<BoundedNumber>(body_, down) + dot(n, frame_.place(b.point)));
    length_ = length(n);
    lowest_ = body_.support(-normal_).point;
  }

  [[nodiscard]] SmoothContact contact() const {
    if (gap_.is_positive()) return SmoothContact::apart;
    return gap_.is_negative() ? SmoothContact::contact : SmoothContact::undecided;
  }

  [[nodiscard]] Distance distance() const {
    Distance result;
    result.on_a = frame_.back(lowest_);
    const BoundedNumber height = gap_ / length_;
    result.on_b = frame_.back(lowest_ - (middle(height) / middle(length_)) * normal_);
    if (contact() == SmoothContact::apart) {
      result.lower = std::nextafter(std::fmax(floor_of(height), 0) / frame_.factor, 0);
      result.upper = std::nextafter(ceiling_of(height) / frame_.factor, HUGE_VAL);
      const bool narrow = result.upper - result.lower <= 1e-12 * result.upper;
      result.status = narrow ? Status::exact : Status::not_converged;
      return result;
    }
    result.on_a = result.on_b;
    if (contact() == SmoothContact::contact) return result;
    result.upper = std::nextafter(std::fmax(ceiling_of(height), 0) / frame_.factor, HUGE_VAL);
    result.status = Status::undecided;
    return result;
  }

 private:
  PairFrame frame_;
  SmoothBody body_;
  Vec3 normal_;
  BoundedNumber gap_;  ///< times the length of the normal
  BoundedNumber length_;
  Vec3 lowest_;
};

}  // namespace

SmoothContact smooth_contact(const PosedSmooth& a, const PosedHalfSpace& b) { return Above(a, b).contact(); }
SmoothContact smooth_contact(const PosedHalfSpace& a, const PosedSmooth& b) { return smooth_contact(b, a); }

bool overlap(const PosedSmooth& a, const PosedHalfSpace& b) { return smooth_contact(a, b) != SmoothContact::apart; }
bool overlap(const PosedHalfSpace& a, const PosedSmooth& b) { return overlap(b, a); }

Distance distance(const PosedSmooth& a, const PosedHalfSpace& b) { return Above(a, b).distance(); }

Distance distance(const PosedHalfSpace& a, const PosedSmooth& b) {
  Distance result = distance(b, a);
  std::swap(result.on_a, result.on_b);
  return result;
}

}  // namespace toccata
