#include "query/relation/relation_segment_index.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "math/constants.hpp"
#include "toccata/trees/builders.hpp"
#include "toccata/trees/walk.hpp"

namespace toccata {
namespace {

/// The direction, up to right angles, that most of the length has: the mean of the fourth powers, which are the same
/// for directions at right angles. 1 where there is none.
std::complex<double> prevailing_direction(std::span<const PlanarSegment> segments) {
  std::complex<double> sum = 0;
  for (const PlanarSegment& s : segments) {
    const std::complex<double> along{s.right.x.around().lower - s.left.x.around().lower,
                                     s.right.y.around().lower - s.left.y.around().lower};
    const double length = std::abs(along);
    if (!std::isfinite(length) || length == 0) continue;
    const std::complex<double> squared = (along / length) * (along / length);
    sum += length * (squared * squared);
  }
  const std::complex<double> direction = std::sqrt(std::sqrt(sum / std::abs(sum)));
  const bool usable = std::isfinite(direction.real()) && std::isfinite(direction.imag());
  return usable ? direction : 1;
}

Interval hull(const Interval& a, const Interval& b) { return {std::min(a.lower, b.lower), std::max(a.upper, b.upper)}; }

class InRegion {
 public:
  InRegion(std::span<const Aabb> boxes, const Aabb& region, const std::function<void(Index)>& see)
      : boxes_(boxes), region_(region), see_(see) {}
  double bound(const Aabb& node) const { return overlap(node, region_) ? 0 : infinity; }
  double limit() const { return 0; }
  void visit(std::span<const Index> segments) const {
    for (const Index i : segments)
      if (overlap(boxes_[i], region_)) see_(i);
  }

 private:
  std::span<const Aabb> boxes_;
  const Aabb& region_;
  const std::function<void(Index)>& see_;
};

}  // namespace

SegmentIndex::SegmentIndex(std::span<const PlanarSegment> segments) {
  const std::complex<double> direction = prevailing_direction(segments);
  cosine_ = direction.real();
  sine_ = direction.imag();
  boxes_.reserve(segments.size());
  for (const PlanarSegment& s : segments) boxes_.push_back(box_around(s));
  tree_ = build_bvh(boxes_);
}

Aabb SegmentIndex::box_around(const Interval& x0, const Interval& y0, const Interval& x1, const Interval& y1) const {
  const Interval c{cosine_, cosine_}, s{sine_, sine_};
  const Interval u = hull(c * x0 + s * y0, c * x1 + s * y1), v = hull(c * y0 - s * x0, c * y1 - s * x1);
  const Interval x = hull(x0, x1);
  return {{u.lower, v.lower, x.lower}, {u.upper, v.upper, x.upper}};
}

Aabb SegmentIndex::box_around(const PlanarSegment& s) const {
  return box_around(s.left.x.around(), s.left.y.around(), s.right.x.around(), s.right.y.around());
}

void SegmentIndex::visit_in(const Aabb& region, const std::function<void(Index)>& see) const {
  InRegion question(boxes_, region, see);
  walk(tree_, question);
}

}  // namespace toccata
