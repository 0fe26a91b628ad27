#pragma once

#include <cmath>

#include "toccata/math/predicates.hpp"

// The first stage of every predicate: the expression in plain doubles with a bound on its error. Inline, so that loops
// over triangles decide most signs without a call. Design note and references: docs/design/exact-signs.md.
namespace toccata {

/// A rounded value and what it may be off by. Where both answers are false, a later stage must decide. Overflow makes
/// the error infinite or NaN, and then both are false; that is why they compare in this direction.
struct Filtered {
  double value = 0;
  double error = 0;

  bool is_positive() const { return value > error; }
  bool is_negative() const { return value < -error; }
};

namespace filter {

// Let ε = 2^-53 and η = 2^-1075. Rounding to nearest gives fl(a ± b) = (a ± b)(1 + δ), which no underflow spoils, and
// fl(ab) = ab(1 + δ) + θ, with |δ| ≤ ε, |θ| ≤ η. A rounded difference x̃ likewise stands for x = x̃(1 + δ).
//
// Triple product. Let P be the sum of the six |x̃ỹz̃| and W the sum of the |w̃_c|. Let S be the last sum before its
// rounding, which does not change its sign. On the way from the exact determinant D to S each of the six terms meets
// three differences, two products, one difference of products and one sum: seven factors 1 + δ; and underflow adds
// 2η|w̃_c| + η for each c, times the few factors after it:
//     |S − D| ≤ ((1 + ε)^7 − 1)P + (1 + 4ε)(2W + 3)η ≤ 7.01εP + (2.01W + 3.01)η.
// The magnitude M computed below rounds at most seven times in a row and loses at most η in each of nine products, so,
// thanks to `floor` = τ ≥ 64η, M ≥ (1 − ε)^7 (P + τ(W + 1)/2). The test |fl(S)| > fl(8εM) then gives
//     |S| ≥ (1 − ε)|fl(S)| > (1 − ε)(8εM − η) ≥ 7.9εP + 3.9ετ(W + 1) − η,
// which exceeds the error, because 3.9ετ = 3.9·2^22·η. Hence D has the sign of fl(S). The bound 8ε is Shewchuk's
// 7ε + 56ε² rounded up to a power of two, so that the product with it is exact.
//
// Orientation in the plane. Three factors 1 + δ (two differences and a product) and 2η; the same argument gives 4ε.
//
// Overflow. Every intermediate value is at most its counterpart in M, rounding being monotone; so if one is infinite or
// NaN then so is M, which nothing later makes finite, and the comparison fails.
inline constexpr double triple_product_bound = 0x1p-50;
inline constexpr double orient2d_bound = 0x1p-51;
inline constexpr double floor = 0x1p-1000;

}  // namespace filter

/// u × v of rounded differences, with the sum of the magnitudes of each component's two products.
struct FilteredCross {
  Vec3 value;
  Vec3 magnitude;
};

inline FilteredCross filtered_cross(const Vec3& u, const Vec3& v) {
  const double yz = u.y * v.z, zy = u.z * v.y;
  const double zx = u.z * v.x, xz = u.x * v.z;
  const double xy = u.x * v.y, yx = u.y * v.x;
  return {{yz - zy, zx - xz, xy - yx},
          {(std::fabs(yz) + filter::floor) + std::fabs(zy), (std::fabs(zx) + filter::floor) + std::fabs(xz),
           (std::fabs(xy) + filter::floor) + std::fabs(yx)}};
}

/// (u × v) · w of rounded differences. The cross product can serve many w: the points beside one plane.
inline Filtered filtered_triple_product(const FilteredCross& n, const Vec3& w) {
  const Vec3& m = n.magnitude;
  const double magnitude = ((m.x * std::fabs(w.x) + m.y * std::fabs(w.y)) + m.z * std::fabs(w.z)) + filter::floor;
  return {dot(n.value, w), filter::triple_product_bound * magnitude};
}

/// The value of `orient3d`.
inline Filtered filtered_orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return filtered_triple_product(filtered_cross(b - a, c - a), d - a);
}

/// The value of `orient2d`.
inline Filtered filtered_orient2d(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double left = (b.x - a.x) * (c.y - a.y), right = (b.y - a.y) * (c.x - a.x);
  const double magnitude = (std::fabs(left) + std::fabs(right)) + filter::floor;
  return {left - right, filter::orient2d_bound * magnitude};
}

}  // namespace toccata
