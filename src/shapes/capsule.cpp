#include "toccata/shapes/primitives.hpp"

#include "shapes/validation.hpp"

namespace toccata {

Capsule::Capsule(const Vec3& start, const Vec3& end, double radius) : start_(start), end_(end), radius_(radius) {
  require_positive(radius, "the radius of a capsule");
  require_finite(start, "the start of a capsule");
  require_finite(end, "the end of a capsule");
}

}  // namespace toccata
