#include "methods/bsp/bsp_fragments.hpp"

#include <algorithm>

namespace toccata {
namespace {

constexpr BspPlane plane_of(BspLine line) { return line - 3; }

/// Whether an edge leads from corner i to the next: not from the end of a segment.
constexpr bool has_next(const PooledFragment& fragment, std::size_t i) {
  return fragment.count > 2 || i + 1 < fragment.count;
}

constexpr double rounding = 0x1p-49;  // of local places, which are at most 1: eight times over

}  // namespace

BspFragments::BspFragments(const BspPlanes& planes, const BspFrame& frame)
    : planes_(planes), frame_(frame), arithmetic_(planes, frame) {}

PooledFragment BspFragments::whole(Index triangle) {
  const Triangle t = planes_.triangle(triangle);
  const PooledFragment result{triangle, static_cast<Index>(pool_.size()), 3};
  for (Index i = 0; i < 3; ++i)
    pool_.push_back({frame_.local(t[static_cast<int>(i)]), 0, {(i + 2) % 3, i}, i, false, false});
  return result;
}

SplitFragment BspFragments::split(const PooledFragment& fragment, BspPlane plane, const RoundedBspPlane& rounded) {
  if (fragment.triangle == plane) return {{}, {}, fragment};
  heights_.clear();
  bool front = false, back = false;
  for (std::size_t i = 0; i < fragment.count; ++i) {
    heights_.push_back(height(fragment.triangle, corner(fragment, i), plane, rounded));
    front |= heights_.back().sign == Sign::positive;
    back |= heights_.back().sign == Sign::negative;
  }
  if (!front && !back) return {{}, {}, fragment};
  crossings_.assign(fragment.count, {});
  for (std::size_t i = 0; i < fragment.count; ++i)
    if (heights_[i].sign * next_sign(fragment, i) == Sign::negative) crossings_[i] = crossing(fragment, i, plane);
  const PooledFragment in_plane = within(fragment, plane);
  if (!front || !back) put_on_border(fragment);
  if (!back) return {fragment, {}, in_plane};
  if (!front) return {{}, fragment, in_plane};
  const PooledFragment in_front = part(fragment, Sign::positive, plane);
  return {in_front, part(fragment, Sign::negative, plane), in_plane};
}

/// The sign of the corner after corner i. The last corner of a segment is followed by none, and has its own.
Sign BspFragments::next_sign(const PooledFragment& fragment, std::size_t i) const {
  return heights_[has_next(fragment, i) ? (i + 1) % fragment.count : i].sign;
}

// A plane that cuts a convex polygon in two meets its border in two points, and no edge of it lies in the plane. So of
// the corners in the plane, and the crossings, one begins the edge along the cut: that after which the border leaves.
PooledFragment BspFragments::part(const PooledFragment& fragment, Sign side, BspPlane plane) {
  PooledFragment result{fragment.triangle, static_cast<Index>(pool_.size()), 0};
  const auto push_in_plane = [&](BspCorner corner, bool leaves) {
    corner.on_border = true;
    if (leaves) {
      corner.next = cut_line(plane);
      corner.next_on_border = true;
    }
    pool_.push_back(corner);
  };
  for (std::size_t i = 0; i < fragment.count; ++i) {
    const Sign here = heights_[i].sign * side, next = next_sign(fragment, i) * side;
    const bool leaves = next == Sign::negative;
    if (here == Sign::positive) pool_.push_back(BspCorner(corner(fragment, i)));
    if (here == Sign::zero) push_in_plane(corner(fragment, i), leaves);
    if (here * next == Sign::negative) push_in_plane(crossings_[i], leaves);
  }
  result.count = static_cast<Index>(pool_.size()) - result.first;
  return result;
}

/// The part within the plane of a fragment that reaches out of it: a corner or an edge of the fragment, or what lies
/// between two points of its border.
PooledFragment BspFragments::within(const PooledFragment& fragment, BspPlane plane) {
  PooledFragment result{fragment.triangle, static_cast<Index>(pool_.size()), 0};
  BspLine line = cut_line(plane);
  bool line_on_border = false;
  for (std::size_t i = 0; i < fragment.count; ++i) {
    if (heights_[i].sign == Sign::zero) pool_.push_back(BspCorner(corner(fragment, i)));
    if (heights_[i].sign * next_sign(fragment, i) == Sign::negative) pool_.push_back(crossings_[i]);
    if (!is_edge_in_plane(fragment, i)) continue;
    line = corner(fragment, i).next;
    line_on_border = corner(fragment, i).next_on_border;
  }
  result.count = static_cast<Index>(pool_.size()) - result.first;
  if (result.count == 0) return {};
  BspCorner& first = pool_[result.first];
  if (result.count == 1) return first.on_border ? PooledFragment{} : result;
  first.next = line;
  first.next_on_border = line_on_border;
  return line_on_border ? PooledFragment{} : result;
}

void BspFragments::put_on_border(const PooledFragment& fragment) {
  for (std::size_t i = 0; i < fragment.count; ++i) {
    BspCorner& corner = pool_[fragment.first + i];
    corner.on_border |= heights_[i].sign == Sign::zero;
    corner.next_on_border |= is_edge_in_plane(fragment, i);
  }
}

bool BspFragments::is_edge_in_plane(const PooledFragment& fragment, std::size_t i) const {
  return has_next(fragment, i) && heights_[i].sign == Sign::zero && next_sign(fragment, i) == Sign::zero;
}

CornerHeight BspFragments::height(Index triangle, const BspCorner& corner, BspPlane plane,
                                  const RoundedBspPlane& rounded) {
  const double value = rounded.height(corner.place), error = rounded.bound + rounded.slope() * corner.error;
  if (value > error) return {Sign::positive, value, error};
  if (value < -error) return {Sign::negative, value, error};
  return {exact_side(triangle, corner, plane), value, error};
}

Sign BspFragments::exact_side(Index triangle, const BspCorner& corner, BspPlane plane) {
  const auto& [p, q] = corner.on;
  if (is_edge(p) && is_edge(q)) return planes_.side(planes_.triangle(triangle)[static_cast<int>(q)], plane);
  if (p == cut_line(plane) || q == cut_line(plane)) return Sign::zero;
  if (is_edge(p)) return side_of_edge_point(triangle, p, plane_of(q), plane);
  return arithmetic_.side(exact_point(triangle, corner), plane);
}

/// A point strictly between the ends of an edge lies on the side on which both are, or one while the other is in the
/// plane: as where the plane is that of the neighbour across the edge.
Sign BspFragments::side_of_edge_point(Index triangle, BspLine edge, BspPlane cut, BspPlane plane) {
  const Triangle t = planes_.triangle(triangle);
  const Vec3 from = t[static_cast<int>(edge)], to = t[static_cast<int>((edge + 1) % 3)];
  const Sign first = planes_.side(from, plane), last = planes_.side(to, plane);
  if (first == last || last == Sign::zero) return first;
  if (first == Sign::zero) return last;
  return arithmetic_.side(arithmetic_.on_edge(from, to, cut), plane);
}

/// `on[0]` is the line of an edge of a fragment, so it is an edge of the triangle wherever one of the two is.
IntegerPoint BspFragments::exact_point(Index triangle, const BspCorner& corner) {
  const auto& [p, q] = corner.on;
  if (!is_edge(p)) return arithmetic_.where_meet(triangle, plane_of(p), plane_of(q));
  const Triangle t = planes_.triangle(triangle);
  return arithmetic_.on_edge(t[static_cast<int>(p)], t[static_cast<int>((p + 1) % 3)], plane_of(q));
}

/// Where the plane crosses the edge after corner i. Let p and q be the exact ends, s and r the exact magnitudes of
/// their heights, and D = s̃ + r̃ the sum of the computed ones, each off by at most β. The exact crossing is p + t(q − p)
/// with t = s / (s + r), and
///     |s̃/D − s/(s + r)| ≤ |s̃ − s|/D + s/(s + r) · |(s + r) − D|/D ≤ 3β/D.
/// The computed one is off by that much of the edge's length along any axis, by what its ends are off (by the greater
/// of the two, being between them), by the 2^-53 that a vertex is off besides, and by four roundings of numbers up to
/// 2: less than 2^-49 together.
BspCorner BspFragments::crossing(const PooledFragment& fragment, std::size_t i, BspPlane plane) {
  const std::size_t next = (i + 1) % fragment.count;
  const BspCorner &p = corner(fragment, i), &q = corner(fragment, next);
  const double above = std::fabs(heights_[i].value), below = std::fabs(heights_[next].value), sum = above + below;
  const double beta = std::max(heights_[i].error, heights_[next].error), error = std::max(p.error, q.error);
  const Vec3 way = q.place - p.place;
  const double length = largest_magnitude(way) + 2 * error + rounding;
  const bool on_border = p.next_on_border;
  BspCorner result{p.place + (above / sum) * way, 0, {p.next, cut_line(plane)}, p.next, on_border, on_border};
  result.error = 1.0001 * ((3 * beta / sum) * length + error + rounding);
  // Below comes true for NaN too.
  if (!(result.error <= 0x1p-32)) place_exactly(fragment.triangle, result);
  return result;
}

void BspFragments::place_exactly(Index triangle, BspCorner& corner) {
  corner.place = arithmetic_.place(exact_point(triangle, corner));
  corner.error = rounding;
}

}  // namespace toccata
