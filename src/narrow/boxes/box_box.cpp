#include "toccata/narrow/box_box.hpp"

#include <array>

#include "narrow/boxes/box_manifold.hpp"
#include "narrow/convex/canonical_order.hpp"
#include "narrow/convex/convex_separation.hpp"

namespace toccata {
namespace {

/// A box as it was given, and as the axes see it.
struct GivenBox {
  const Box& shape;
  const Pose& pose;
  BoxView view;

  [[nodiscard]] PosedPolytope as_convex() const { return PosedPolytope(shape, pose); }
};

GivenBox given(const PosedBox& box) { return {box.shape, box.pose, view_of(box)}; }

/// Nothing where neither centres nor first corners tell.
std::optional<bool> is_first(const GivenBox& a, const GivenBox& b) {
  if (const std::optional<bool> by_centre = is_order_of_centres(a.view, b.view)) return by_centre;
  const Vec3 p = transform(a.pose, a.shape.corner(0)), q = transform(b.pose, b.shape.corner(0));
  if (p == q) return {};
  return lexicographically_less(p, q);
}

/// In canonical order.
std::optional<Penetration> formula_depth(const GivenBox& a, const GivenBox& b) {
  OverlappingBoxes found;
  if (const std::optional<CoreSeparation> core = part_rigid_boxes(a.view, b.view, 0, found))
    return offset_outward(*core, 0, 0);
  if (found.nearness != Nearness::meet) return {};
  return penetration_of_close_boxes(a.as_convex(), b.as_convex(), found);
}

Penetration penetration_of(const GivenBox& a, const GivenBox& b) {
  if (const std::optional<bool> is_ordered = is_first(a, b)) {
    const std::optional<Penetration> found = *is_ordered ? formula_depth(a, b) : formula_depth(b, a);
    if (found) return *is_ordered ? *found : flipped(*found);
  }
  return penetration(a.as_convex(), b.as_convex());
}

Manifold manifold_of(const GivenBox& a, const GivenBox& b) {
  const std::optional<bool> is_ordered = is_first(a, b);
  if (is_ordered && is_rigid_and_plain(a.view) && is_rigid_and_plain(b.view)) {
    const std::array<BoxView, 2> both = {a.view, b.view};  // which is first cannot be guessed
    const BoxView &first = both[*is_ordered ? 0 : 1], &second = both[*is_ordered ? 1 : 0];
    RigidBoxAxes axes;
    const Nearness nearness = nearness_of_rigid_boxes(first, second, axes);
    if (nearness == Nearness::apart) return {};
    if (nearness == Nearness::meet) {
      const RigidBoxContact contact(first, second, axes);
      if (contact.has_points()) return contact.manifold(!*is_ordered);
    }
  }
  return manifold(a.as_convex(), b.as_convex());
}

}  // namespace

bool overlap(const PosedBox& a, const PosedBox& b) {
  const Nearness nearness = nearness_of_rigid_boxes(view_of(a), view_of(b));
  if (nearness != Nearness::unknown) return nearness == Nearness::meet;
  return overlap(given(a).as_convex(), given(b).as_convex());
}

Penetration penetration(const PosedBox& a, const PosedBox& b) { return penetration_of(given(a), given(b)); }

Manifold manifold(const PosedBox& a, const PosedBox& b) { return manifold_of(given(a), given(b)); }

bool overlap(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b) {
  const Nearness nearness = nearness_of_boxes(a, pose_a, b, pose_b);
  if (nearness != Nearness::unknown) return nearness == Nearness::meet;
  return overlap(PosedPolytope(a, pose_a), PosedPolytope(b, pose_b));
}

// What is not rigid, not finite or too big has no slack, and is refused or answered by the general way.

Penetration penetration(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b) {
  const RigidBox rigid_a = rigid_box(a, pose_a), rigid_b = rigid_box(b, pose_b);
  return penetration_of({a, pose_a, {&pose_a.linear, &rigid_a}}, {b, pose_b, {&pose_b.linear, &rigid_b}});
}

Manifold manifold(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b) {
  const RigidBox rigid_a = rigid_box(a, pose_a), rigid_b = rigid_box(b, pose_b);
  return manifold_of({a, pose_a, {&pose_a.linear, &rigid_a}}, {b, pose_b, {&pose_b.linear, &rigid_b}});
}

}  // namespace toccata
