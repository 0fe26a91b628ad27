#include "methods/bsp/bsp_sweep.hpp"

#include <algorithm>
#include <cmath>

#include "math/constants.hpp"
#include "narrow/convex/vertices_of.hpp"
#include "query/posed_shape.hpp"

namespace toccata {
namespace {

/// Coordinates up to here neither overflow nor were clamped when a box was put around them.
constexpr double largest_clipped = 0x1p1000;

}  // namespace

BspSweep::BspSweep(const BspTree::Parts& parts, const Vec3& point, const Vec3& motion)
    : parts_(parts), motion_(motion) {
  pose({&point, 1}, {point, point}, 0);
}

BspSweep::BspSweep(const BspTree::Parts& parts, const PosedPolytope& shape, const Vec3& motion)
    : parts_(parts), motion_(motion) {
  pose(vertices_of(shape), world_box(shape), shape.radius());
}

void BspSweep::pose(std::span<const Vec3> points, const Aabb& box, double radius) {
  clip_to_box(box);
  Aabb around;
  double largest = 0;
  for (const Vec3& p : points) {
    const Vec3 local = parts_.frame.local(p);
    around = merge(around, local);
    largest = std::max(largest, largest_magnitude(local));
  }
  const Vec3 middle = 0.5 * (around.lower + around.upper), motion = parts_.frame.way(motion_);
  half_ = 0.5 * (around.upper - around.lower);
  radius_ = parts_.frame.way({radius, 0, 0}).x;
  start_ = middle + enters_ * motion;
  way_ = (middle + leaves_ * motion) - start_;
  // The places at any time of all of the shape have some ten roundings of numbers no greater than this, and three times
  // it is 48 · 2^-53. Infinite where something overflowed, and then nothing is certain.
  off_ = 0x1p-49 * (largest + largest_magnitude(motion)) + filter::floor;
  reach_ = std::max(largest_magnitude(start_), largest_magnitude(start_ + way_)) + largest_magnitude(half_) + radius_;
  reach_ = std::max(1.0, 1.001 * reach_ + off_);
  if (points.size() > 1)
    for (const Vec3& p : points) points_.push_back(parts_.frame.local(p) - middle);
}

/// A time is a difference over a difference, each rounded once, so it is off by less than 2^-51 of itself, or by
/// 2^-1074 where it is that small. Twice that is taken from the beginnings, so that they are not later than ends which
/// are not; that an end may be as much too early is within what `off_` leaves. A difference that overflows is more than
/// any motion, and its time beyond 1 or before 0, as infinity is. Where the shape certainly misses the box, it leaves
/// before it enters.
void BspSweep::clip_to_box(const Aabb& box) {
  if (std::max(largest_magnitude(box.lower), largest_magnitude(box.upper)) > largest_clipped) return;
  for (int axis = 0; axis < 3; ++axis) {
    const double motion = motion_[axis], low = box.lower[axis], high = box.upper[axis];
    const double lower = parts_.frame.box().lower[axis], upper = parts_.frame.box().upper[axis];
    if (motion == 0) {
      if (high < lower || low > upper) leaves_ = -1;
      continue;
    }
    const double a = (lower - high) / motion, b = (upper - low) / motion;
    const double first = std::min(a, b), last = std::max(a, b);
    const double begin = first - (0x1p-50 * std::fabs(first) + 0x1p-1070);
    if (begin > enters_) {  // not so for NaN
      enters_ = begin;
      entered_ = {};
      entered_[axis] = motion > 0 ? -1 : 1;
    }
    leaves_ = std::min(leaves_, last);
  }
}

/// The height of a place q is normal · q − offset, whose error is linear in q but for that of the offset: so at places
/// up to `reach_` it is at most that many times the bound. Some 2^-21 of the slope in the bound are for roundings of
/// floats, which do not happen here: that is more than the some 45 roundings of doubles, those in which a normal was
/// summed up included. Being off by `off_` is worth that times the slope.
inline BspHeights BspSweep::heights_of_middle(const BspSide& side) const {
  const double error = 1.001 * (reach_ * side.bound + 3 * side.slope * off_);
  return {dot(side.normal, start_) - side.offset, dot(side.normal, way_), 0, 0, error};
}

inline BspHeights BspSweep::rough_heights(const BspSide& side) const {
  BspHeights result = heights_of_middle(side);
  const double round = radius_ > 0 ? radius_ * plain_length(side.normal) : 0;
  result.high = dot(magnitudes(side.normal), half_) + round;
  result.low = -result.high;
  return result;
}

BspHeights BspSweep::heights(const BspSide& side) const {
  BspHeights result = rough_heights(side);
  if (points_.empty()) return result;
  result.low = infinity;
  result.high = -infinity;
  for (const Vec3& p : points_) {
    const double height = dot(side.normal, p);
    result.low = std::min(result.low, height);
    result.high = std::max(result.high, height);
  }
  const double round = radius_ > 0 ? radius_ * plain_length(side.normal) : 0;
  result.low -= round;
  result.high += round;
  return result;
}

void BspSweep::run(Meet meet) {
  run(meet, [](const BspStretch&) { return infinity; });
}

void BspSweep::run_through_cells(Enter enter) {
  path_.resize(parts_.statistics.depth);
  run([](Index, const BspStretch&) { return infinity; }, enter);
}

void BspSweep::run(Meet meet, Enter enter) {
  if (enters_ > leaves_) return;
  const bool is_point = points_.empty() && radius_ == 0;
  is_point ? pass_all<Extent::point>(meet, enter) : pass_all<Extent::shape>(meet, enter);
}

template <BspSweep::Extent extent>
void BspSweep::pass_all(Meet meet, Enter enter) {
  waiting_.reserve(parts_.statistics.depth + 1);
  waiting_.push_back({});
  while (!waiting_.empty()) {
    const Waiting waiting = waiting_.back();
    waiting_.pop_back();
    if (is_of_interest(waiting.stretch)) pass<extent>(waiting, meet, enter);
  }
}

Vec3 BspSweep::against_motion(const Vec3& normal) const {
  const Vec3 unit = unit_or_zero(normal);
  return dot(unit, way_) > 0 ? -unit : unit;
}

Vec3 BspSweep::entered_across(const BspStretch& stretch) const {
  if (is_leaf(stretch.entered)) return entered_;
  return against_motion(side_of(parts_.nodes[static_cast<std::size_t>(stretch.entered)].floats).normal);
}

/// No better than is needed to know the side.
template <BspSweep::Extent extent>
BspHeights BspSweep::heights_for(const BspSide& side, const BspStretch& stretch) const {
  if (extent == Extent::point) return heights_of_middle(side);
  const BspHeights rough = rough_heights(side);
  return points_.empty() || rough.side(stretch) != Sign::zero ? rough : heights(side);
}

/// The part on the side that it comes from goes on at once, the other waits.
template <BspSweep::Extent extent>
inline BspStretch BspSweep::pass_on_both_sides(const BspStretch& stretch, const BspHeights& along, Meet meet) {
  const BspChild at = stretch.at;
  const BspNode& node = parts_.nodes[static_cast<std::size_t>(at)];
  BspStretch behind = along.behind(stretch), in_front = along.in_front(stretch);
  const BspStretch in_plane{at, at, std::max(behind.from, in_front.from), std::min(behind.to, in_front.to)};
  if (!in_plane.is_empty())
    for (const StoredFragment& fragment : parts_.fragments_of(at))
      latest_ = std::min(latest_, meet(fragment.triangle, in_plane));
  const bool rises = along.rise > 0;
  BspStretch first = rises ? behind : in_front, last = rises ? in_front : behind;
  if (last.from > stretch.from) last.entered = at;
  first.at = node.child[!rises];
  last.at = node.child[rises];
  const bool goes_on = !first.is_empty();
  if (goes_on && !last.is_empty()) waiting_.push_back({last, depth_ + 1, {at, rises}});
  follow({at, rises != goes_on});
  return goes_on ? first : last;
}

template <BspSweep::Extent extent>
void BspSweep::pass(const Waiting& waiting, Meet meet, Enter enter) {
  BspStretch stretch = waiting.stretch;
  depth_ = waiting.depth;
  if (depth_ > 0) {
    --depth_;
    follow(waiting.last);
  }
  while (!is_leaf(stretch.at)) {
    const BspNode& node = parts_.nodes[static_cast<std::size_t>(stretch.at)];
    const BspHeights along = heights_for<extent>(side_of(node.floats), stretch);
    const Sign side = along.side(stretch);
    if (side != Sign::zero) {
      follow({stretch.at, side == Sign::positive});
      stretch.at = node.child[side == Sign::positive];
      continue;
    }
    stretch = pass_on_both_sides<extent>(stretch, along, meet);
    if (!is_of_interest(stretch)) return;
  }
  if (winding_of_leaf(stretch.at) != 0) latest_ = std::min(latest_, enter(stretch));
}

/// Local places, each off by less than three times `off_`, and where the shape is by some roundings more.
bool BspSweep::may_meet(const Triangle& triangle, const BspStretch& stretch) const {
  const double pad = radius_ + 3 * off_ + reach_ * 0x1p-47;
  const Vec3 from = start_ + stretch.from * way_, to = start_ + stretch.to * way_;
  const Vec3 a = parts_.frame.local(triangle[0]), b = parts_.frame.local(triangle[1]),
             c = parts_.frame.local(triangle[2]);
  for (int axis = 0; axis < 3; ++axis) {
    const double reach = half_[axis] + pad;
    if (std::max({a[axis], b[axis], c[axis]}) < std::min(from[axis], to[axis]) - reach) return false;
    if (std::min({a[axis], b[axis], c[axis]}) > std::max(from[axis], to[axis]) + reach) return false;
  }
  return true;
}

std::vector<BspSide> BspSweep::sides_of_cell() const {
  std::vector<BspSide> sides;
  for (const Step& step : std::span(path_).first(depth_)) {
    BspSide side = side_of(parts_.nodes[static_cast<std::size_t>(step.node)].floats);
    if (step.to_front) side = {-side.normal, -side.offset, side.bound, side.slope};
    sides.push_back(side);
  }
  return sides;
}

}  // namespace toccata
