#include "toccata/shapes/primitives.hpp"

#include "toccata/math/predicates.hpp"

namespace toccata {

bool has_area(const Triangle& t) {
  for (int axis = 0; axis < 3; ++axis)
    if (orient2d(drop_axis(t[0], axis), drop_axis(t[1], axis), drop_axis(t[2], axis)) != Sign::zero) return true;
  return false;
}

}  // namespace toccata
