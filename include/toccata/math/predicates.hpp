#pragma once

#include "toccata/math/vec3.hpp"

namespace toccata {

/// The sign of an exactly evaluated expression.
enum class Sign : signed char { negative = -1, zero = 0, positive = 1 };

constexpr Sign operator-(Sign s) { return static_cast<Sign>(-static_cast<int>(s)); }
constexpr Sign operator*(Sign a, Sign b) { return static_cast<Sign>(static_cast<int>(a) * static_cast<int>(b)); }

struct Vec2 {
  double x = 0;
  double y = 0;
  friend constexpr bool operator==(const Vec2&, const Vec2&) = default;
};

/// `v` without its coordinate `axis`, the other two in cyclic order: axis 0 → (y, z), 1 → (z, x), 2 → (x, y).
/// A counter-clockwise triangle seen against the dropped axis stays counter-clockwise.
constexpr Vec2 drop_axis(const Vec3& v, int axis) { return {v[(axis + 1) % 3], v[(axis + 2) % 3]}; }

/// The vector head − tail, as two points: the exact difference need not be a double.
struct Difference {
  Vec3 head;
  Vec3 tail;
};

// All signs below are exact for every finite double, under- and overflow included, in a program that keeps denormals.
// Filter and expansion stages after J. R. Shewchuk, "Adaptive precision floating-point arithmetic and fast robust
// geometric predicates", 1997.

/// Sign of (b − a) × (c − a): positive when a, b, c turn counter-clockwise.
[[nodiscard]] Sign orient2d(const Vec2& a, const Vec2& b, const Vec2& c);

/// Sign of ((b − a) × (c − a)) · (d − a): positive when d lies on the side to which the normal of a, b, c points, that
/// is, from d the three turn counter-clockwise. (Shewchuk's orient3d has the opposite sign.)
[[nodiscard]] Sign orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Sign of the determinant of the three differences, (u × v) · w.
[[nodiscard]] Sign triple_product_sign(const Difference& u, const Difference& v, const Difference& w);

}  // namespace toccata
