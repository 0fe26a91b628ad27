#pragma once

#include <span>
#include <vector>

#include "toccata/math/vec3.hpp"

namespace toccata {

/// All points with normal · x ≤ offset.
struct PlaneBound {
  Vec3 normal;
  double offset = 0;
};

struct PolytopeMeasure {
  double volume = 0;
  double area = 0;
};

/// The volume and the area of the polytope within the planes, rounded. It contains the origin and reaches about 1 from
/// it.
[[nodiscard]] PolytopeMeasure measure_within(std::span<const PlaneBound> planes);

/// The corners of such a polytope, each once, beyond no plane by more than about 1e-12. One that is flat has corners
/// too.
[[nodiscard]] std::vector<Vec3> corners_within(std::span<const PlaneBound> planes);

}  // namespace toccata
