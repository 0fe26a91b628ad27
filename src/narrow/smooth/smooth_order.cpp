#include "narrow/smooth/smooth_order.hpp"

#include <utility>

namespace toccata {

bool comes_before(const PosedSmooth& a, const PosedSmooth& b) {
  if (a.kind() != b.kind()) return a.kind() < b.kind();
  if (!(a.half() == b.half())) return lexicographically_less(a.half(), b.half());
  return a.pose().numbers() < b.pose().numbers();
}

Distance exchanged(const Distance& d) {
  Distance result = d;
  std::swap(result.on_a, result.on_b);
  return result;
}

Relation exchanged(const Relation& r) {
  Relation result = r;
  std::swap(result.a_solid, result.b_solid);
  if (r.containment == Containment::a_in_b) result.containment = Containment::b_in_a;
  if (r.containment == Containment::b_in_a) result.containment = Containment::a_in_b;
  return result;
}

Penetration exchanged(const Penetration& p) {
  Penetration result = p;
  std::swap(result.on_a, result.on_b);
  result.direction = -p.direction;
  return result;
}

}  // namespace toccata
