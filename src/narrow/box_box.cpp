#include "toccata/narrow/box_box.hpp"

#include "narrow/box_manifold.hpp"
#include "narrow/canonical_order.hpp"
#include "narrow/convex_parting.hpp"

namespace toccata {
namespace {

PosedConvex as_convex(const PosedBox& box) { return PosedConvex(box.shape, box.pose); }

/// Nothing where neither centres nor first corners tell.
std::optional<bool> is_first(const PosedBox& a, const PosedBox& b) {
  if (const std::optional<bool> by_centre = is_order_of_centres(view_of(a), view_of(b))) return by_centre;
  const Vec3 p = transform(a.pose, a.shape.corner(0)), q = transform(b.pose, b.shape.corner(0));
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

bool overlap(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b) {
  const Nearness nearness = nearness_of_boxes(a, pose_a, b, pose_b);
  if (nearness != Nearness::unknown) return nearness == Nearness::meet;
  return overlap(PosedBox(a, pose_a), PosedBox(b, pose_b));
}

Penetration penetration(const PosedBox& a, const PosedBox& b) {
  if (const std::optional<bool> is_ordered = is_first(a, b)) {
    const std::optional<Penetration> found = *is_ordered ? penetration_in_order(a, b) : penetration_in_order(b, a);
    if (found) return *is_ordered ? *found : flipped(*found);
  }
  return penetration(as_convex(a), as_convex(b));
}

Manifold manifold(const PosedBox& a, const PosedBox& b) {
  const std::optional<bool> is_ordered = is_first(a, b);
  if (is_ordered && is_rigid_and_plain(view_of(a)) && is_rigid_and_plain(view_of(b))) {
    const BoxView first = view_of(*is_ordered ? a : b), second = view_of(*is_ordered ? b : a);
    RigidBoxAxes axes;
    const Nearness nearness = nearness_of_rigid_boxes(first, second, axes);
    if (nearness == Nearness::apart) return {};
    if (nearness == Nearness::meet) {
      const RigidBoxContact contact(first, second, axes);
      if (contact.has_points()) return contact.manifold(!*is_ordered);
    }
  }
  return manifold(as_convex(a), as_convex(b));
}

}  // namespace toccata
