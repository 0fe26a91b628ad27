#pragma once

#include <string_view>

#include "toccata/math/vec3.hpp"

namespace toccata {

// What constructors of shapes check. `what` begins the message: "the centre of a sphere".

/// Throws Error unless all three numbers are finite.
void require_finite(const Vec3& value, std::string_view what);

/// Throws Error unless the number is positive and finite.
void require_positive(double value, std::string_view what);

}  // namespace toccata
