#include <bit>
#include <cmath>
#include <initializer_list>

#include "math/wide_integer.hpp"
#include "toccata/methods/sphere_ways.hpp"

namespace toccata {
namespace {

/// head − tail, where it is positive: how far the centre lies beyond a face plane.
struct Excess {
  double head = 0;
  double tail = 0;

  [[nodiscard]] double rounded() const { return head - tail; }
};

bool is_within_exactly(std::initializer_list<Excess> excesses, double radius) {
  int unit = common_exponent({radius});
  for (const Excess& e : excesses) unit = std::min(unit, common_exponent({e.head, e.tail}));
  WideInteger sum = 0;
  for (const Excess& e : excesses) {
    const WideInteger difference = scaled_wide(e.head, unit) - scaled_wide(e.tail, unit);
    sum += difference * difference;
  }
  const WideInteger reach = scaled_wide(radius, unit);
  return sum <= reach * reach;
}

/// The sum of the squares is at most the radius's. A difference, a square and two sums are four roundings of 2^-53,
/// the radius's square one; underflow loses less than the floor.
bool is_within(std::initializer_list<Excess> excesses, double radius) {
  double sum = 0;
  for (const Excess& e : excesses) sum += e.rounded() * e.rounded();
  const double limit = radius * radius, error = 0x1p-49 * (sum + limit) + 0x1p-1000;
  if (sum < limit - error) return true;
  if (sum > limit + error) return false;
  return is_within_exactly(excesses, radius);
}

Excess excess_of_region(const PosedSphere& s, const Vec3& lower, const Vec3& upper, unsigned code, int axis) {
  const unsigned bits = code >> static_cast<unsigned>(2 * axis) & 3U;
  if (bits == 0) return {};
  return bits == 1 ? Excess{lower[axis], s.centre[axis]} : Excess{s.centre[axis], upper[axis]};
}

/// The axes, ascending, in which the centre is beyond a face.
int next_axis_beyond(unsigned code, int from) {
  while ((code >> static_cast<unsigned>(2 * from) & 3U) == 0) ++from;
  return from;
}

/// max(lower − c, 0, c − upper), as a difference.
Excess clamped_excess(const PosedSphere& s, const Vec3& lower, const Vec3& upper, int axis) {
  const double c = s.centre[axis];
  return {std::fmax(lower[axis], c), std::fmin(upper[axis], c)};
}

}  // namespace

bool overlap_by_regions(const PosedSphere& s, const Vec3& lower, const Vec3& upper) {
  const unsigned code = box_region(s.centre, lower, upper);
  const auto excess = [&](int axis) { return excess_of_region(s, lower, upper, code, axis); };
  switch (std::popcount(code)) {
    case 0:  // inside
      return true;
    case 1:  // a face: its plane is the nearest
      return is_within({excess(next_axis_beyond(code, 0))}, s.radius);
    case 2: {  // an edge
      const int first = next_axis_beyond(code, 0);
      return is_within({excess(first), excess(next_axis_beyond(code, first + 1))}, s.radius);
    }
    default:  // a corner
      return is_within({excess(0), excess(1), excess(2)}, s.radius);
  }
}

bool overlap_by_clamping(const PosedSphere& s, const Vec3& lower, const Vec3& upper) {
  const auto excess = [&](int axis) { return clamped_excess(s, lower, upper, axis); };
  return is_within({excess(0), excess(1), excess(2)}, s.radius);
}

}  // namespace toccata
