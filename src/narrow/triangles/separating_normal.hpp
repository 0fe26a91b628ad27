#pragma once

#include "toccata/shapes/primitives.hpp"

namespace toccata {

/// The direction along which A parts from B soonest, for two triangles that meet: of length 1, from B to A. It is that
/// of the least overlap, rounded, among the directions along which two triangles in space can be parted, the two
/// normals and those across two edges (S. Gottschalk, "Separating axis theorem", 1996); the other way round for the two
/// exchanged. Zero where both are without area, or where squares of coordinates are no doubles.
[[nodiscard]] Vec3 separating_normal(const Triangle& a, const Triangle& b);

}  // namespace toccata
