#include "trees/wide_boxes.hpp"

#include <cmath>

namespace toccata {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Each of the two steps outwards covers the rounding of the operation before it; scaling by a power of two is exact,
// or loses less than the least double, which the second step covers too.
double upper_corner(double origin, double unit, float centre, float extent) {
  const double q = std::nextafter(double{centre} + double{extent}, infinity);
  return std::nextafter(origin + unit * q, infinity);
}

}  // namespace

Aabb box_of(const WideTree& tree, std::size_t block, std::size_t lane) {
  const WideBlock& b = tree.blocks[block];
  Aabb box;
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    box.lower[axis] = -upper_corner(-tree.origin[axis], tree.unit, -b.centre[i][lane], b.extent[i][lane]);
    box.upper[axis] = upper_corner(tree.origin[axis], tree.unit, b.centre[i][lane], b.extent[i][lane]);
  }
  return box;
}

}  // namespace toccata
