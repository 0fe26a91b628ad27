#pragma once

#include "toccata/bounds/volume.hpp"
#include "toccata/math/mat3.hpp"

namespace toccata {

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

}  // namespace toccata
