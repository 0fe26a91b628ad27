#include "trees/wide_frame.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace toccata {
namespace {

constexpr int least_exponent = -1000;
constexpr int greatest_exponent = 1023;

double greatest_component(const Vec3& v) { return std::max({v.x, v.y, v.z}); }

/// The neighbouring float further from 0, of a float that is neither 0 nor infinite.
float further(float q) { return std::bit_cast<float>(std::bit_cast<std::uint32_t>(q) + 1); }

/// The neighbouring float nearer to 0, of a float that is not 0.
float nearer(float q) { return std::bit_cast<float>(std::bit_cast<std::uint32_t>(q) - 1); }

float next_up(float q) {
  if (q == 0) return std::numeric_limits<float>::denorm_min();
  return q > 0 ? further(q) : nearer(q);
}

/// A float that is not less than (x − origin) / unit taken as real numbers.
float rounded_up(double x, double origin, double unit, double inverse) {
  const double difference = x - origin;
  const double scaled = difference * inverse;
  const auto nearest = static_cast<float>(scaled);
  if (nearest > scaled) return nearest;  // by far more than the rounding of the two operations
  if (nearest < scaled) return next_up(nearest);
  // What the subtraction rounded away (D. Knuth, "The Art of Computer Programming", volume 2, 4.2.2, Theorem B).
  const double subtracted = x - difference;
  const double lost = (x - (difference + subtracted)) + (subtracted - origin);
  const bool exact = lost == 0 && scaled * unit == difference;
  return exact ? nearest : next_up(nearest);
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
  FloatBox result{{0, 0, 0, 0}, {0, 0, 0, 0}};
  for (int axis = 0; axis < 3; ++axis) {
    const double origin = frame.origin[axis];
    // Exact, and the same rule for both sides: the least q is minus the greatest −q.
    result.lower[axis] = -rounded_up(-box.lower[axis], -origin, frame.unit, frame.inverse);
    result.upper[axis] = rounded_up(box.upper[axis], origin, frame.unit, frame.inverse);
  }
  return result;
}

}  // namespace toccata
