#include "narrow/quadrics/distance/quadric_beyond.hpp"

#include <algorithm>
#include <cmath>

#include "math/vec3_measures.hpp"
#include "narrow/quadrics/distance/fast_pair.hpp"

namespace toccata {
namespace {

/// In the shape's frame, where it has the size 1: much more than rounding, and than an interval is wide.
constexpr double well_beyond = 0x1p-30;

}  // namespace

QuadricBeyond::QuadricBeyond(const PosedQuadric& shape)
    : frame_(pair_frame(shape, shape)), body_(shape, frame_), is_fast_(is_fast(shape, shape, frame_)) {}

void QuadricBeyond::look_along(const Vec3& direction) {
  const Vec3 unit = (1 - 0x1p-50) * unit_or_zero(direction);
  if (is_fast_ && unit != Vec3{}) planes_[count_++ % planes_.size()] = {unit, body_.height_at_most(unit)};
}

bool QuadricBeyond::is_beyond(const std::array<Vec3, 3>& corner, double length) const {
  const Vec3 p = frame_.plainly_placed(corner[0]), q = frame_.plainly_placed(corner[1]),
             r = frame_.plainly_placed(corner[2]);
  const double greatest = std::max({1.0, largest_magnitude(p), largest_magnitude(q), largest_magnitude(r)});
  const double enough = (1 + well_beyond) * (frame_.factor * length) + well_beyond * greatest;
  const std::size_t kept = std::min(count_, planes_.size());
  return std::any_of(planes_.begin(), planes_.begin() + kept, [&](const Plane& plane) {
    const Vec3& d = plane.direction;
    // Asked so that NaN tells nothing.
    return std::min({dot(d, p), dot(d, q), dot(d, r)}) - plane.height > enough;
  });
}

}  // namespace toccata
