#include "toccata/narrow/box_box.hpp"

#include "narrow/box_contact.hpp"
#include "narrow/canonical_order.hpp"
#include "narrow/convex_parting.hpp"

namespace toccata {
namespace {

PosedConvex as_convex(const PosedBox& box) { return PosedConvex(box.shape, box.pose); }

Vec3 first_corner(const PosedBox& box) { return transform(box.pose, box.shape.corner(0)); }

/// The order of canonical_order.hpp; nothing where the first corners do not tell.
std::optional<bool> is_canonical_order(const PosedBox& a, const PosedBox& b) {
  const Vec3 p = first_corner(a), q = first_corner(b);
  if (p == q) return {};
  return lexicographically_less(p, q);
}

std::optional<Manifold> manifold_in_order(const PosedBox& a, const PosedBox& b) {
  if (!is_rigid_and_plain(view_of(a)) || !is_rigid_and_plain(view_of(b))) return {};
  RigidBoxAxes axes;
  const Nearness nearness = nearness_of_rigid_boxes(view_of(a), view_of(b), axes);
  if (nearness == Nearness::apart) return Manifold{};
  if (nearness == Nearness::unknown) return {};
  const Manifold manifold = manifold_of_rigid_boxes(view_of(a), view_of(b), axes);
  if (manifold.count == 0) return {};
  return manifold;
}

std::optional<Penetration> penetration_in_order(const PosedBox& a, const PosedBox& b) {
  const std::optional<CoreParting> core = part_rigid_boxes(view_of(a), view_of(b), 0);
  if (!core) return {};
  return grown(*core, 0, 0);
}

/// The answer of `in_order`, which may be nothing, for both orders.
template <class InOrder>
auto exchanged_if_needed(const PosedBox& a, const PosedBox& b, const InOrder& in_order) {
  const std::optional<bool> is_ordered = is_canonical_order(a, b);
  if (!is_ordered) return decltype(in_order(a, b)){};
  if (*is_ordered) return in_order(a, b);
  auto answer = in_order(b, a);
  if (answer) *answer = flipped(*answer);
  return answer;
}

}  // namespace

bool overlap(const PosedBox& a, const PosedBox& b) {
  const Nearness nearness = nearness_of_rigid_boxes(view_of(a), view_of(b));
  if (nearness != Nearness::unknown) return nearness == Nearness::meet;
  return overlap(as_convex(a), as_convex(b));
}

Penetration penetration(const PosedBox& a, const PosedBox& b) {
  const auto answer = exchanged_if_needed(a, b, penetration_in_order);
  return answer ? *answer : penetration(as_convex(a), as_convex(b));
}

Manifold manifold(const PosedBox& a, const PosedBox& b) {
  const auto answer = exchanged_if_needed(a, b, manifold_in_order);
  return answer ? *answer : manifold(as_convex(a), as_convex(b));
}

}  // namespace toccata
