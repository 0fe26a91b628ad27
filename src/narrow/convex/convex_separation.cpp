#include "narrow/convex/convex_separation.hpp"

#include <cmath>

#include "math/constants.hpp"
#include "narrow/convex/apart_cores.hpp"
#include "narrow/convex/core_separation.hpp"
#include "narrow/convex/rounded_depth.hpp"

namespace toccata {
Penetration offset_outward(const CoreSeparation& core, double radius_a, double radius_b) {
  Penetration result{core.lower, core.upper, core.direction, core.on_a, core.on_b, core.status};
  if (radius_a == 0 && radius_b == 0) return result;
  result.on_a = core.on_a + radius_a * core.direction;
  result.on_b = core.on_b - radius_b * core.direction;
  // Two sums, each off by half a last place at most; the direction is a unit vector up to 2^-50.
  const double lower = (core.lower + radius_a) + radius_b, upper = (core.upper + radius_a) + radius_b;
  result.lower = lower - 0x1p-51 * lower;
  result.upper = std::nextafter(upper + 0x1p-49 * upper, infinity);
  return result;
}

ConvexSeparation part_by_expansion(const PosedPolytope& a, const PosedPolytope& b) {
  if (const std::optional<ConvexSeparation> apart = part_apart_cores(a, b)) return *apart;
  return part_meeting_cores(a, b);
}

ConvexSeparation part_meeting_cores(const PosedPolytope& a, const PosedPolytope& b, double width) {
  const CoreSeparation core = part_cores_by_expansion(a, b, a.radius() + b.radius(), width);
  if (core.kind == CoreSeparation::Kind::deep) return {offset_outward(core, a.radius(), b.radius()), core.pairs};
  if (core.kind == CoreSeparation::Kind::apart && a.radius() == 0 && b.radius() == 0)
    return {{0, 0, core.direction, core.on_a, core.on_b, core.status}, core.pairs};
  const ExactNearest nearest = exact_nearest(a, b, first_vertices());
  return {rounded_depth(nearest, a.radius(), b.radius(), core.direction), nearest.simplex};
}

}  // namespace toccata
