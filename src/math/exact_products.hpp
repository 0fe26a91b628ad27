// Products of twice the digits, by one fused operation where the level has it and by Dekker's splitting where not. Both
// are exact, so that the bits are the same. Included once for every SIMD level, like math/lanes.hpp.
#if defined(TOCCATA_MATH_EXACT_PRODUCTS_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TOCCATA_MATH_EXACT_PRODUCTS_HPP
#undef TOCCATA_MATH_EXACT_PRODUCTS_HPP
#else
#define TOCCATA_MATH_EXACT_PRODUCTS_HPP
#endif

#include <hwy/highway.h>

#include <cmath>

#include "math/expansion.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

/// a · b, as long as its error does not underflow.
HWY_INLINE TwoPart exact_product(double a, double b) {
#if HWY_NATIVE_FMA
  const double high = a * b;
  return {high, __builtin_fma(a, b, -high)};
#else
  return two_product(a, b);
#endif
}

/// A root, and 1 / its high part.
struct LongRoot {
  double high, low;
  double inverse;
};

/// The root by a step of Newton's method: off by less than 2^-104 of it.
HWY_INLINE LongRoot long_root(const TwoPart& square) {
  const double root = std::sqrt(square.high), inverse = 1 / root;
  const TwoPart back = exact_product(root, root);
  const double rest = ((square.high - back.high) - back.low) + square.low;
  return {root, rest * (0.5 * inverse), inverse};
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#endif
