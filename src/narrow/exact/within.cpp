#include "narrow/exact/within.hpp"

#include "narrow/exact/exact_distance.hpp"
#include "narrow/exact/vertex_pairs.hpp"

namespace toccata {

bool is_within(const Distance& known, const PosedPolytope& a, const PosedPolytope& b, double tolerance) {
  if (known.upper <= tolerance) return true;
  if (known.lower > tolerance) return false;
  const ExactNearest nearest = exact_nearest(a, b, first_vertices());
  return nearest.meet || compare_offset_distance(nearest, a.radius(), b.radius(), tolerance) != Sign::positive;
}

// The distance from a half-space is rounded both ways to neighbouring doubles, or is itself a double: `upper` is the
// least that is not below it.
bool is_within(const Distance& known, const PosedPolytope&, const PosedHalfSpace&, double tolerance) {
  return known.upper <= tolerance;
}

bool is_within(const Distance& known, const PosedHalfSpace&, const PosedHalfSpace&, double tolerance) {
  return known.upper <= tolerance;
}

}  // namespace toccata
