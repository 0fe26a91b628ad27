#pragma once

#include <vector>

#include "toccata/narrow/casts.hpp"
#include "toccata/narrow/convex_convex.hpp"
#include "toccata/narrow/set_relation.hpp"
#include "toccata/query/contacts.hpp"

// Every answer about (A, B) as the answer about (B, A).
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

[[nodiscard]] inline Contact flipped(const Contact& c) {
  return {c.triangle_b, c.triangle_a, c.face_b, c.face_a, flipped(c.meeting)};
}

/// In their order; sort them anew.
[[nodiscard]] inline std::vector<Contact> flipped(std::vector<Contact> contacts) {
  for (Contact& contact : contacts) contact = flipped(contact);
  return contacts;
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
