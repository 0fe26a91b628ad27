#include "io/display_frame.hpp"

#include <algorithm>
#include <cmath>

namespace toccata::io {

DisplayFrame DisplayFrame::around(const Aabb& box) {
  if (is_empty(box)) return {};
  // Halved before they are added or subtracted: the whole could overflow.
  const Vec3 half_lower = 0.5 * box.lower, half_upper = 0.5 * box.upper;
  const Vec3 half = half_upper - half_lower;
  const double size = std::max({half.x, half.y, half.z});
  return {half_lower + half_upper, std::isnormal(size) ? size : 1};
}

std::array<float, 3> DisplayFrame::shown(const Vec3& world) const {
  const Vec3 from_centre = world - centre;
  return {static_cast<float>(from_centre.x / size), static_cast<float>(from_centre.y / size),
          static_cast<float>(from_centre.z / size)};
}

}  // namespace toccata::io
