#pragma once

#include <array>
#include <concepts>
#include <span>
#include <string_view>

#include "toccata/bounds/aabb.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/math/vec3.hpp"
#include "toccata/shapes/primitives.hpp"

// What every bounding volume answers. All of them are closed, convex and empty until something is put in; every answer
// is on the safe side of the truth, whatever rounding does (docs/design/volumes.md has the proof):
//
//  - contains(v, p): the point is inside, proved. True for everything that v was fitted to or merged from.
//  - overlap(a, b): false is proved. True may also be said of volumes that are apart by a rounding error, or, where the
//    header of the volume says so, by more.
//  - gap(a, b): a lower bound of the distance; 0 when they may meet, +∞ when one is empty.
//  - sweep_entry(a, motion, b): a lower bound of the first t ≥ 0 at which a, moved by t · motion, meets b; +∞ is
//    proved.
//  - posed(v, pose): contains the world vertex (docs/truth.md) of every point of v, under any finite pose.
//
// No answer is ever NaN. Where numbers overflow, the answer is the safe one, and a volume becomes one of infinite size
// around the origin, that holds everything.
namespace toccata {

/// The tightest Volume this library knows to make around points, in their units. No points: an empty volume. Throws
/// Error naming the point when a coordinate is not finite or of magnitude above 2^1000.
template <class Volume>
[[nodiscard]] Volume fit(std::span<const Vec3> points);

/// The same around triangles. Where directions have to be chosen, every piece of surface counts alike, and not every
/// vertex (principal_axes.hpp).
template <class Volume>
[[nodiscard]] Volume fit(std::span<const Triangle> triangles);

template <>
Aabb fit<Aabb>(std::span<const Vec3> points);
template <>
Aabb fit<Aabb>(std::span<const Triangle> triangles);

/// A point, where a volume is asked for.
struct PointVolume {
  Vec3 position;
};

/// What a question about a convex set needs to know of it.
///  - support_bound(v, direction, from): no point x of v has a greater (x − from) · direction; −∞ when v is empty.
///  - farthest_point(v, direction): a point of v, but for rounding, where that is greatest; v is not empty.
///  - middle(v): a point near the middle of v.
template <class V>
concept SupportedVolume = requires(const V& v, const Vec3& x) {
  { is_empty(v) } -> std::same_as<bool>;
  { support_bound(v, x, x) } -> std::same_as<double>;
  { farthest_point(v, x) } -> std::same_as<Vec3>;
  { middle(v) } -> std::same_as<Vec3>;
};

/// The overload set of a volume. `measure` and `surface_area` are its volume and surface, rounded; `half_area` is half
/// the latter, by which walks and builders compare sizes.
template <class V>
concept BoundingVolume = SupportedVolume<V> && std::default_initializable<V> && std::copyable<V> &&
    requires(const V& v, const Vec3& x, const Pose& pose) {
  { merge(v, v) } -> std::same_as<V>;
  { contains(v, x) } -> std::same_as<bool>;
  { overlap(v, v) } -> std::same_as<bool>;
  { gap(v, v) } -> std::same_as<double>;
  { gap(v, PointVolume{x}) } -> std::same_as<double>;
  { sweep_entry(v, x, v) } -> std::same_as<double>;
  { ray_entry(x, x, v) } -> std::same_as<double>;
  { posed(v, pose) } -> std::same_as<V>;
  { box_around(v) } -> std::same_as<Aabb>;
  { measure(v) } -> std::same_as<double>;
  { surface_area(v) } -> std::same_as<double>;
  { half_area(v) } -> std::same_as<double>;
};

/// A volume with a round surface, as what it is: all centre ± core₀ ± core₁ + Σ d_i · axis_i with |d| = 1, and what
/// lies between. Balls have no core, ellipsoids none and axes of several lengths, swept spheres one or two. It is what
/// `round_volume(v)` makes of a round volume, for pictures.
struct RoundVolume {
  Vec3 centre;
  std::array<Vec3, 2> core{};
  std::array<Vec3, 3> axis;
};

/// Two volumes of one type, or a volume and a point. Other pairs do not compile.
template <class A, class B>
concept VolumePair = SupportedVolume<A> && SupportedVolume<B> &&
    ((std::same_as<A, B> && !std::same_as<A, PointVolume>) ||
     std::same_as<A, PointVolume> != std::same_as<B, PointVolume>);

template <class A, class B>
requires VolumePair<A, B>
[[nodiscard]] double gap(const A& a, const B& b);
template <class A, class B>
requires VolumePair<A, B>
[[nodiscard]] bool overlap(const A& a, const B& b);
template <class A, class B>
requires VolumePair<A, B>
[[nodiscard]] double sweep_entry(const A& a, const Vec3& motion, const B& b);

/// A lower bound of the first t ≥ 0 at which origin + t · direction is in the volume; +∞ is proved.
template <SupportedVolume V>
[[nodiscard]] double ray_entry(const Vec3& origin, const Vec3& direction, const V& volume) {
  return sweep_entry(PointVolume{origin}, direction, volume);
}

// A point and the axis-aligned box as volumes.

[[nodiscard]] constexpr bool is_empty(const PointVolume&) { return false; }
[[nodiscard]] double support_bound(const PointVolume& point, const Vec3& direction, const Vec3& from);
[[nodiscard]] inline Vec3 farthest_point(const PointVolume& point, const Vec3&) { return point.position; }
[[nodiscard]] inline Vec3 middle(const PointVolume& point) { return point.position; }
[[nodiscard]] inline Aabb box_around(const PointVolume& point) { return {point.position, point.position}; }

[[nodiscard]] double support_bound(const Aabb& box, const Vec3& direction, const Vec3& from);
[[nodiscard]] Vec3 farthest_point(const Aabb& box, const Vec3& direction);
[[nodiscard]] Vec3 middle(const Aabb& box);
[[nodiscard]] bool contains(const Aabb& box, const Vec3& point);
/// The box around the rotated box, and not around what is in it: it grows with every turn (docs/methods).
[[nodiscard]] Aabb posed(const Aabb& box, const Pose& pose);
[[nodiscard]] inline Aabb box_around(const Aabb& box) { return box; }
[[nodiscard]] double measure(const Aabb& box);
[[nodiscard]] double surface_area(const Aabb& box);

/// Do the closed box and the closed triangle have a point in common? Exact for all finite doubles, for boxes that are
/// flat and triangles without area too: the separating axes of both, with exact signs (T. Akenine-Möller, "Fast 3D
/// triangle-box overlap testing", 2001, decides the same by rounded numbers). An empty box meets nothing.
[[nodiscard]] bool overlap(const Aabb& box, const Triangle& triangle);

}  // namespace toccata
