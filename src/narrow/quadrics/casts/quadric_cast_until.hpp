#pragma once

#include <optional>

#include "toccata/narrow/quadrics.hpp"

// For those who ask many for the first: what is certainly later than `limit` of the way (0 to 1) need not be told.
namespace toccata {

// What `cast_shape` tells; or nothing, where its lower end is later than the limit, or nothing is met.
[[nodiscard]] std::optional<Cast> cast_shape_until(const PosedQuadric& a, const Vec3& motion, const PosedPolytope& b,
                                                   double limit);
[[nodiscard]] std::optional<Cast> cast_shape_until(const PosedQuadric& a, const Vec3& motion, const PosedQuadric& b,
                                                   double limit);
[[nodiscard]] std::optional<Cast> cast_shape_until(const PosedPolytope& a, const Vec3& motion, const PosedQuadric& b,
                                                   double limit);

// No later than the lower end of what `cast_shape` tells, and mostly next to it, for a fraction of the time; more than
// 1 where they are proved not to meet. It is known to be more than the limit, or does not depend on it.
[[nodiscard]] double free_until(const PosedQuadric& a, const Vec3& motion, const PosedPolytope& b, double limit);
[[nodiscard]] double free_until(const PosedPolytope& a, const Vec3& motion, const PosedQuadric& b, double limit);

}  // namespace toccata
