#include "narrow/convex/canonical_order.hpp"

#include <algorithm>
#include <utility>

namespace toccata {

bool is_canonical_order(const PosedConvex& a, const PosedConvex& b) {
  if (a.vertex_count() != b.vertex_count()) return a.vertex_count() > b.vertex_count();
  for (Index i = 0; i < a.vertex_count(); ++i) {
    const Vec3 p = a.vertex(i), q = b.vertex(i);
    if (p != q) return lexicographically_less(p, q);
  }
  return a.radius() <= b.radius();
}

Penetration flipped(const Penetration& penetration) {
  Penetration result = penetration;
  result.direction = -penetration.direction;
  std::swap(result.on_a, result.on_b);
  return result;
}

Manifold flipped(const Manifold& manifold) {
  Manifold result = manifold;
  result.normal = -manifold.normal;
  for (ManifoldPoint& point : result.points) std::swap(point.on_a, point.on_b);
  return result;
}

}  // namespace toccata
