#pragma once

#include <concepts>
#include <cstddef>

#include "narrow/quadrics/kinds/cone.hpp"
#include "narrow/quadrics/kinds/cylinder.hpp"
#include "narrow/quadrics/kinds/ellipsoid.hpp"
#include "toccata/narrow/quadrics.hpp"

// What is known of each kind of quadric lies in a file of its own here, and everything else asks for it.
namespace toccata {

/// What is told of the kind of a `Shape`. Coordinates u are along the half axes, from the middle; d, volume and row are
/// those of UnitPlace.
///
/// As the hull of generators (PlainBody):
///  - generators, columns: how many there are, and of how many dimensions the ball that each is an image of;
///  - has_tip: the last generator is a bare point;
///  - inner_height: (0, 0, inner_height) is well within.
/// As part of a quadric between planes (UnitFrame), y₁² + y₂² + last_sign · y₃² ≤ level, seen from the tip if there is
/// one, else from the middle:
///  - caps: how many ends are flat, the lower one first;
///  - beyond_planes(at, reach): how far what reaches so far around y₃ = at lies beyond each of the planes;
///  - turn_to_normal(y): makes a point of the round side the gradient of the quadric there, exactly of the kind that it
///    has.
/// Support and containment:
///  - reach(x, y, z): how far it reaches along a direction with these products with the images of the half axes;
///  - holds_within(u): the point is certainly within.
/// By exact signs:
///  - side(place): negative within, zero on the boundary, positive outside;
///  - sign_of_least_height(middle, x, y, z): of the least height above a plane, where `middle` is that of the middle,
///    and the others are the products of the normal with the half axes;
///  - append_outward_normals(found, place): of planes that touch it at a point of its boundary;
///  - visit_places(middle, axis, visit, visit_around): calls them with the points that stand out beside the middle and
///    the ends of the axes.
/// Rays:
///  - cut(stretch, line): leaves of the stretch what lies within;
///  - round_normal(line, at): outwards, at a point of the round side, in the frame in which it is round.
template <class Kind>
concept QuadricKind = requires(double x, const UnitPlace& place, std::vector<IntegerVector>& found) {
  { Kind::generators } -> std::convertible_to<Index>;
  { Kind::columns } -> std::convertible_to<std::size_t>;
  { Kind::has_tip } -> std::convertible_to<bool>;
  { Kind::caps } -> std::convertible_to<int>;
  { Kind::last_sign } -> std::convertible_to<double>;
  { Kind::level } -> std::convertible_to<double>;
  { Kind::inner_height } -> std::convertible_to<double>;
  { Kind::reach(x, x, x) } -> std::same_as<QuadricReach>;
  { Kind::side(place) } -> std::same_as<Sign>;
  Kind::append_outward_normals(found, place);
};

/// One that is round about its third axis, between flat ends or a tip, also has closed forms:
///  - reach(across, z): as above, with the length of the first two products;
///  - radius_at(half, z), width_at(part): how wide it is at a height, and at a part of it, there as part of its radius;
///  - beyond(half, rim, round, n, z): how far it reaches beyond a point p at the height z along a direction, n of whose
///    products with the axes is the third; `round` is that of the first two with p, `rim` it with the radius added;
///  - Section: what its half plane from the axis is. foot(out, up): the nearest point to one; depth_of(out, up): how
///  far
///    that one is within, from the nearest part of the boundary, negative outside; farthest(out, up): the farthest
///    point along a direction with these parts, the first of them not negative.
template <class Kind>
concept AxialKind = QuadricKind<Kind> && requires(const typename Kind::Section& section, const Vec3& half, double x) {
  { Kind::reach(x, x) } -> std::same_as<QuadricReach>;
  { Kind::radius_at(half, x) } -> std::same_as<double>;
  { Kind::width_at(x) } -> std::same_as<double>;
  { Kind::beyond(half, x, x, x, x) } -> std::same_as<double>;
  { section.foot(x, x) } -> std::same_as<AxialFoot>;
  { section.depth_of(x, x) } -> std::same_as<double>;
  { section.farthest(x, x) } -> std::same_as<AxialFoot>;
};

template <class Kind>
concept BallKind = QuadricKind<Kind> && Kind::generators == 1 && Kind::columns == 3;

/// What the proofs of distances know (distance/fast_proof.cpp): what is round about its axis, and the image of a ball.
template <class Kind>
concept ProvedKind = AxialKind<Kind> || BallKind<Kind>;

template <ProvedKind... Kinds>
using KindList = TypeList<Kinds...>;

/// In the order of QuadricShapes: of each its kind.
using QuadricKinds = KindList<CylinderKind, ConeKind, EllipsoidKind>;

template <class... Kinds>
using ShapesOf = TypeList<typename Kinds::Shape...>;
static_assert(std::same_as<QuadricKinds::put_into<ShapesOf>, QuadricShapes>);

/// Calls `use` with the kind: the one place that chooses between them. As quick as a switch with the last as default.
template <std::size_t place = 0, class Use>
decltype(auto) with_kind(PosedQuadric::Kind kind, const Use& use) {
  if constexpr (place + 1 == QuadricKinds::size) {
    return use(QuadricKinds::At<place>{});
  } else {
    if (kind == static_cast<PosedQuadric::Kind>(place)) return use(QuadricKinds::At<place>{});
    return with_kind<place + 1>(kind, use);
  }
}

}  // namespace toccata
