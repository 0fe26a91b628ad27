#include "toccata/math/predicates.hpp"

#include "math/filter.hpp"
#include "math/stages.hpp"

namespace toccata {
namespace {

bool is_null(const Difference& d) { return d.head == d.tail; }
bool same(const Difference& p, const Difference& q) { return p.head == q.head && p.tail == q.tail; }

// What the filter left open. Shared vertices are by far the most frequent zero, and need no arithmetic.
Sign decide_orient2d(const Vec2& a, const Vec2& b, const Vec2& c) {
  if (a == b || a == c || b == c) return Sign::zero;
  if (const auto sign = orient2d_by_machine_integers(a, b, c)) return *sign;
  if (const auto sign = orient2d_by_expansions(a, b, c)) return *sign;
  return orient2d_by_integers(a, b, c);
}

Sign decide_triple_product(const Difference& u, const Difference& v, const Difference& w) {
  if (is_null(u) || is_null(v) || is_null(w) || same(u, v) || same(v, w) || same(u, w)) return Sign::zero;
  if (const auto sign = triple_product_sign_by_machine_integers(u, v, w)) return *sign;
  if (const auto sign = triple_product_sign_by_expansions(u, v, w)) return *sign;
  return triple_product_sign_by_integers(u, v, w);
}

Vec3 rounded(const Difference& d) { return d.head - d.tail; }

}  // namespace

Sign orient2d(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Filtered area = filtered_orient2d(a, b, c);
  if (area.is_positive()) return Sign::positive;
  if (area.is_negative()) return Sign::negative;
  return decide_orient2d(a, b, c);
}

Sign orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Filtered volume = filtered_orient3d(a, b, c, d);
  if (volume.is_positive()) return Sign::positive;
  if (volume.is_negative()) return Sign::negative;
  return decide_triple_product({b, a}, {c, a}, {d, a});
}

Sign triple_product_sign(const Difference& u, const Difference& v, const Difference& w) {
  const Filtered product = filtered_triple_product(filtered_cross(rounded(u), rounded(v)), rounded(w));
  if (product.is_positive()) return Sign::positive;
  if (product.is_negative()) return Sign::negative;
  return decide_triple_product(u, v, w);
}

}  // namespace toccata
