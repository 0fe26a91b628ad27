#pragma once

#include <span>

#include "toccata/shapes/primitives.hpp"

namespace toccata::oracle {

/// Oracle of `generalized_winding_number`, to the last places of a double: for every triangle its angles between planes
/// (A. Girard's sum), in 50 digits. A triangle in whose plane the point lies counts 0.
double winding_number(const Vec3& point, std::span<const Triangle> world_triangles);

}  // namespace toccata::oracle
