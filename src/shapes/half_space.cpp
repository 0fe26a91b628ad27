#include "toccata/shapes/primitives.hpp"

#include "shapes/validation.hpp"
#include "toccata/core/error.hpp"

namespace toccata {

HalfSpace::HalfSpace(const Vec3& point, const Vec3& normal) : point_(point), normal_(normal) {
  require_finite(point, "the point of a half-space");
  require_finite(normal, "the normal of a half-space");
  if (normal == Vec3{})
    throw Error("the normal of a half-space is zero; give the direction that points out of the solid, of any length");
}

}  // namespace toccata
