#pragma once

#include <optional>

#include "toccata/shapes/primitives.hpp"

// Coordinates of the point in which two features meet, from numbers of 106 bits with a bound on what they are off by.
// Nearly always that proves how the exact point rounds (A. Ziv, "Fast evaluation of elementary mathematical functions
// with correctly rounded last bit", 1991); nothing where it does not.
namespace toccata {

/// Where edge i of t crosses the plane of `plane`: every number the double nearest to the exact one.
[[nodiscard]] std::optional<Vec3> likely_edge_and_plane(const Triangle& t, int i, const Triangle& plane);

/// Where edge i of a crosses edge j of b, in one plane.
[[nodiscard]] std::optional<Vec3> likely_edge_and_edge(const Triangle& a, int i, const Triangle& b, int j);

}  // namespace toccata
