#include "toccata/narrow/convex_penetration.hpp"

#include <cmath>
#include <limits>

#include "narrow/canonical_order.hpp"
#include "narrow/core_parting.hpp"
#include "narrow/rounded_depth.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void require_solid(const PosedConvex& shape, const char* which) {
  if (shape.solid()) return;
  throw Error(std::string("penetration: the ") + which +
              " shape is a surface (a point, a segment, a triangle or a flat hull), which has no interior that another "
              "could leave; give it a radius, or ask for the distance or the manifold");
}

VertexPairs first_vertices() {
  VertexPairs pairs;
  pairs.append(0, 0);
  return pairs;
}

/// The cores' interiors meet: the radii add to their depth.
Penetration grown(const CoreParting& core, double radius_a, double radius_b) {
  Penetration result{core.lower, core.upper, core.direction, core.on_a, core.on_b, core.status};
  if (radius_a == 0 && radius_b == 0) return result;
  result.on_a = core.on_a + radius_a * core.direction;
  result.on_b = core.on_b - radius_b * core.direction;
  // Two sums, each off by half a last place at most; the direction is a unit vector up to 2^-50.
  const double lower = (core.lower + radius_a) + radius_b, upper = (core.upper + radius_a) + radius_b;
  result.lower = lower - 0x1p-52 * lower;
  result.upper = std::nextafter(upper + 0x1p-49 * upper, infinity);
  return result;
}

Penetration in_canonical_order(const PosedConvex& a, const PosedConvex& b) {
  const CoreParting core = part_cores_by_expansion(a, b, a.radius() + b.radius());
  if (core.kind == CoreParting::Kind::deep) return grown(core, a.radius(), b.radius());
  if (a.radius() == 0 && b.radius() == 0) return {0, 0, core.direction, core.on_a, core.on_b, core.status};
  return rounded_depth(exact_nearest(a, b, first_vertices()), a.radius(), b.radius(), core.direction);
}

}  // namespace

Penetration penetration_by_expansion(const PosedConvex& a, const PosedConvex& b) {
  require_solid(a, "first");
  require_solid(b, "second");
  return is_canonical_order(a, b) ? in_canonical_order(a, b) : flipped(in_canonical_order(b, a));
}

Penetration penetration(const PosedConvex& a, const PosedConvex& b, ConvexWorkspace* workspace) {
  if (workspace != nullptr) ++workspace->counts.certificates;
  return penetration_by_expansion(a, b);
}

}  // namespace toccata
