#include "toccata/shapes/primitives.hpp"

#include "shapes/validation.hpp"

namespace toccata {

Sphere::Sphere(double radius, const Vec3& centre) : centre_(centre), radius_(radius) {
  require_positive(radius, "the radius of a sphere");
  require_finite(centre, "the centre of a sphere");
}

}  // namespace toccata
