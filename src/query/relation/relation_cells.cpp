#include "query/relation/relation_cells.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "query/relation/relation_segment_index.hpp"
#include "query/relation/relation_segments.hpp"

namespace toccata {
namespace {

/// The number at a fraction of the way from one number to another.
Rational part_of_the_way(const Rational& low, const Rational& high, const Rational& fraction) {
  return low + (high - low) * fraction;
}

/// A number strictly between two, given with doubles around them: a double where there is one near the wanted fraction
/// of the way, so that the numbers computed from it stay short. For two fractions it may be the same.
template <class Low, class High>
ExactNumber number_between(const Low& low, const High& high, double fraction) {
  const double from = low.around().upper, to = high.around().lower, likely = from + (to - from) * fraction;
  if (from < likely && likely < to) return ExactNumber(likely);
  Rational exact = part_of_the_way(low.exact(), high.exact(), to_rational(fraction));
  Rational shorter = to_rational(nearest_double(exact));
  return ExactNumber(low.exact() < shorter && shorter < high.exact() ? std::move(shorter) : std::move(exact));
}

/// The height of a segment at an x of its range, in doubles first; for a vertical one, that of its lower end.
class SegmentHeight {
 public:
  SegmentHeight(const PlanarSegment& s, const ExactNumber& x)
      : segment_(&s), x_(&x), around_(s.is_vertical() ? s.left.y.around() : approximate_height_at(s, x.around())) {}

  [[nodiscard]] const Interval& around() const { return around_; }
  [[nodiscard]] const Rational& exact() const {
    if (!exact_) exact_ = segment_->is_vertical() ? segment_->left.y.exact() : height_at(*segment_, *x_);
    return *exact_;
  }

  friend bool operator<(const SegmentHeight& a, const SegmentHeight& b) {
    if (certainly_less(a.around_, b.around_)) return true;
    if (a.around_.lower >= b.around_.upper) return false;
    return a.exact() < b.exact();
  }

 private:
  const PlanarSegment* segment_;
  const ExactNumber* x_;
  Interval around_;
  mutable std::optional<Rational> exact_;
};

/// The cells of one triangle, found from below: every cell has a piece of a segment that is not vertical as a lower
/// bound, and just above the middle of that piece lies the cell.
class CellFinder {
 public:
  CellFinder(const Triangle& t, std::span<const Triangle> cuts,
             const std::function<CellVisit(const ExactPoint&)>& visit)
      : origin_(to_rational(t[0])),
        normal_(cross(to_rational(t[1]) - origin_, to_rational(t[2]) - origin_)),
        axis_(projection_axis(t)),
        visit_(visit),
        segments_(segments_on(t, cuts, axis_)),
        index_(segments_) {}

  bool run() const {
    const bool uncut = segments_.size() == 3;
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      if (segments_[i].is_vertical()) continue;
      const std::vector<ExactNumber> ends = piece_ends(i);
      for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
        const ExactNumber x = number_between(ends[k], ends[k + 1], 0.5);
        const std::optional<Gap> gap = gap_above(i, x);
        if (!gap) continue;
        if (!visit_gap(*gap, x)) return false;
        if (uncut) return true;
      }
    }
    return true;
  }

 private:
  /// An open vertical piece of a cell.
  struct Gap {
    SegmentHeight low;
    SegmentHeight high;
  };

  /// The x at which other segments meet segment i, and its ends, ascending.
  std::vector<ExactNumber> piece_ends(std::size_t i) const {
    const PlanarSegment& s = segments_[i];
    std::vector<ExactNumber> ends{s.left.x, s.right.x};
    index_.visit_in(index_.box_around(s), [&](Index j) {
      if (j != i) add_intersection(s, segments_[j], ends);
    });
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    return ends;
  }

