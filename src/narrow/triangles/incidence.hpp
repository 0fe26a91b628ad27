#pragma once

#include <optional>

#include "toccata/math/predicates.hpp"
#include "toccata/shapes/primitives.hpp"

namespace toccata {

// Where points, open segments and open triangles meet; exact for all finite doubles. "Open" is without the boundary.

/// orient2d of the three points seen along a coordinate axis.
[[nodiscard]] Sign orient_without(int axis, const Vec3& a, const Vec3& b, const Vec3& c);

/// An axis along which the three points are seen as a triangle with area; none when they are collinear. Seen along it,
/// the plane of the three is mapped one to one.
[[nodiscard]] std::optional<int> axis_that_shows(const Vec3& a, const Vec3& b, const Vec3& c);

[[nodiscard]] bool collinear(const Vec3& a, const Vec3& b, const Vec3& c);

[[nodiscard]] bool in_open_segment(const Vec3& x, const Vec3& p, const Vec3& q);

/// `t` has area.
[[nodiscard]] bool in_open_triangle(const Vec3& x, const Triangle& t);

/// The open segments pq and rs have one single point in common (they are not collinear).
[[nodiscard]] bool open_segments_cross(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s);

/// The open segment pq meets the open triangle in one single point (it does not lie in its plane). `t` has area.
[[nodiscard]] bool open_segment_pierces(const Vec3& p, const Vec3& q, const Triangle& t);

}  // namespace toccata
