#include "toccata/narrow/quadrics.hpp"

#include <algorithm>
#include <cmath>

#include "math/vec3_measures.hpp"
#include "narrow/contact/four_points.hpp"
#include "narrow/contact/manifold_along.hpp"
#include "narrow/convex/canonical_order.hpp"
#include "narrow/convex/contact_choices.hpp"
#include "narrow/quadrics/contact/patch_overlap.hpp"
#include "narrow/quadrics/contact/quadric_separation.hpp"
#include "narrow/quadrics/distance/fast_pair.hpp"
#include "narrow/quadrics/quadric_order.hpp"

// Both shapes have a patch along the normal: a face, a line or a point. What the patches have in common, seen along it,
// is the region of contact, and up to four points of its boundary stand for it.
namespace toccata {
namespace {

/// Points are as deep as each other within this, in a pair of size 1.
constexpr double same_depth = 0x1p-40;

using CommonPoints = std::pmr::vector<CommonPoint>;
using seen_along_normal::deepest_of, seen_along_normal::greatest_depth, seen_along_normal::squared_span;

/// The points of a contact in its frame, of two patches. Along the normal the shapes are as deep as `separation` tells.
CommonPoints chosen_points(const ContactPatch& a, const ContactPatch& b, double depth,
                           std::pmr::memory_resource& memory) {
  CommonPoints points = common_points(a, b, memory);
  for (CommonPoint& p : points) p.depth = std::fmin(p.depth, depth);
  if (!points.empty()) {
    const double gap = gap_of_resting * std::sqrt(squared_span(points, points[deepest_of(points, same_depth)].at));
    std::erase_if(points, [=](const CommonPoint& p) { return !(p.depth >= -gap); });
  }
  // Where they would touch last: all there is of a single point, and it may lie amid a contact.
  if (!(greatest_depth(points) >= depth - std::fmax(same_depth, same_part_of_depth * depth)))
    points.insert(points.begin(), {{0, 0, 0}, depth, a.whole, b.whole});
  return FourPoints(points, same_depth).taken();
}

/// A contact in the pair's frame, and what its points are made to in the world.
struct PairContact {
  const PairFrame& frame;
  ContactFrame at;
  double depth;

