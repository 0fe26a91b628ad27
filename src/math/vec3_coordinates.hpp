#pragma once

#include <array>

#include "toccata/math/vec3.hpp"

namespace toccata {

/// The coordinates of vectors, where the axis is not known before the program runs: `v.*vec3_coordinates[axis]`.
inline constexpr std::array<double Vec3::*, 3> vec3_coordinates{&Vec3::x, &Vec3::y, &Vec3::z};

}  // namespace toccata
