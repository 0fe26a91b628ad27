#include "toccata/math/predicates.hpp"

#include <boost/multiprecision/cpp_int.hpp>

// Placeholder until the filtered stages land: rational arithmetic throughout. Exact, and slow.
namespace toccata {
namespace {

using Rational = boost::multiprecision::cpp_rational;

Sign sign_of(const Rational& r) { return r > 0 ? Sign::positive : r < 0 ? Sign::negative : Sign::zero; }

}  // namespace

Sign orient2d(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Rational ux = Rational(b.x) - Rational(a.x), uy = Rational(b.y) - Rational(a.y);
  const Rational vx = Rational(c.x) - Rational(a.x), vy = Rational(c.y) - Rational(a.y);
  return sign_of(ux * vy - uy * vx);
}

Sign triple_product_sign(const Difference& u, const Difference& v, const Difference& w) {
  Rational r[3][3];
  const Difference* rows[3] = {&u, &v, &w};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) r[i][j] = Rational(rows[i]->head[j]) - Rational(rows[i]->tail[j]);
  return sign_of(r[0][0] * (r[1][1] * r[2][2] - r[1][2] * r[2][1]) - r[0][1] * (r[1][0] * r[2][2] - r[1][2] * r[2][0]) +
                 r[0][2] * (r[1][0] * r[2][1] - r[1][1] * r[2][0]));
}

Sign orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return triple_product_sign({b, a}, {c, a}, {d, a});
}

}  // namespace toccata
