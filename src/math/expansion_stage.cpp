#include <cmath>

#include "math/expansion.hpp"
#include "math/stages.hpp"

namespace toccata {
namespace {

// A product of three parts below is a multiple of 2^(3·(-300 - 52)) = 2^-1056, so its error is a double; and sums of
// such products stay below 2^1000.
bool in_expansion_range(double part) {
  const double magnitude = std::fabs(part);
  return part == 0 || (magnitude >= 0x1p-300 && magnitude <= 0x1p300);  // false for ∞ and NaN
}

bool in_expansion_range(const TwoPart& difference) {
  return in_expansion_range(difference.high) && in_expansion_range(difference.low);
}

using ExactDifference = Expansion<2>;

struct ExactVector {
  ExactDifference x, y, z;
};

std::optional<ExactVector> exact_vector(const Difference& d) {
  const TwoPart x = two_difference(d.head.x, d.tail.x), y = two_difference(d.head.y, d.tail.y),
                z = two_difference(d.head.z, d.tail.z);
  if (!in_expansion_range(x) || !in_expansion_range(y) || !in_expansion_range(z)) return std::nullopt;
  return ExactVector{ExactDifference(x), ExactDifference(y), ExactDifference(z)};
}

/// a·d − b·c.
Expansion<16> determinant_of_differences(const ExactDifference& a, const ExactDifference& b, const ExactDifference& c,
                                         const ExactDifference& d) {
  return a * d + -(b * c);
}

}  // namespace

std::optional<Sign> orient2d_by_expansions(const Vec2& a, const Vec2& b, const Vec2& c) {
  const TwoPart ux = two_difference(b.x, a.x), uy = two_difference(b.y, a.y);
  const TwoPart vx = two_difference(c.x, a.x), vy = two_difference(c.y, a.y);
  if (!in_expansion_range(ux) || !in_expansion_range(uy) || !in_expansion_range(vx) || !in_expansion_range(vy))
    return std::nullopt;
  return determinant_of_differences(ExactDifference(ux), ExactDifference(uy), ExactDifference(vx), ExactDifference(vy))
      .sign();
}

std::optional<Sign> triple_product_sign_by_expansions(const Difference& du, const Difference& dv,
                                                      const Difference& dw) {
  const std::optional<ExactVector> u = exact_vector(du), v = exact_vector(dv), w = exact_vector(dw);
  if (!u || !v || !w) return std::nullopt;
  const auto along_x = determinant_of_differences(u->y, u->z, v->y, v->z) * w->x;
  const auto along_y = determinant_of_differences(u->z, u->x, v->z, v->x) * w->y;
  const auto along_z = determinant_of_differences(u->x, u->y, v->x, v->y) * w->z;
  return (along_x + along_y + along_z).sign();
}

}  // namespace toccata
