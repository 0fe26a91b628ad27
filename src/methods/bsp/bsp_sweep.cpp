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

BspSide side_of(const FloatBspPlane& plane) {
  const Vec3 normal = as_doubles(plane.normal);
  return {normal, plane.offset, plane.bound, sum_of_magnitudes(normal)};
}

/// Where the exact height of the shape's lowest or highest point is 0, the computed one is within the error, so this is
/// no farther from where the computed one is 0 than the error over the rise. The error is 2^-20 of the slope times
/// `reach_` at least, and the rise no more than twice that: so as much again is more than any roundings here.
BspStretch BspHeights::cut(BspStretch stretch, double risen, bool begins) const {
  const double crossing = risen / rise, off = 2 * std::fabs(error / rise);
  if (!(off < 1 && std::fabs(crossing) < 2)) return stretch;  // so for NaN
  if (!begins) {
    stretch.to = std::min(stretch.to, crossing + off);
  } else if (crossing - off > stretch.from) {
    stretch.from = crossing - off;
  }
  return stretch;
}

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
/// up to `reach_` it is at most that many times the bound. Of the bound some 2^-21 of the slope are for roundings of
/// floats, which do not happen here: that is more than the some 45 roundings of doubles, those in which a normal was
/// summed up included. Being off by `off_` is worth that times the slope.
BspHeights BspSweep::rough_heights(const BspSide& side) const {
  const double error = 1.001 * (reach_ * side.bound + 3 * side.slope * off_);
  const double round = radius_ > 0 ? radius_ * plain_length(side.normal) : 0;
  const double reach = dot(magnitudes(side.normal), half_) + round;
  return {dot(side.normal, start_) - side.offset, dot(side.normal, way_), -reach, reach, error};
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
  waiting_.push_back({});
  while (!waiting_.empty()) {
    const Waiting waiting = waiting_.back();
    waiting_.pop_back();
    // A time is the fraction's place between both ends, in four roundings of numbers up to 1.
    if (!(time_before(waiting.stretch) > latest_)) pass(waiting, meet, enter);
  }
}

double BspSweep::time_before(const BspStretch& stretch) const {
  return enters_ + stretch.from * (leaves_ - enters_) - 0x1p-50;
}

Vec3 BspSweep::against_motion(const Vec3& normal) const {
  const Vec3 unit = unit_or_zero(normal);
  return dot(unit, way_) > 0 ? -unit : unit;
}

Vec3 BspSweep::entered_across(const BspStretch& stretch) const {
  if (is_leaf(stretch.entered)) return entered_;
  return against_motion(side_of(parts_.nodes[static_cast<std::size_t>(stretch.entered)].floats).normal);
}

void BspSweep::pass(const Waiting& waiting, Meet meet, Enter enter) {
  BspStretch stretch = waiting.stretch;
  depth_ = waiting.depth;
  if (depth_ > 0) {
    --depth_;
    follow(waiting.last);
  }
  while (!is_leaf(stretch.at)) {
    const BspChild at = stretch.at;
    const BspNode& node = parts_.nodes[static_cast<std::size_t>(at)];
    const BspSide plane = side_of(node.floats);
    BspHeights along = rough_heights(plane);
    Sign side = along.side(stretch);
    if (side == Sign::zero && !points_.empty()) {
      along = heights(plane);
      side = along.side(stretch);
    }
    if (side == Sign::zero) return pass_on_both_sides(stretch, along, meet);
    follow({at, side == Sign::positive});
    stretch.at = node.child[side == Sign::positive];
  }
  if (winding_of_leaf(stretch.at) != 0) latest_ = std::min(latest_, enter(stretch));
}

void BspSweep::follow(const Step& step) {
  if (!path_.empty()) path_[depth_] = step;
  ++depth_;
}

void BspSweep::pass_on_both_sides(const BspStretch& stretch, const BspHeights& along, Meet meet) {
  const BspChild at = stretch.at;
  const BspNode& node = parts_.nodes[static_cast<std::size_t>(at)];
  BspStretch behind = along.behind(stretch), in_front = along.in_front(stretch);
  const BspStretch in_plane{at, at, std::max(behind.from, in_front.from), std::min(behind.to, in_front.to)};
  if (behind.from > stretch.from) behind.entered = at;
  if (in_front.from > stretch.from) in_front.entered = at;
  behind.at = node.back();
  in_front.at = node.front();
  // The last is looked at first.
  if (along.rise > 0) push(in_front, {at, true});
  push(behind, {at, false});
  if (!(along.rise > 0)) push(in_front, {at, true});
  if (in_plane.is_empty()) return;
  for (const StoredFragment& fragment : parts_.fragments_of(at))
    latest_ = std::min(latest_, meet(fragment.triangle, in_plane));
}

void BspSweep::push(const BspStretch& stretch, const Step& last) {
  if (!stretch.is_empty()) waiting_.push_back({stretch, depth_ + 1, last});
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
