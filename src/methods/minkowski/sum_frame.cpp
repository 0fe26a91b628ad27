#include "methods/minkowski/sum_frame.hpp"

namespace toccata {
namespace {

double reach_of(const SumOperand& operand) {
  double reach = 0;
  for (const Vec3& p : operand.points()) reach = std::max(reach, largest_magnitude(p - operand.points()[0]));
  return reach;
}

}  // namespace

SumFrame::SumFrame(const SumOperand& a, const SumOperand& b) : first_a(a.points()[0]), first_b(b.points()[0]) {
  for (int axis = 0; axis < 3; ++axis) {
    const TwoPart sum = two_sum(first_a[axis], first_b[axis]);
    high[axis] = sum.high;
    low[axis] = sum.low;
  }
  const double size = reach_of(a) + reach_of(b);
  if (size > 0 && std::isfinite(size)) scale = std::ldexp(1.0, std::clamp(-std::ilogb(size), -1000, 1000));
  // Rounding what is left of low is off by 2^-53 of it, and low is at most 2^-53 of high.
  reach = scale * (size + 0x1p-50 * largest_magnitude(high));
}

}  // namespace toccata
