#include "motion/item_contact.hpp"

#include <type_traits>
#include <utility>
#include <variant>

#include "motion/convex_pair_in_time.hpp"

namespace toccata {
namespace {

/// The convex set that an item is, of the type that it is known to have.
template <PosedConvexSet S>
S posed_item(const MovingPart& part, Index item, double time) {
  if constexpr (std::is_same_v<S, PosedPolytope>) {
    if (part.shape().has_mesh()) {
      const Pose pose = part.pose_at(time);
      const auto& corner = part.shape().mesh().triangles()[item];
      const std::span<const Vec3> vertices = part.shape().mesh().vertices();
      return PosedPolytope(Triangle{{transform(pose, vertices[corner[0]]), transform(pose, vertices[corner[1]]),
                                     transform(pose, vertices[corner[2]])}});
    }
  }
  return part.convex_at<S>(time);
}

/// Calls `use` with the type of the posed items.
template <class Use>
auto with_item_type(const MovingPart& part, const Use& use) {
  if (part.is_half_space()) return use(std::type_identity<PosedHalfSpace>{});
  if (is_quadric(part.kind())) return use(std::type_identity<PosedQuadric>{});
  return use(std::type_identity<PosedPolytope>{});
}

/// Calls `use` with the types of both; two half-spaces are refused before.
template <class Use>
auto with_item_types(const MovingPart& a, const MovingPart& b, const Use& use) {
  return with_item_type(a, [&](auto type_a) {
    return with_item_type(b, [&](auto type_b) {
      using A = typename decltype(type_a)::type;
      using B = typename decltype(type_b)::type;
      if constexpr (std::is_same_v<A, PosedHalfSpace> && std::is_same_v<B, PosedHalfSpace>)
        return use(type_a, std::type_identity<PosedPolytope>{});
      else
        return use(type_a, std::type_identity<B>{});
    });
  });
}

}  // namespace

std::optional<FirstContact> item_contact(const MovingPart& a, Index item_a, const MovingPart& b, Index item_b,
                                         const TimeStretch& stretch, const GapBounds& bounds, double stop_before) {
  return with_item_types(a, b, [&]<class A, class B>(std::type_identity<A>, std::type_identity<B>) {
    const auto a_at = [&](double time) { return posed_item<A>(a, item_a, time); };
    const auto b_at = [&](double time) { return posed_item<B>(b, item_b, time); };
    ConvexPairInTime<A, B> pair(a_at, b_at, bounds.pad, stop_before);
    return first_contact(pair, stretch, bounds);
  });
}

Vec3 item_point_on_b(const MovingPart& a, Index item_a, const MovingPart& b, Index item_b, double time) {
  return with_item_types(a, b, [&]<class A, class B>(std::type_identity<A>, std::type_identity<B>) {
    const PlacedSet<A> at_a([&] { return posed_item<A>(a, item_a, time); });
    const PlacedSet<B> at_b([&] { return posed_item<B>(b, item_b, time); });
    VertexPairs kept;
    return nearest_on_b(at_a, at_b, kept);
  });
}

}  // namespace toccata
