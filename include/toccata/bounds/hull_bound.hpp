#pragma once

#include <optional>

#include "toccata/bounds/volume.hpp"
#include "toccata/shapes/convex_hull.hpp"

namespace toccata {

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
/// Of the hull, without the margin.
[[nodiscard]] double measure(const HullBound& v);
[[nodiscard]] double surface_area(const HullBound& v);
[[nodiscard]] double half_area(const HullBound& v);

/// The volume that a hull encloses, and its surface (of a flat one both sides), rounded.
[[nodiscard]] double measure(const ConvexHull& hull);
[[nodiscard]] double surface_area(const ConvexHull& hull);

}  // namespace toccata
