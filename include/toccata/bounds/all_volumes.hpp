#pragma once

#include <concepts>
#include <optional>
#include <string_view>

#include "toccata/bounds/aabb.hpp"
#include "toccata/bounds/ball.hpp"
#include "toccata/bounds/kdop.hpp"
#include "toccata/bounds/obb.hpp"
#include "toccata/bounds/swept_sphere.hpp"
#include "toccata/bounds/volume.hpp"
#include "toccata/core/type_list.hpp"
#include "toccata/math/mat3.hpp"
#include "toccata/shapes/convex_hull.hpp"

// All bounding volumes, in a list at the end. Those that hierarchies alone know are declared here, each with its source
// of the same name in src/bounds; those that questions and broad phases know as well, or that answer more than every
// volume does, have headers of their own.
namespace toccata {

/// A cube along the axes: all points of which no coordinate is farther than `half` from the centre's. Empty while that
/// is negative.
struct Cube {
  static constexpr std::string_view name = "cube";
  static constexpr double microseconds = 0.2;

  Vec3 centre;
  double half = -1;
  friend constexpr bool operator==(const Cube&, const Cube&) = default;
};

/// The smallest cube, but for rounding; of those equally small the one in the middle of the box around the points.
template <>
Cube fit<Cube>(std::span<const Vec3> points);
template <>
Cube fit<Cube>(std::span<const Triangle> triangles);

[[nodiscard]] constexpr bool is_empty(const Cube& cube) { return cube.half < 0; }
[[nodiscard]] double support_bound(const Cube& cube, const Vec3& direction, const Vec3& from);
[[nodiscard]] Vec3 farthest_point(const Cube& cube, const Vec3& direction);
[[nodiscard]] inline Vec3 middle(const Cube& cube) { return cube.centre; }

[[nodiscard]] Cube merge(const Cube& a, const Cube& b);
[[nodiscard]] bool contains(const Cube& cube, const Vec3& point);
[[nodiscard]] Cube posed(const Cube& cube, const Pose& pose);
[[nodiscard]] Aabb box_around(const Cube& cube);
[[nodiscard]] double measure(const Cube& cube);
[[nodiscard]] double surface_area(const Cube& cube);
[[nodiscard]] double half_area(const Cube& cube);

/// A solid ellipsoid: all centre + Σ s_i · axis_i with Σ (s_i / half_i)² ≤ 1, in real numbers. The axes are the rows,
/// of unit length and at right angles to within 2⁻⁴⁶. No half axis is shorter than 2⁻²⁰ of the longest, unless all are
/// 0, so flat things are held with a thickness, and what is smaller than 2⁻⁹⁶⁰ with one of 2⁻⁹⁵⁵. Empty while one is
/// negative.
struct EllipsoidBound {
  static constexpr std::string_view name = "ellipsoid";
  static constexpr double microseconds = 50;

