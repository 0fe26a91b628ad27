#include "reports/view/display_frame.hpp"

#include <algorithm>
#include <cmath>

namespace toccata::io {

DisplayFrame DisplayFrame::around(const Aabb& box) {
  if (is_empty(box)) return {};
  // Halved before they are added or subtracted, as the whole could overflow; what is lost of the least doubles by that
  // is less than nothing beside what could.
  const Vec3 half_lower = 0.5 * box.lower, half_upper = 0.5 * box.upper;
  const Vec3 half = half_upper - half_lower;
  const Vec3 whole = box.upper - box.lower;
  const double size = std::max({half.x, half.y, half.z});
  const double least = std::max({whole.x, whole.y, whole.z});  // 2⁻¹⁰⁷⁴ has no half
  return {half_lower + half_upper, size > 0 ? size : least > 0 ? least : 1};
}

std::array<float, 3> DisplayFrame::shown(const Vec3& world) const {
  const Vec3 from_centre = world - centre;
  return {static_cast<float>(from_centre.x / size), static_cast<float>(from_centre.y / size),
          static_cast<float>(from_centre.z / size)};
}

}  // namespace toccata::io
