#pragma once

#include "toccata/narrow/quadrics.hpp"

namespace toccata {

// What `distance` answers, where the search begins with the direction from B to A that is kept from shapes that lay
// nearly so; zero: none. It is then that of these. The numbers may lie elsewhere in the interval that is promised.
[[nodiscard]] Distance coherent_distance(const PosedQuadric& a, const PosedQuadric& b, Vec3& direction);
[[nodiscard]] Distance coherent_distance(const PosedQuadric& a, const PosedPolytope& b, Vec3& direction);

}  // namespace toccata
