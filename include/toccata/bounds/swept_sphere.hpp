#pragma once

#include <array>
#include <cstddef>

#include "toccata/bounds/volume.hpp"
#include "toccata/math/mat3.hpp"

namespace toccata {

/// What a ball covers as its centre moves over a core: a point (dimension 0), a segment (1) or a rectangle (2). The
/// core is all centre + Σ s_i · axis_i with |s_i| ≤ half_i over the first `dimension` rows of `axes`, in real numbers;
/// these are of unit length and at right angles to within 2⁻⁴⁶. Empty while the radius is negative. (E. Larsen, S.
/// Gottschalk, M. C. Lin, D. Manocha, "Fast proximity queries with swept sphere volumes", 1999.)
template <std::size_t dimension>
struct SweptSphere {
  static constexpr std::string_view name = dimension == 0 ? "pss" : dimension == 1 ? "lss" : "rss";
  static constexpr double microseconds = dimension == 0 ? 1 : 3;

  Vec3 centre;
  Mat3 axes;
  std::array<double, dimension> half{};
  double radius = -1;
  friend constexpr bool operator==(const SweptSphere&, const SweptSphere&) = default;
};

using Pss = SweptSphere<0>;  ///< point-swept sphere
using Lss = SweptSphere<1>;  ///< line-swept sphere, a capsule
using Rss = SweptSphere<2>;  ///< rectangle-swept sphere

// The core lies along the longer principal axes, shortened by what the round ends cover; of a few lengths that of the
// least surface. The radius is measured from the core: every point is inside. The point of a Pss is the centre of the
// smallest ball.
template <>
Pss fit<Pss>(std::span<const Vec3> points);
template <>
Lss fit<Lss>(std::span<const Vec3> points);
template <>
Rss fit<Rss>(std::span<const Vec3> points);
template <>
Pss fit<Pss>(std::span<const Triangle> triangles);
template <>
Lss fit<Lss>(std::span<const Triangle> triangles);
template <>
Rss fit<Rss>(std::span<const Triangle> triangles);

template <std::size_t dimension>
[[nodiscard]] constexpr bool is_empty(const SweptSphere<dimension>& v) {
  return v.radius < 0;
}
template <std::size_t dimension>
[[nodiscard]] double support_bound(const SweptSphere<dimension>& v, const Vec3& direction, const Vec3& from);
template <std::size_t dimension>
[[nodiscard]] Vec3 farthest_point(const SweptSphere<dimension>& v, const Vec3& direction);
template <std::size_t dimension>
[[nodiscard]] Vec3 middle(const SweptSphere<dimension>& v) {
  return v.centre;
}

/// A core along the principal axes of the corners of both cores.
template <std::size_t dimension>
[[nodiscard]] SweptSphere<dimension> merge(const SweptSphere<dimension>& a, const SweptSphere<dimension>& b);
template <std::size_t dimension>
[[nodiscard]] bool contains(const SweptSphere<dimension>& v, const Vec3& point);
/// A rotation turns it as it is, but for rounding; the radius grows by what the pose can stretch.
template <std::size_t dimension>
[[nodiscard]] SweptSphere<dimension> posed(const SweptSphere<dimension>& v, const Pose& pose);
template <std::size_t dimension>
[[nodiscard]] Aabb box_around(const SweptSphere<dimension>& v);
template <std::size_t dimension>
[[nodiscard]] double measure(const SweptSphere<dimension>& v);
template <std::size_t dimension>
[[nodiscard]] double surface_area(const SweptSphere<dimension>& v);
template <std::size_t dimension>
[[nodiscard]] double half_area(const SweptSphere<dimension>& v);
template <std::size_t dimension>
[[nodiscard]] RoundVolume round_volume(const SweptSphere<dimension>& v) {
  const double r = v.radius;
  RoundVolume round{v.centre, {}, {r * v.axes[0], r * v.axes[1], r * v.axes[2]}};
  for (std::size_t i = 0; i < dimension; ++i) round.core[i] = v.half[i] * v.axes[static_cast<int>(i)];
  return round;
}

/// A closed box of the plane, given by its corner of least coordinates and its size, which is not negative. That is the
/// upper left corner where y points downwards. Where y points upwards, {x, -y, width, height} is the mirror image of
/// the box with the upper left corner (x, y), and mirror images overlap as the boxes do.
struct Rectangle {
  double x = 0;
  double y = 0;
  double width = 0;
  double height = 0;
};

/// start + length ≥ end, exactly: the sum is rounded, and where that hides the answer its error decides (D. E. Knuth,
/// "The Art of Computer Programming", volume 2, section 4.2.2).
[[nodiscard]] constexpr bool reaches(double start, double length, double end) {
  const double sum = start + length;
  if (sum != end) return sum > end;
  const double length_part = sum - start, start_part = sum - length_part;
  return (start - start_part) + (length - length_part) >= 0;
}

/// The rectangles have a point in common, touching included. Exact, though the far corners need not be doubles.
[[nodiscard]] constexpr bool overlap(const Rectangle& a, const Rectangle& b) {
  return reaches(a.x, a.width, b.x) && reaches(b.x, b.width, a.x) && reaches(a.y, a.height, b.y) &&
         reaches(b.y, b.height, a.y);
}

}  // namespace toccata
