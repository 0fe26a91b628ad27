#include "toccata/shapes/primitives.hpp"

#include "shapes/validation.hpp"

namespace toccata {

Point::Point(const Vec3& position) : position_(position) { require_finite(position, "the position of a point"); }

}  // namespace toccata
