#pragma once

#include "methods/minkowski/sum_parts.hpp"

namespace toccata {

/// In the sum's frame.
[[nodiscard]] SumPlane plane_in_frame(const MinkowskiSum::Parts& sum, Index face);

/// The sign of a point's height above the plane of a face, exactly.
[[nodiscard]] Sign exact_height(const MinkowskiSum::Parts& sum, Index face, const Vec3& point);

/// The side of a flat core on which a point is: zero in the core, else positive; exactly.
[[nodiscard]] Sign exact_side_of_flat(const MinkowskiSum::Parts& sum, const Vec3& point);

/// The side of the sum, from that of its core.
[[nodiscard]] Sign with_radius(const MinkowskiSum::Parts& sum, Sign side_of_core, const Vec3& point);

/// The sign of (distance of a point outside from the core) − (sum of the radii), exactly.
[[nodiscard]] Sign compare_with_radius(const MinkowskiSum::Parts& sum, const Vec3& point);

}  // namespace toccata
