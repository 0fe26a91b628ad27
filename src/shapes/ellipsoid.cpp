#include "toccata/shapes/primitives.hpp"

#include "shapes/validation.hpp"

namespace toccata {

Ellipsoid::Ellipsoid(const Vec3& half_axes) : half_axes_(half_axes) {
  require_positive(half_axes.x, "the half axis along x of an ellipsoid");
  require_positive(half_axes.y, "the half axis along y of an ellipsoid");
  require_positive(half_axes.z, "the half axis along z of an ellipsoid");
}

}  // namespace toccata
