#include "toccata/shapes/primitives.hpp"

#include <cmath>

#include <fmt/format.h>

#include "shapes/validation.hpp"
#include "toccata/core/error.hpp"

namespace toccata {

Box::Box(const Vec3& half_extents, const Vec3& centre) : centre_(centre), half_extents_(half_extents) {
  require_finite(centre, "the centre of a box");
  for (int axis = 0; axis < 3; ++axis) {
    const char letter = "xyz"[axis];
    require_positive(half_extents[axis], fmt::format("the half extent of a box along {}", letter));
    const double low = corner(0)[axis], high = corner(7)[axis];
    if (!(low < high) || !std::isfinite(low) || !std::isfinite(high))
      throw Error(
          fmt::format("the corners of a box with centre {} and half extent {} along {} are {} and {}; give numbers of "
                      "which the sum and the difference are finite and not the same",
                      centre[axis], half_extents[axis], letter, low, high));
  }
}

}  // namespace toccata
