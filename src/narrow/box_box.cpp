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

std::optional<Penetration> penetration_in_order(const PosedBox& a, const PosedBox& b) {
  const std::optional<CoreParting> core = part_rigid_boxes(view_of(a), view_of(b), 0);
  if (!core) return {};
  return grown(*core, 0, 0);
}

}  // namespace

bool overlap(const PosedBox& a, const PosedBox& b) {
  const Nearness nearness = nearness_of_rigid_boxes(view_of(a), view_of(b));
  if (nearness != Nearness::unknown) return nearness == Nearness::meet;
  return overlap(as_convex(a), as_convex(b));
}

Penetration penetration(const PosedBox& a, const PosedBox& b) {
  if (const std::optional<bool> is_ordered = is_canonical_order(a, b)) {
    const std::optional<Penetration> found = *is_ordered ? penetration_in_order(a, b) : penetration_in_order(b, a);
    if (found) return *is_ordered ? *found : flipped(*found);
  }
  return penetration(as_convex(a), as_convex(b));
}

Manifold manifold(const PosedBox& a, const PosedBox& b) {
  if (const std::optional<bool> is_ordered = is_canonical_order(a, b)) {
    BoxManifold found =
        *is_ordered ? manifold_of_rigid_boxes(view_of(a), view_of(b)) : manifold_of_rigid_boxes(view_of(b), view_of(a));
    if (found.is_decided()) return *is_ordered ? found.manifold : flipped(found.manifold);
  }
  return manifold(as_convex(a), as_convex(b));
}

}  // namespace toccata
