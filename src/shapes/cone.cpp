#include "toccata/shapes/primitives.hpp"

#include "shapes/validation.hpp"

namespace toccata {

Cone::Cone(double radius, double half_height) : radius_(radius), half_height_(half_height) {
  require_positive(radius, "the radius of a cone");
  require_positive(half_height, "the half height of a cone");
}

}  // namespace toccata
