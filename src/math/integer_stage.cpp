#include "math/scaled_integer.hpp"
#include "math/stages.hpp"

namespace toccata {
namespace {

Integer scaled_difference(double head, double tail, int exponent) {
  return scaled(head, exponent) - scaled(tail, exponent);
}

}  // namespace

Sign orient2d_by_integers(const Vec2& a, const Vec2& b, const Vec2& c) {
  const int ex = common_exponent({a.x, b.x, c.x}), ey = common_exponent({a.y, b.y, c.y});
  const Integer ux = scaled_difference(b.x, a.x, ex), uy = scaled_difference(b.y, a.y, ey);
  const Integer vx = scaled_difference(c.x, a.x, ex), vy = scaled_difference(c.y, a.y, ey);
  return sign_of(Integer(ux * vy - uy * vx));
}

Sign triple_product_sign_by_integers(const Difference& u, const Difference& v, const Difference& w) {
  // Scaling a column of a determinant by a positive number keeps its sign, so every axis has its own exponent.
  IntegerRow rows[3];
  for (int axis = 0; axis < 3; ++axis) {
    const int exponent =
        common_exponent({u.head[axis], u.tail[axis], v.head[axis], v.tail[axis], w.head[axis], w.tail[axis]});
    const auto column = static_cast<std::size_t>(axis);
    rows[0][column] = scaled_difference(u.head[axis], u.tail[axis], exponent);
    rows[1][column] = scaled_difference(v.head[axis], v.tail[axis], exponent);
    rows[2][column] = scaled_difference(w.head[axis], w.tail[axis], exponent);
  }
  return sign_of(determinant(rows[0], rows[1], rows[2]));
}

}  // namespace toccata