  [[nodiscard]] Manifold told(const CommonPoints& points) const {
    Manifold result;
    result.normal = at.z;
    for (const CommonPoint& p : points)
      result.points[static_cast<std::size_t>(result.count++)] = {frame.back(at.back(p.at)), p.depth / frame.factor,
                                                                 p.on_a, p.on_b};
    return result;
  }
};

ContactPatch patch_of_second(const PosedQuadric&, const QuadricBody& body, const PairContact& contact, const Vec3&,
                             std::pmr::memory_resource& memory) {
  return patch_of(body, contact.at, -1, memory);
}

ContactPatch patch_of_second(const PosedPolytope& shape, const QuadricBody&, const PairContact& contact,
                             const Vec3& touching, std::pmr::memory_resource& memory) {
  const PairFrame& frame = contact.frame;
  const PosedPolytope scaled = shape.scaled(std::ilogb(frame.factor));
  return patch_of(scaled, frame.factor * frame.origin, contact.at, -1, touching, memory);
}

template <class B>
Manifold manifold_of(const PosedQuadric& a, const B& b) {
  // Most of what is apart needs no contact, and the longer way may leave it undecided.
  if (contact_before_depth(a, b) == QuadricContact::apart) return {};
  const PairFrame frame = pair_frame(a, b);
  const QuadricBody body_a(a, frame), body_b(b, frame);
  std::optional<QuadricSeparation> found = separation_at_lowest_place(body_a, body_b);
  if (!found) {
    if (contact_after_depth(a, b) == QuadricContact::apart) return {};
    const QuadricNearest met = nearest_of(a, body_a, b, body_b, QuadricQuestion::meeting);
    if (met.contact == QuadricContact::apart) return {};
    found = separation_of(body_a, body_b, met);
  }
  std::array<std::byte, 8192> buffer;
  std::pmr::monotonic_buffer_resource memory(buffer.data(), buffer.size());
  const PairContact contact{frame, {found->on_a + 0.5 * (found->on_b - found->on_a), found->normal}, found->depth};
  const ContactPatch patch_a = patch_of(body_a, contact.at, 1, memory);
  const ContactPatch patch_b = patch_of_second(b, body_b, contact, found->on_b, memory);
  return contact.told(chosen_points(patch_a, patch_b, contact.depth, memory));
}

/// Whether a point lies over a triangle, seen along the normal; rounding may say either of its edges.
bool is_over(const Triangle& triangle, const Vec3& point, const Vec3& normal) {
  double least = HUGE_VAL, greatest = -HUGE_VAL;
  for (int i = 0; i < 3; ++i) {
    const Vec3& corner = triangle[i];
    const double side = dot(cross(triangle[(i + 1) % 3] - corner, point - corner), normal);
    least = std::fmin(least, side);
    greatest = std::fmax(greatest, side);
  }
  return least >= 0 || greatest <= 0;
}

Manifold manifold_over(const PosedQuadric& a, const PosedHalfSpace& b) {
  const QuadricContact how = quadric_contact(a, b);
  if (how == QuadricContact::apart) return {};
  const PairFrame frame = pair_frame(a, a);
  const QuadricBody body(a, frame);
  const Vec3 normal = -unit_or_zero(b.normal);
  const double depth = how == QuadricContact::contact ? frame.factor * penetration(a, b).upper : 0;
  const PairContact contact{frame, {body.support(normal).point - 0.5 * depth * normal, normal}, depth};
  std::array<std::byte, 8192> buffer;
  std::pmr::monotonic_buffer_resource memory(buffer.data(), buffer.size());
  ContactPatch plane(memory);
  plane.kind = ContactPatch::Kind::plane;
  plane.whole = {ConvexFeature::Kind::face, 0};
  plane.centre.z = -0.5 * depth;
  return contact.told(chosen_points(patch_of(body, contact.at, 1, memory), plane, depth, memory));
}

}  // namespace

Manifold manifold(const PosedQuadric& a, const PosedQuadric& b) {
  return comes_before(b, a) ? flipped(manifold_of(b, a)) : manifold_of(a, b);
}
Manifold manifold(const PosedQuadric& a, const PosedPolytope& b) { return manifold_of(a, b); }
Manifold manifold(const PosedPolytope& a, const PosedQuadric& b) { return flipped(manifold_of(b, a)); }
Manifold manifold(const PosedQuadric& a, const PosedHalfSpace& b) { return manifold_over(a, b); }
Manifold manifold(const PosedHalfSpace& a, const PosedQuadric& b) { return flipped(manifold_over(b, a)); }

Manifold manifold_along(const PosedQuadric& a, const PosedPolytope& triangle, const Vec3& direction) {
  const PairFrame frame = pair_frame(a, triangle);
  const QuadricBody body_a(a, frame), body_b(triangle, frame);
  const Vec3 on_a = body_a.support(direction).point, on_b = body_b.support(-direction).point;
  const double depth = dot(on_a - on_b, direction);
  const PairContact contact{frame, {on_a - 0.5 * depth * direction, direction}, depth};
  std::array<std::byte, 8192> buffer;
  std::pmr::monotonic_buffer_resource memory(buffer.data(), buffer.size());
  const ContactPatch patch_a = patch_of(body_a, contact.at, 1, memory);
  const ContactPatch patch_b = patch_of_second(triangle, body_b, contact, on_b, memory);
  CommonPoints points = common_points(patch_a, patch_b, memory);
  if (points.empty() && patch_a.kind == ContactPatch::Kind::point && patch_b.is_area()) {
    const auto corner = [&](Index i) { return frame.plainly_placed(triangle.vertex(i)); };
    if (is_over({{corner(0), corner(1), corner(2)}}, on_a, direction))
      points.push_back({{0, 0, 0}, depth, patch_a.whole, patch_b.whole});
  }
  if (points.empty()) return {};
  for (CommonPoint& p : points) p.depth = std::fmin(p.depth, depth);
  const double gap = gap_of_resting * std::sqrt(squared_span(points, points[deepest_of(points, same_depth)].at));
  std::erase_if(points, [=](const CommonPoint& p) { return !(p.depth >= -gap); });
  return points.empty() ? Manifold{} : contact.told(FourPoints(points, same_depth).taken());
}

double overlap_along(const PosedQuadric& a, const PosedPolytope& b, const Vec3& direction) {
  const PairFrame frame = pair_frame(a, b);
  const PlainBody body_a(a, frame), body_b(b, frame);
  return dot(body_a.support(direction).point - body_b.support(-direction).point, direction) / frame.factor;
}

}  // namespace toccata
