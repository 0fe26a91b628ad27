#include "narrow/smooth/smooth_order.hpp"

namespace toccata {

bool comes_before(const PosedSmooth& a, const PosedSmooth& b) {
  if (a.kind() != b.kind()) return a.kind() < b.kind();
  if (!(a.half() == b.half())) return lexicographically_less(a.half(), b.half());
  return a.pose().numbers() < b.pose().numbers();
}

}  // namespace toccata
