#pragma once

#include <string_view>

#include "toccata/math/vec3.hpp"
#include "toccata/shapes/primitives.hpp"

namespace toccata {

// What constructors of shapes check beside `require_positive`. `what` begins the message: "the centre of a sphere".

/// Throws Error unless all three numbers are finite.
void require_finite(const Vec3& value, std::string_view what);

}  // namespace toccata
