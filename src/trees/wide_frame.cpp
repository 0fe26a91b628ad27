#include "trees/wide_frame.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace toccata {
namespace {

constexpr int least_exponent = -1000;
constexpr int greatest_exponent = 1023;

double greatest_component(const Vec3& v) { return std::max({v.x, v.y, v.z}); }

using Double2 [[gnu::vector_size(16)]] = double;
using Mask2 [[gnu::vector_size(16)]] = std::int64_t;
using Float2 [[gnu::vector_size(8)]] = float;

Double2 magnitude(Double2 x) { return x < 0 ? -x : x; }

/// The next float up, or the one after it, or one between in doubles, from a float.
Double2 beyond(Double2 q) {
  // Between half and five quarters of the step to the next float, so that the nearest float to the sum is another one;
  // the second term is for floats without a leading 1.
  constexpr double share = 1.2 * 0x1p-24, least_share = 0.75 * 0x1p-149;
  return q + (magnitude(q) * share + least_share);
}

/// Floats that are not less than (x − origin) / unit taken as real numbers.
Float2 rounded_up(Double2 x, Double2 origin, double unit, double inverse) {
  const Double2 difference = x - origin;
  const Double2 scaled = difference * inverse;
  const Double2 nearest = __builtin_convertvector(__builtin_convertvector(scaled, Float2), Double2);
  // What the subtraction rounded away (D. Knuth, "The Art of Computer Programming", volume 2, 4.2.2, Theorem B).
  const Double2 subtracted = x - difference;
  const Double2 lost = (x - (difference + subtracted)) + (subtracted - origin);
  const Mask2 exact = (nearest == scaled) & (lost == 0) & (scaled * unit == difference);
  // A float that is greater is greater by far more than the operations' rounding.
  const Mask2 enough = (nearest > scaled) | exact;
  return __builtin_convertvector(enough ? nearest : beyond(nearest), Float2);
}

}  // namespace

WideFrame frame_around(const Aabb& box) {
  WideFrame frame;
  frame.origin = 0.5 * box.lower + 0.5 * box.upper;
  const double half =
      std::max(greatest_component(box.upper - frame.origin), greatest_component(frame.origin - box.lower));
  int exponent = 0;
  std::frexp(half, &exponent);
  exponent = std::clamp(exponent, least_exponent, greatest_exponent);
  frame.unit = std::ldexp(1.0, exponent);
  frame.inverse = std::ldexp(1.0, -exponent);
  return frame;
}

FloatBox to_frame(const WideFrame& frame, const Aabb& box) {
  // The least q is minus the greatest −q.
  const Vec3& o = frame.origin;
  const Float2 low = rounded_up(Double2{-box.lower.x, -box.lower.y}, Double2{-o.x, -o.y}, frame.unit, frame.inverse);
  const Float2 mixed = rounded_up(Double2{-box.lower.z, box.upper.z}, Double2{-o.z, o.z}, frame.unit, frame.inverse);
  const Float2 high = rounded_up(Double2{box.upper.x, box.upper.y}, Double2{o.x, o.y}, frame.unit, frame.inverse);
  return {Float4{-low[0], -low[1], -mixed[0], 0}, Float4{high[0], high[1], mixed[1], 0}};
}

}  // namespace toccata