  Vec3 centre;
  Mat3 axes;
  Vec3 half{-1, -1, -1};
  friend constexpr bool operator==(const EllipsoidBound&, const EllipsoidBound&) = default;
};

/// The ellipsoid of least volume to within some per cent (L. G. Khachiyan, "Rounding of polytopes in the real number
/// model of computation", 1996). Measured anew: every point is inside.
template <>
EllipsoidBound fit<EllipsoidBound>(std::span<const Vec3> points);
template <>
EllipsoidBound fit<EllipsoidBound>(std::span<const Triangle> triangles);

[[nodiscard]] constexpr bool is_empty(const EllipsoidBound& v) { return v.half.x < 0 || v.half.y < 0 || v.half.z < 0; }
[[nodiscard]] double support_bound(const EllipsoidBound& v, const Vec3& direction, const Vec3& from);
[[nodiscard]] Vec3 farthest_point(const EllipsoidBound& v, const Vec3& direction);
[[nodiscard]] inline Vec3 middle(const EllipsoidBound& v) { return v.centre; }

/// Not the smallest: both are taken for balls where space is stretched so that they nearly are.
[[nodiscard]] EllipsoidBound merge(const EllipsoidBound& a, const EllipsoidBound& b);
[[nodiscard]] bool contains(const EllipsoidBound& v, const Vec3& point);
/// The image itself, grown by about 2⁻²⁰.
[[nodiscard]] EllipsoidBound posed(const EllipsoidBound& v, const Pose& pose);
[[nodiscard]] Aabb box_around(const EllipsoidBound& v);
[[nodiscard]] double measure(const EllipsoidBound& v);
/// To within 1.1 %: there is no closed form (K. Thomsen's approximation, 2004).
[[nodiscard]] double surface_area(const EllipsoidBound& v);
[[nodiscard]] double half_area(const EllipsoidBound& v);
[[nodiscard]] inline RoundVolume round_volume(const EllipsoidBound& v) {
  return {v.centre, {}, {v.half.x * v.axes[0], v.half.y * v.axes[1], v.half.z * v.axes[2]}};
}

/// All points within `margin` of a convex hull: the tightest convex volume there is, and the dearest. The margin is 0
/// until the volume is posed, which rounds what is inside by other amounts than the vertices. Empty without a hull.
struct HullBound {
  static constexpr std::string_view name = "hull";
  static constexpr double microseconds = 20;

  std::optional<ConvexHull> hull;
  double margin = 0;
};

/// Exact.
template <>
HullBound fit<HullBound>(std::span<const Vec3> points);
template <>
HullBound fit<HullBound>(std::span<const Triangle> triangles);

[[nodiscard]] inline bool is_empty(const HullBound& v) { return !v.hull; }
[[nodiscard]] double support_bound(const HullBound& v, const Vec3& direction, const Vec3& from);
[[nodiscard]] Vec3 farthest_point(const HullBound& v, const Vec3& direction);
[[nodiscard]] Vec3 middle(const HullBound& v);

[[nodiscard]] HullBound merge(const HullBound& a, const HullBound& b);
/// Exact while there is no margin.
[[nodiscard]] bool contains(const HullBound& v, const Vec3& point);
/// Exact while there is no margin.
[[nodiscard]] bool overlap(const HullBound& a, const HullBound& b);
/// The distance of the hulls, less than 1e-12 of it below the truth, less the margins.
[[nodiscard]] double gap(const HullBound& a, const HullBound& b);
/// The hull of the posed vertices. The pose may flatten it.
[[nodiscard]] HullBound posed(const HullBound& v, const Pose& pose);
[[nodiscard]] Aabb box_around(const HullBound& v);
/// These are the volume and the areas of the hull, without the margin.
[[nodiscard]] double measure(const HullBound& v);
[[nodiscard]] double surface_area(const HullBound& v);
[[nodiscard]] double half_area(const HullBound& v);

/// The volume that a hull encloses, and its surface (of a flat one both sides), rounded.
[[nodiscard]] double measure(const ConvexHull& hull);
[[nodiscard]] double surface_area(const ConvexHull& hull);

/// A volume of the list below also says what it is called, as the command writes it, and roughly how many microseconds
/// it takes to update one, by which long measurements are planned. One with a round surface has `round_volume`, and one
/// whose corners are not the farthest along a few directions `corner_points`: so it is drawn.
template <class V>
concept ListedVolume = BoundingVolume<V> && std::convertible_to<decltype(V::name), std::string_view> &&
    std::convertible_to<decltype(V::microseconds), double>;

template <ListedVolume... Volumes>
using VolumeList = TypeList<Volumes...>;

/// Every bounding volume of the library. `toccata cost`, the pictures of hierarchies and the tests go over this list,
/// so a new volume is added here and nowhere else.
using AllVolumes =
    VolumeList<Aabb, Ball, Cube, Obb, Kdop<6>, Kdop<14>, Kdop<18>, Kdop<26>, Pss, Lss, Rss, EllipsoidBound, HullBound>;

}  // namespace toccata
