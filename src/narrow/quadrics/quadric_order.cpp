#include "narrow/quadrics/quadric_order.hpp"

namespace toccata {

bool comes_before(const PosedQuadric& a, const PosedQuadric& b) {
  if (a.kind() != b.kind()) return a.kind() < b.kind();
  if (!(a.half() == b.half())) return lexicographically_less(a.half(), b.half());
  return a.pose().numbers() < b.pose().numbers();
}

}  // namespace toccata
