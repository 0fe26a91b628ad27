#include "narrow/convex/canonical_order.hpp"

namespace toccata {

bool is_canonical_order(const PosedPolytope& a, const PosedPolytope& b) {
  if (a.vertex_count() != b.vertex_count()) return a.vertex_count() > b.vertex_count();
  for (Index i = 0; i < a.vertex_count(); ++i) {
    const Vec3 p = a.vertex(i), q = b.vertex(i);
    if (p != q) return lexicographically_less(p, q);
  }
  return a.radius() <= b.radius();
}

}  // namespace toccata
