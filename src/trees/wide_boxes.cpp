#include "trees/wide_boxes.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "math/constants.hpp"

namespace toccata {
namespace {

// Each of the two steps outwards covers the rounding of the operation before it; scaling by a power of two is exact,
// or loses less than the least double, which the second step covers too.
double upper_corner(double origin, double unit, float centre, float extent) {
  const double q = std::nextafter(double{centre} + double{extent}, infinity);
  return std::nextafter(origin + unit * q, infinity);
}

/// Floats that are not less than the differences of two, which are not negative.
Float4 difference_up(Float4 a, Float4 b) {
  const Float4 nearest = a - b;
  // The rounding of a difference is at most half the step to the next float, and a difference of 0 is exact.
  return std::bit_cast<Float4>(std::bit_cast<Int4>(nearest) - (nearest > 0));
}

/// Centres and extents of intervals, rounded outwards.
struct Around {
  Float4 centre;
  Float4 extent;
};

Around around(Float4 lower, Float4 upper) {
  const Float4 centre = 0.5F * (lower + upper);
  return {centre, greatest(difference_up(upper, centre), difference_up(centre, lower))};
}

/// The first three coordinates of four points, side by side.
std::array<Float4, 3> by_axes(Float4 a, Float4 b, Float4 c, Float4 d) {
  const Float4 xy_of_first = __builtin_shufflevector(a, b, 0, 4, 1, 5);
  const Float4 xy_of_last = __builtin_shufflevector(c, d, 0, 4, 1, 5);
  const Float4 z_of_first = __builtin_shufflevector(a, b, 2, 6, 3, 7);
  const Float4 z_of_last = __builtin_shufflevector(c, d, 2, 6, 3, 7);
  return {__builtin_shufflevector(xy_of_first, xy_of_last, 0, 1, 4, 5),
          __builtin_shufflevector(xy_of_first, xy_of_last, 2, 3, 6, 7),
          __builtin_shufflevector(z_of_first, z_of_last, 0, 1, 4, 5)};
}

}  // namespace

Aabb box_of(const WideBvh& tree, std::size_t block, std::size_t lane) {
  const WideBlock& b = tree.blocks[block];
  Aabb box;
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    box.lower[axis] = -upper_corner(-tree.origin[axis], tree.unit, -b.centre[i][lane], b.extent[i][lane]);
    box.upper[axis] = upper_corner(tree.origin[axis], tree.unit, b.centre[i][lane], b.extent[i][lane]);
  }
  return box;
}

void set_box(WideBlock& block, std::size_t lane, const FloatBox& box) {
  const auto [centre, extent] = around(box.lower, box.upper);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    block.centre[axis][lane] = centre[axis];
    block.extent[axis][lane] = extent[axis];
  }
}

void set_boxes(WideBlock& block, const std::array<FloatBox, WideBlock::width>& boxes) {
  for (std::size_t first = 0; first < WideBlock::width; first += 4) {
    const FloatBox* const four = boxes.data() + first;
    const auto lower = by_axes(four[0].lower, four[1].lower, four[2].lower, four[3].lower);
    const auto upper = by_axes(four[0].upper, four[1].upper, four[2].upper, four[3].upper);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto [centre, extent] = around(lower[axis], upper[axis]);
      std::memcpy(&block.centre[axis][first], &centre, sizeof centre);
      std::memcpy(&block.extent[axis][first], &extent, sizeof extent);
    }
  }
}

}  // namespace toccata