  /// The room above segment i at x, up to the next segment, if it lies in the triangle and is not that of a segment of
  /// lesser number on the same line.
  std::optional<Gap> gap_above(std::size_t i, const ExactNumber& x) const {
    std::optional<Gap> gap = gap_below_edge(i, x);
    if (!gap) return std::nullopt;
    const auto region_of = [&](const Gap& g) {
      return index_.box_around(x.around(), g.low.around(), x.around(), g.high.around());
    };
    Aabb region = region_of(*gap);
    index_.visit_in(region, [&](Index j) {
      if (j == i || !gap || !covers(segments_[j], x)) return;
      SegmentHeight height(segments_[j], x);
      if (height < gap->low) return;
      const bool higher = gap->low < height;
      if (!higher && j < i) gap.reset();
      if (!higher || !(height < gap->high)) return;
      gap->high = std::move(height);
      region = region_of(*gap);
    });
    return gap;
  }

  /// The room above segment i at x, up to the triangle's edge: in the triangle exactly one, of the first three
  /// segments, is above.
  std::optional<Gap> gap_below_edge(std::size_t i, const ExactNumber& x) const {
    const SegmentHeight low(segments_[i], x);
    std::optional<Gap> gap;
    for (std::size_t j = 0; j < 3; ++j) {
      // The right one counts where two edges share an end at x.
      if (j == i || !covers(segments_[j], x) || !(x < segments_[j].right.x)) continue;
      SegmentHeight height(segments_[j], x);
      if (!(low < height)) continue;
      if (gap) return std::nullopt;
      gap.emplace(Gap{low, std::move(height)});
    }
    return gap;
  }

  /// A closed one.
  static bool covers(const PlanarSegment& s, const ExactNumber& x) { return !(x < s.left.x) && !(s.right.x < x); }

  /// Only the first height is rounded; the others are exact parts of it above the lower bound, for in a gap of a few
  /// doubles, or none, rounded ones would be the same again and again. So all heights differ, and this ends when
  /// another point is asked for at finitely many points of the cell only.
  bool visit_gap(const Gap& gap, const ExactNumber& x) const {
    const Rational first = number_between(gap.low, gap.high, 0.125).exact();
    for (int part = 1;; ++part) {
      const Rational y = part == 1 ? first : part_of_the_way(gap.low.exact(), first, Rational(1, part));
      const CellVisit answer = visit_(point_above(x.exact(), y));
      if (answer != CellVisit::another) return answer == CellVisit::next;
    }
  }

  /// The point of the triangle's plane with this projection.
  ExactPoint point_above(const Rational& x, const Rational& y) const {
    const int i = (axis_ + 1) % 3, j = (axis_ + 2) % 3;
    std::array<Rational, 3> p;
    p[static_cast<std::size_t>(i)] = x;
    p[static_cast<std::size_t>(j)] = y;
    p[static_cast<std::size_t>(axis_)] =
        origin_[axis_] - (normal_[i] * (x - origin_[i]) + normal_[j] * (y - origin_[j])) / normal_[axis_];
    return ExactPoint(RationalPoint{p[0], p[1], p[2]});
  }

  RationalPoint origin_;  ///< a corner of the triangle, and its normal
  RationalPoint normal_;
  int axis_;
  const std::function<CellVisit(const ExactPoint&)>& visit_;
  std::vector<PlanarSegment> segments_;  ///< first the edges of the triangle
  SegmentIndex index_;
};

}  // namespace

int projection_axis(const Triangle& t) {
  const Vec3 u = t[1] - t[0], v = t[2] - t[0];
  const Vec3 normal = cross(u, v);
  int best = -1;
  for (int axis = 0; axis < 3; ++axis) {
    if (projected_orientation(t, axis) == Sign::zero) continue;
    // Not a number, where a product overflowed, never replaces a number.
    if (best < 0 || std::abs(normal[axis]) > std::abs(normal[best])) best = axis;
  }
  return best;
}

bool visit_cells(const Triangle& t, std::span<const Triangle> cuts,
                 const std::function<CellVisit(const ExactPoint&)>& visit) {
  return CellFinder(t, cuts, visit).run();
}

}  // namespace toccata
