#pragma once

#include "toccata/narrow/convex_convex.hpp"
#include "toccata/narrow/set_relation.hpp"

// Answers about (A, B) as the answers about (B, A).
namespace toccata {

[[nodiscard]] constexpr bool flipped(bool overlap) { return overlap; }

[[nodiscard]] constexpr Containment flipped(Containment containment) {
  if (containment == Containment::a_in_b) return Containment::b_in_a;
  if (containment == Containment::b_in_a) return Containment::a_in_b;
  return containment;
}

[[nodiscard]] constexpr Relation flipped(Relation r) {
  return {r.kind, flipped(r.containment), r.side_unresolved, r.b_solid, r.a_solid, r.status};
}

[[nodiscard]] constexpr Distance flipped(const Distance& d) {
  return {d.lower, d.upper, d.on_b, d.on_a, d.status, d.element_b, d.element_a, d.face_b, d.face_a};
}

[[nodiscard]] constexpr Penetration flipped(const Penetration& p) {
  return {p.lower, p.upper, -p.direction, p.on_b, p.on_a, p.status};
}

[[nodiscard]] constexpr Manifold flipped(Manifold m) {
  m.normal = -m.normal;
  for (ManifoldPoint& point : m.points) point = {point.position, point.depth, point.on_b, point.on_a};
  return m;
}

}  // namespace toccata
