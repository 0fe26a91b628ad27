#pragma once

#include <algorithm>
#include <limits>
#include <span>
#include <string_view>

#include "toccata/math/vec3.hpp"

namespace toccata {

/// An axis-aligned box, closed. Empty until something is merged into it. Fit and merge are exact (minima and maxima).
struct Aabb {
  static constexpr std::string_view name = "aabb";
  static constexpr double microseconds = 0.2;  ///< to update one, roughly

  Vec3 lower{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
             std::numeric_limits<double>::infinity()};
  Vec3 upper{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
             -std::numeric_limits<double>::infinity()};

  friend constexpr bool operator==(const Aabb&, const Aabb&) = default;
};

[[nodiscard]] constexpr bool is_empty(const Aabb& box) { return !(box.lower.x <= box.upper.x); }

[[nodiscard]] constexpr Aabb merge(const Aabb& a, const Vec3& point) {
  return {{std::min(a.lower.x, point.x), std::min(a.lower.y, point.y), std::min(a.lower.z, point.z)},
          {std::max(a.upper.x, point.x), std::max(a.upper.y, point.y), std::max(a.upper.z, point.z)}};
}

[[nodiscard]] constexpr Aabb merge(const Aabb& a, const Aabb& b) {
  return {{std::min(a.lower.x, b.lower.x), std::min(a.lower.y, b.lower.y), std::min(a.lower.z, b.lower.z)},
          {std::max(a.upper.x, b.upper.x), std::max(a.upper.y, b.upper.y), std::max(a.upper.z, b.upper.z)}};
}

[[nodiscard]] Aabb fit_aabb(std::span<const Vec3> points);

/// The closed boxes have a point in common; compares corners, so it is exact. True of an empty one and one without end.
[[nodiscard]] constexpr bool overlap(const Aabb& a, const Aabb& b) {
  return a.lower.x <= b.upper.x && b.lower.x <= a.upper.x && a.lower.y <= b.upper.y && b.lower.y <= a.upper.y &&
         a.lower.z <= b.upper.z && b.lower.z <= a.upper.z;
}

[[nodiscard]] constexpr bool contains(const Aabb& outer, const Aabb& inner) {
  return outer.lower.x <= inner.lower.x && inner.upper.x <= outer.upper.x && outer.lower.y <= inner.lower.y &&
         inner.upper.y <= outer.upper.y && outer.lower.z <= inner.lower.z && inner.upper.z <= outer.upper.z;
}

/// Half the area of its sides, rounded: the size that decides what to split. 0 for an empty box; +∞ when too large.
[[nodiscard]] constexpr double half_area(const Aabb& box) {
  if (is_empty(box)) return 0;
  const Vec3 size = box.upper - box.lower;
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

}  // namespace toccata
