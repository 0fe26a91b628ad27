#include "methods/bsp/bsp_ray.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "math/constants.hpp"
#include "narrow/triangles/ray_triangle.hpp"
#include "toccata/core/error.hpp"
#include "toccata/narrow/triangle_triangle.hpp"

namespace toccata {

/// False where the ray certainly misses the box. A time is a difference over a difference, each rounded once, so it is
/// off by less than 2^-51 of itself, or by 2^-1074 where it is that small. A difference that overflows is more than any
/// motion, and its time beyond 1 or before 0, as infinity is.
bool BspRayWalk::enter_box() {
  for (int axis = 0; axis < 3; ++axis) {
    const double origin = origin_[axis], motion = motion_[axis];
    const double lower = parts_.frame.box().lower[axis], upper = parts_.frame.box().upper[axis];
    if (motion == 0) {
      if (origin < lower || origin > upper) return false;
      continue;
    }
    const double a = (lower - origin) / motion, b = (upper - origin) / motion;
    const double first = std::min(a, b), last = std::max(a, b);
    enters_ = std::max(enters_, first - (0x1p-50 * std::fabs(first) + 0x1p-1070));  // 0 before NaN
    leaves_ = std::min(leaves_, last + (0x1p-50 * std::fabs(last) + 0x1p-1070));
  }
  if (enters_ > leaves_) return false;
  const Vec3 origin = parts_.frame.local(origin_), motion = parts_.frame.way(motion_);
  start_ = origin + enters_ * motion;
  way_ = (origin + leaves_ * motion) - start_;
  // Each of the ends has three roundings of numbers no greater than this, the way between them one more.
  off_ = 0x1p-49 * (largest_magnitude(origin) + largest_magnitude(motion)) + filter::floor;
  return true;
}

/// The bound of the plane is for places within the box; beyond it, the ends are at most what they are off by and some
/// 2^-50 of the way. It holds for what is computed in floats, and so for doubles. Being off by `off_` is worth that
/// times the sum of the normal; eight roundings of doubles of about that sum are within another 2^-49 of it.
BspRayWalk::Heights BspRayWalk::heights(const FloatBspPlane& plane) const {
  const Vec3 normal = as_doubles(plane.normal);
  const double slope = sum_of_magnitudes(normal);
  return {dot(normal, start_) - plane.offset, dot(normal, way_), 1.001 * (plane.bound + slope * (3 * off_ + 0x1p-48))};
}

void BspRayWalk::run(Meet meet) {
  if (!enter_box()) return;
  waiting_.push_back({});
  while (!waiting_.empty()) {
    const Stretch stretch = waiting_.back();
    waiting_.pop_back();
    if (!is_too_late(stretch)) pass(stretch, meet);
  }
}

/// A time is the fraction's place between both ends, in four roundings of numbers up to 1.
bool BspRayWalk::is_too_late(const Stretch& stretch) const {
  return enters_ + stretch.from * (leaves_ - enters_) - 0x1p-50 > latest_;
}

void BspRayWalk::pass(Stretch stretch, Meet meet) {
  while (!is_leaf(stretch.at)) {
    const BspNode& node = parts_.nodes[static_cast<std::size_t>(stretch.at)];
    const Heights along = heights(node.floats);
    if (along.certainly_above(stretch)) {
      stretch.at = node.front();
    } else if (along.certainly_below(stretch)) {
      stretch.at = node.back();
    } else {
      push_both_sides(stretch, node, along);
      for (const StoredFragment& fragment : parts_.fragments_of(stretch.at))
        latest_ = std::min(latest_, meet(fragment.triangle));
      return;
    }
  }
}

/// A place where the exact height is 0 has a computed one within the error, so it is no farther from where the computed
/// one is 0 than the error over the rise. Twice that covers the roundings of both, and 2^-48 those of a fraction.
void BspRayWalk::push_both_sides(const Stretch& stretch, const BspNode& node, const Heights& heights) {
  const bool rises = heights.rise > 0;
  Stretch near{node.child[rises ? 0 : 1], stretch.from, stretch.to};
  Stretch far{node.child[rises ? 1 : 0], stretch.from, stretch.to};
  const double crossing = -heights.start / heights.rise;
  const double off = 2 * std::fabs(heights.error / heights.rise) + 0x1p-48;
  if (off < 1 && std::fabs(crossing) < 2) {  // neither NaN
    near.to = std::min(near.to, crossing + off);
    far.from = std::max(far.from, crossing - off);
  }
  if (far.from <= far.to) waiting_.push_back(far);
  if (near.from <= near.to) waiting_.push_back(near);
}

namespace {

/// The least by (upper, triangle), as of TriangleHit.
struct EarliestTriangle {
  RayTime time;
  Index triangle = 0;
  double lower = infinity;  ///< the exact first time lies in [lower, time.upper]

  void take(const RayTime& other, Index number) {
    lower = std::min(lower, other.lower);
    if (time.hit && std::pair(other.upper, number) >= std::pair(time.upper, triangle)) return;
    time = other;
    triangle = number;
  }
};

EarliestTriangle earliest(const BspTree::Parts& parts, const PreparedRay& ray) {
  EarliestTriangle found;
  BspRayWalk(parts, ray.origin, ray.motion).run([&](Index triangle) {
    const RayTime time = ray_time(ray, parts.planes.triangle(triangle));
    if (time.hit) found.take(time, triangle);
    return found.time.hit ? found.time.upper : 1;
  });
  return found;
}

}  // namespace

RayHit BspTree::cast_ray(const Vec3& origin, const Vec3& motion) const {
  const PreparedRay ray(origin, motion);
  RayHit result;
  if (locate(origin).side == Side::inside) {
    result.hit = true;
    result.point = origin;
    return result;
  }
  const EarliestTriangle found = earliest(*parts_, ray);
  if (!found.time.hit) return result;
  static_cast<Cast&>(result) = ray_hit(ray, parts_->planes.triangle(found.triangle), found.time);
  result.lower = found.lower;
  result.element = found.triangle;
  result.face = parts_->planes.mesh().face_of(found.triangle);
  return result;
}

bool BspTree::overlap(const Vec3& from, const Vec3& to) const {
  require_finite_point(from);
  require_finite_point(to);
  if (!is_finite(to - from))
    throw Error("the ends of the segment are farther apart along an axis than the greatest double");
  if (locate(from).side != Side::outside) return true;
  if (from == to) return false;
  const PreparedRay ray(from, to - from);
  const Triangle segment{from, to, to};
  bool met = false;
  BspRayWalk(*parts_, ray.origin, ray.motion).run([&](Index triangle) {
    met = met || toccata::overlap(segment, parts_->planes.triangle(triangle));
    return met ? -infinity : 1;
  });
  return met;
}

}  // namespace toccata
