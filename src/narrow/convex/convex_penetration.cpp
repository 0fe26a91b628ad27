#include "toccata/narrow/convex_convex.hpp"

#include <optional>
#include <string>

#include "narrow/boxes/box_separation.hpp"
#include "narrow/convex/aligned_cores.hpp"
#include "narrow/convex/canonical_order.hpp"
#include "narrow/convex/convex_containment.hpp"
#include "narrow/convex/convex_separation.hpp"
#include "narrow/convex/solid_check.hpp"
#include "narrow/primitives/pair_depths.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

void require_solid(const PosedPolytope& shape, const char* which) {
  if (shape.solid()) return;
  throw Error(std::string("penetration: the ") + which +
              " shape is a surface (a point, a segment, a triangle or a flat hull), which has no interior that another "
              "could leave; give it a radius, or ask for the distance or the manifold");
}

/// The penetration of boxes, and of grown cores that are aligned with the axes.
std::optional<Penetration> penetration_by_closed_form(const PosedPolytope& a, const PosedPolytope& b) {
  if (a.radius() > 0 || b.radius() > 0) {
    if (!is_canonical_order(a, b)) {
      const std::optional<Penetration> exchanged = penetration_by_closed_form(b, a);
      return exchanged ? flipped(*exchanged) : exchanged;
    }
    if (const std::optional<ConvexSeparation> aligned = part_aligned_cores(a, b)) return aligned->penetration;
  }
  return penetration_of_boxes(a, b);
}

/// Of solids that rounding has not flattened.
Penetration of_full_solids(const PosedPolytope& a, const PosedPolytope& b) {
  if (is_canonical_order(a, b)) return part_by_expansion(a, b).penetration;
  return flipped(part_by_expansion(b, a).penetration);
}

}  // namespace

void require_solids(const PosedPolytope& a, const PosedPolytope& b) {
  require_solid(a, "first");
  require_solid(b, "second");
}

Penetration without_depth(const PosedPolytope& a, const PosedPolytope& b) {
  if (!is_canonical_order(a, b)) return flipped(without_depth(b, a));
  const Penetration separation = part_by_expansion(a, b).penetration;
  const Distance common = distance(a, b);
  return {0, 0, separation.direction, common.on_a, common.on_b, separation.status};
}

Penetration penetration_by_expansion(const PosedPolytope& a, const PosedPolytope& b) {
  require_solids(a, b);
  return is_flattened(a) || is_flattened(b) ? without_depth(a, b) : of_full_solids(a, b);
}

Penetration penetration(const PosedPolytope& a, const PosedPolytope& b, SimplexCache* workspace) {
  require_solids(a, b);
  if (is_flattened(a) || is_flattened(b)) return without_depth(a, b);
  const Penetration of_primitives = depth_of_primitives(a, b);
  std::optional<Penetration> found;
  if (is_known(of_primitives)) found = of_primitives;
  if (!found) found = penetration_by_closed_form(a, b);
  if (found) {
    if (workspace != nullptr) ++workspace->counts.closed_forms;
    return *found;
  }
  if (workspace != nullptr) ++workspace->counts.certificates;
  return of_full_solids(a, b);
}

}  // namespace toccata
