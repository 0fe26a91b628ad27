#include "query/relation_cells.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace toccata {
namespace {

/// In the projection of the triangle; left ≤ right along x. Beyond the triangle a cut may go on: no harm.
struct PlanarSegment {
  RationalPoint2 left;
  RationalPoint2 right;
};

bool is_vertical(const PlanarSegment& s) { return s.left.x == s.right.x; }

PlanarSegment planar_segment(RationalPoint2 p, RationalPoint2 q) {
  if (q.x < p.x) std::swap(p, q);
  return {std::move(p), std::move(q)};
}

/// Of a segment that is not vertical, at an x in its range or beyond it.
Rational height_at(const PlanarSegment& s, const Rational& x) {
  return s.left.y + (s.right.y - s.left.y) * (x - s.left.x) / (s.right.x - s.left.x);
}

/// A number strictly between two: a double where there is one near the wanted fraction of the way, so that the numbers
/// computed from it stay short.
Rational between(const Rational& low, const Rational& high, const Rational& fraction) {
  Rational exact = low + (high - low) * fraction;
  const double rounded = nearest_double(exact);
  if (!std::isfinite(rounded)) return exact;
  Rational shorter = to_rational(rounded);
  return low < shorter && shorter < high ? shorter : exact;
}

/// Where the edge a → b crosses the plane of `t`, in the projection; the ends lie strictly on different sides.
RationalPoint2 plane_crossing(const Triangle& t, const Vec3& a, const Vec3& b, int axis) {
  const RationalPoint origin = to_rational(t[0]), from = to_rational(a), to = to_rational(b);
  const RationalPoint normal = cross(to_rational(t[1]) - origin, to_rational(t[2]) - origin);
  const Rational height_from = dot(normal, from - origin), height_to = dot(normal, to - origin);
  return drop_axis(from + (height_from / (height_from - height_to)) * (to - from), axis);
}

/// The edges of a coplanar triangle that enter the interior of `t`.
void add_coplanar_edges(const Triangle& t, const Triangle& cut, int axis, std::vector<PlanarSegment>& segments) {
  const Sign orientation = projected_orientation(t, axis);
  const auto is_beyond = [&](const Vec3& p, int edge) {
    return orient2d(drop_axis(t[edge], axis), drop_axis(t[(edge + 1) % 3], axis), drop_axis(p, axis)) * orientation !=
           Sign::positive;
  };
  for (int i = 0; i < 3; ++i) {
    const Vec3 &from = cut[i], &to = cut[(i + 1) % 3];
    const auto both_beyond = [&](int edge) { return is_beyond(from, edge) && is_beyond(to, edge); };
    if (both_beyond(0) || both_beyond(1) || both_beyond(2)) continue;
    segments.push_back(planar_segment(to_rational(drop_axis(from, axis)), to_rational(drop_axis(to, axis))));
  }
}

/// The segment in which another triangle cuts the plane of `t`, if it is one.
void add_plane_cut(const Triangle& t, const Triangle& cut, int axis, std::vector<PlanarSegment>& segments) {
  std::array<Sign, 3> side{};
  for (int i = 0; i < 3; ++i) side[static_cast<std::size_t>(i)] = orient3d(t[0], t[1], t[2], cut[i]);
  if (side == std::array{Sign::zero, Sign::zero, Sign::zero}) return add_coplanar_edges(t, cut, axis, segments);
  std::vector<RationalPoint2> ends;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const Sign from = side[static_cast<std::size_t>(i)], to = side[static_cast<std::size_t>(j)];
    if (from == Sign::zero) ends.push_back(to_rational(drop_axis(cut[i], axis)));
    if (from * to == Sign::negative) ends.push_back(plane_crossing(t, cut[i], cut[j], axis));
  }
  if (ends.size() == 2 && !(ends[0] == ends[1])) segments.push_back(planar_segment(ends[0], ends[1]));
}

/// The cells of one triangle, found from below: every cell has a piece of a segment that is not vertical as a lower
/// bound, and just above the middle of that piece lies the cell.
class CellFinder {
 public:
  CellFinder(const Triangle& t, std::span<const Triangle> cuts,
             const std::function<CellVisit(const ExactPoint&)>& visit)
      : triangle_(t), axis_(projection_axis(t)), visit_(visit) {
    for (int i = 0; i < 3; ++i)
      segments_.push_back(
          planar_segment(to_rational(drop_axis(t[i], axis_)), to_rational(drop_axis(t[(i + 1) % 3], axis_))));
    for (const Triangle& cut : cuts) add_plane_cut(t, cut, axis_, segments_);
  }

  bool run() const {
    const bool uncut = segments_.size() == 3;
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      if (is_vertical(segments_[i])) continue;
      const std::vector<Rational> ends = piece_ends(i);
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
    Rational x;
    Rational low;
    Rational high;
  };

  /// The x at which other segments meet segment i, and its ends, within the triangle's range, ascending.
  std::vector<Rational> piece_ends(std::size_t i) const {
    const PlanarSegment& s = segments_[i];
    std::vector<Rational> ends{s.left.x, s.right.x};
    for (std::size_t j = 0; j < segments_.size(); ++j)
      if (j != i) add_meeting(s, segments_[j], ends);
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    return ends;
  }

  /// Where two segments meet in one point. Segments on one line need no cut: their pieces overlap or border on one
  /// another, and the one of least number stands for all.
  static void add_meeting(const PlanarSegment& s, const PlanarSegment& other, std::vector<Rational>& ends) {
    if (other.right.x <= s.left.x || other.left.x >= s.right.x) return;  // at most in an end of s
    const Rational left = above(s, other.left), right = above(s, other.right);
    if ((left > 0 && right > 0) || (left < 0 && right < 0) || left == right) return;
    Rational x = other.left.x + (other.right.x - other.left.x) * left / (left - right);
    if (s.left.x < x && x < s.right.x) ends.push_back(std::move(x));
  }

  /// How far a point lies above the line of s.
  static Rational above(const PlanarSegment& s, const RationalPoint2& p) { return p.y - height_at(s, p.x); }

  /// The room above segment i at x, up to the next segment, if it lies in the triangle and is not that of a segment of
  /// lesser number on the same line.
  std::optional<Gap> gap_above(std::size_t i, const Rational& x) const {
    Gap gap{x, height_at(segments_[i], x), 0};
    bool bounded = false;
    int edges_above = 0;
    for (std::size_t j = 0; j < segments_.size(); ++j) {
      const PlanarSegment& s = segments_[j];
      if (j == i || x < s.left.x || x > s.right.x) continue;
      const Rational height = is_vertical(s) ? std::min(s.left.y, s.right.y) : height_at(s, x);
      if (height == gap.low && j < i) return std::nullopt;
      if (height <= gap.low) continue;
      // Of two edges that share an end at x, the right one counts.
      if (j < 3 && x < s.right.x) ++edges_above;
      if (!bounded || height < gap.high) gap.high = height;
      bounded = true;
    }
    // In the triangle exactly one of its edges, the first three segments, is above.
    if (edges_above != 1) return std::nullopt;
    return gap;
  }

  bool visit_gap(const Gap& gap) const {
    for (int attempt = 0;; ++attempt) {
      const Rational y = between(gap.low, gap.high, Rational(1, 8 + attempt));
      const CellVisit answer = visit_(point_above(gap.x, y));
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
