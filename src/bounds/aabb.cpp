#include "toccata/bounds/aabb.hpp"

#include <algorithm>

namespace toccata {

Aabb merge(const Aabb& a, const Vec3& p) {
  return {{std::min(a.lower.x, p.x), std::min(a.lower.y, p.y), std::min(a.lower.z, p.z)},
          {std::max(a.upper.x, p.x), std::max(a.upper.y, p.y), std::max(a.upper.z, p.z)}};
}

Aabb merge(const Aabb& a, const Aabb& b) { return is_empty(b) ? a : merge(merge(a, b.lower), b.upper); }

double half_area(const Aabb& box) {
  if (is_empty(box)) return 0;
  const Vec3 size = box.upper - box.lower;
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

Aabb fit_aabb(std::span<const Vec3> points) {
  Aabb box;
  for (const Vec3& p : points) box = merge(box, p);
  return box;
}

}  // namespace toccata
