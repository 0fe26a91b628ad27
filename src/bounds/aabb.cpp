#include "toccata/bounds/aabb.hpp"

namespace toccata {

Aabb fit_aabb(std::span<const Vec3> points) {
  Aabb box;
  for (const Vec3& p : points) box = merge(box, p);
  return box;
}

}  // namespace toccata
