#include <utility>

#include "narrow/boxes/box_axes.hpp"
#include "narrow/primitives/pair_distances.hpp"

namespace toccata {
namespace {

PosedCapsule segment_of(const PosedPolytope& shape) { return {shape.vertex(0), shape.vertex(1), shape.radius()}; }

Distance of_point(const PosedPolytope& a, const PosedPolytope& b) {
  const PosedSphere point(a.vertex(0), a.radius());
  switch (b.vertex_count()) {
    case 1:
      return formula_distance(point, PosedSphere(b.vertex(0), b.radius()));
    case 2:
      return formula_distance(point, segment_of(b));
    case 3:
      return formula_distance(point, Triangle{{b.vertex(0), b.vertex(1), b.vertex(2)}}, b.radius());
    default:
      if (!is_box(b)) return unknown_distance();
      return formula_distance(point, RoundBox{{b.along(0), b.along(1), b.along(2)}, b.radius()});
  }
}

}  // namespace

Distance distance_of_primitives(const PosedPolytope& a, const PosedPolytope& b) {
  if (a.vertex_count() == 1) return of_point(a, b);
  if (b.vertex_count() == 1) {
    Distance distance = of_point(b, a);
    std::swap(distance.on_a, distance.on_b);
    return distance;
  }
  if (a.vertex_count() == 2 && b.vertex_count() == 2) return formula_distance(segment_of(a), segment_of(b));
  return unknown_distance();
}

}  // namespace toccata
