#pragma once

#include <limits>
#include <span>

#include "toccata/math/vec3.hpp"

namespace toccata {

/// An axis-aligned box, closed. Empty until something is merged into it. Fit and merge are exact (minima and maxima).
struct Aabb {
  Vec3 lower{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
             std::numeric_limits<double>::infinity()};
  Vec3 upper{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
             -std::numeric_limits<double>::infinity()};

  friend constexpr bool operator==(const Aabb&, const Aabb&) = default;
};

[[nodiscard]] constexpr bool is_empty(const Aabb& box) { return !(box.lower.x <= box.upper.x); }

[[nodiscard]] Aabb fit_aabb(std::span<const Vec3> points);
[[nodiscard]] Aabb merge(const Aabb& a, const Aabb& b);
[[nodiscard]] Aabb merge(const Aabb& a, const Vec3& point);

/// The closed boxes have a point in common; compares the corner coordinates, so it is exact.
[[nodiscard]] constexpr bool overlap(const Aabb& a, const Aabb& b) {
  return a.lower.x <= b.upper.x && b.lower.x <= a.upper.x && a.lower.y <= b.upper.y && b.lower.y <= a.upper.y &&
         a.lower.z <= b.upper.z && b.lower.z <= a.upper.z;
}

[[nodiscard]] constexpr bool contains(const Aabb& outer, const Aabb& inner) {
  return outer.lower.x <= inner.lower.x && inner.upper.x <= outer.upper.x && outer.lower.y <= inner.lower.y &&
         inner.upper.y <= outer.upper.y && outer.lower.z <= inner.lower.z && inner.upper.z <= outer.upper.z;
}

/// Half the area of its sides, rounded: the size that decides what to split. 0 for an empty box; +∞ when too large.
[[nodiscard]] double half_area(const Aabb& box);

}  // namespace toccata
