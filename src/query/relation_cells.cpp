#include "query/relation_cells.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "query/relation_segments.hpp"

namespace toccata {
namespace {

/// The number at a fraction of the way from one number to another.
Rational part_of_the_way(const ExactNumber& low, const ExactNumber& high, const Rational& fraction) {
  return low.exact() + (high.exact() - low.exact()) * fraction;
}

/// A number strictly between two: a double where there is one near the wanted fraction of the way, so that the numbers
/// computed from it stay short. For two fractions it may be the same.
ExactNumber between(const ExactNumber& low, const ExactNumber& high, const Rational& fraction) {
  Rational exact = part_of_the_way(low, high, fraction);
  Rational shorter = to_rational(nearest_double(exact));
  return ExactNumber(low.exact() < shorter && shorter < high.exact() ? std::move(shorter) : std::move(exact));
}

/// Of a segment at an x of its range, in doubles first; of a vertical one that of its lower end.
class Height {
 public:
  Height(const PlanarSegment& s, const ExactNumber& x)
      : segment_(s), x_(x), lower_end_(s.is_vertical() ? &std::min(s.left.y, s.right.y) : nullptr) {}
  [[nodiscard]] Interval about() const {
    return lower_end_ != nullptr ? lower_end_->around() : approximate_height_at(segment_, x_.around());
  }
  [[nodiscard]] ExactNumber exact() const { return lower_end_ != nullptr ? *lower_end_ : height_at(segment_, x_); }

 private:
  const PlanarSegment& segment_;
  const ExactNumber& x_;
  const ExactNumber* lower_end_;
};

/// The cells of one triangle, found from below: every cell has a piece of a segment that is not vertical as a lower
/// bound, and just above the middle of that piece lies the cell.
class CellFinder {
 public:
  CellFinder(const Triangle& t, std::span<const Triangle> cuts,
             const std::function<CellVisit(const ExactPoint&)>& visit)
      : triangle_(t), axis_(projection_axis(t)), visit_(visit), segments_(segments_on(t, cuts, axis_)) {}

  bool run() const {
    const bool uncut = segments_.size() == 3;
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      if (segments_[i].is_vertical()) continue;
      const std::vector<ExactNumber> ends = piece_ends(i);
      for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
        const std::optional<Gap> gap = gap_above(i, between(ends[k], ends[k + 1], Rational(1, 2)));
        if (!gap) continue;
        if (!visit_gap(*gap)) return false;
        if (uncut) return true;
      }
    }
    return true;
  }

 private:
  /// An open vertical piece of a cell.
  struct Gap {
    ExactNumber x;
    ExactNumber low;
    ExactNumber high;
  };

  /// The x at which other segments meet segment i, and its ends, ascending.
  std::vector<ExactNumber> piece_ends(std::size_t i) const {
    const PlanarSegment& s = segments_[i];
    std::vector<ExactNumber> ends{s.left.x, s.right.x};
    for (std::size_t j = 0; j < segments_.size(); ++j)
      if (j != i) add_meeting(s, segments_[j], ends);
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    return ends;
  }

  /// The room above segment i at x, up to the next segment, if it lies in the triangle and is not that of a segment of
  /// lesser number on the same line.
  std::optional<Gap> gap_above(std::size_t i, const ExactNumber& x) const {
    Gap gap{x, height_at(segments_[i], x), {}};
    bool bounded = false;
    int edges_above = 0;
    for (std::size_t j = 0; j < segments_.size(); ++j) {
      const PlanarSegment& s = segments_[j];
      if (j == i || x < s.left.x || s.right.x < x) continue;
      // Of two edges that share an end at x, the right one counts.
      const bool counts = j < 3 && x < s.right.x;
      const Height height(s, x);
      if (certainly_less(height.about(), gap.low.around())) continue;
      if (bounded && certainly_less(gap.high.around(), height.about())) {
        edges_above += counts ? 1 : 0;
        continue;
      }
      ExactNumber exact = height.exact();
      if (exact == gap.low && j < i) return std::nullopt;
      if (!(gap.low < exact)) continue;
      edges_above += counts ? 1 : 0;
      if (!bounded || exact < gap.high) gap.high = std::move(exact);
      bounded = true;
    }
    // In the triangle exactly one of its edges, the first three segments, is above.
    if (edges_above != 1) return std::nullopt;
    return gap;
  }

  /// Only the first height is rounded; the others are exact parts of it above the lower bound, for in a gap of a few
  /// doubles, or none, rounded ones would be the same again and again. So all heights differ, and this ends when
  /// another point is asked for at finitely many points of the cell only.
  bool visit_gap(const Gap& gap) const {
    const ExactNumber first = between(gap.low, gap.high, Rational(1, 8));
    for (int part = 1;; ++part) {
      const Rational y = part_of_the_way(gap.low, first, Rational(1, part));
      const CellVisit answer = visit_(point_above(gap.x.exact(), y));
      if (answer != CellVisit::another) return answer == CellVisit::next;
    }
  }

  /// The point of the triangle's plane with this projection.
  ExactPoint point_above(const Rational& x, const Rational& y) const {
    const RationalPoint origin = to_rational(triangle_[0]);
    const RationalPoint normal = cross(to_rational(triangle_[1]) - origin, to_rational(triangle_[2]) - origin);
    const int i = (axis_ + 1) % 3, j = (axis_ + 2) % 3;
    std::array<Rational, 3> p;
    p[static_cast<std::size_t>(i)] = x;
    p[static_cast<std::size_t>(j)] = y;
    p[static_cast<std::size_t>(axis_)] =
        origin[axis_] - (normal[i] * (x - origin[i]) + normal[j] * (y - origin[j])) / normal[axis_];
    return ExactPoint(RationalPoint{p[0], p[1], p[2]});
  }

  Triangle triangle_;
  int axis_;
  const std::function<CellVisit(const ExactPoint&)>& visit_;
  std::vector<PlanarSegment> segments_;  ///< first the edges of the triangle
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
