#include <utility>

#include "narrow/boxes/box_axes.hpp"
#include "narrow/primitives/pair_depths.hpp"
#include "narrow/primitives/pair_distances.hpp"

namespace toccata {
namespace {

PosedSphere ball_of(const PosedPolytope& shape) { return {shape.vertex(0), shape.radius()}; }
PosedCapsule rod_of(const PosedPolytope& shape) { return {shape.vertex(0), shape.vertex(1), shape.radius()}; }

/// With more digits only where they are needed.
Distance of_point_box(const PosedSphere& a, const PosedPolytope& b) {
  Distance found = formula_distance(a, RoundBox{{b.along(0), b.along(1), b.along(2)}, b.radius()});
  if (!is_known(found) && a.radius + b.radius() > 0) found = close_formula_distance(a, b);
  return found;
}

Distance of_point(const PosedPolytope& a, const PosedPolytope& b) {
  const PosedSphere point = ball_of(a);
  switch (b.vertex_count()) {
    case 1:
      return formula_distance(point, ball_of(b));
    case 2:
      return formula_distance(point, rod_of(b));
    case 3:
      return formula_distance(point, Triangle{{b.vertex(0), b.vertex(1), b.vertex(2)}}, b.radius());
    default:
      return is_box(b) ? of_point_box(point, b) : unknown_distance();
  }
}

/// The answer for a ball or a capsule and another or a box, by the overload of `ask` for just these; else `none`.
template <class Answer, class Ask>
Answer asked_of_round(const PosedPolytope& a, const PosedPolytope& b, const Ask& ask, const Answer& none) {
  const bool a_is_round = a.vertex_count() <= 2, b_is_round = b.vertex_count() <= 2;
  if (a.radius() + b.radius() == 0) return none;
  if (!a_is_round || (b_is_round && a.vertex_count() > b.vertex_count()))
    return b_is_round ? flipped(asked_of_round(b, a, ask, none)) : none;
  if (a.vertex_count() == 1) {
    if (b_is_round) return b.vertex_count() == 1 ? ask(ball_of(a), ball_of(b)) : ask(ball_of(a), rod_of(b));
    return is_box(b) ? ask(ball_of(a), b) : none;
  }
  if (b_is_round) return ask(rod_of(a), rod_of(b));
  return is_box(b) ? ask(rod_of(a), b) : none;
}

}  // namespace

Distance distance_of_primitives(const PosedPolytope& a, const PosedPolytope& b) {
  if (a.vertex_count() == 1) return of_point(a, b);
  if (b.vertex_count() == 1) {
    Distance distance = of_point(b, a);
    std::swap(distance.on_a, distance.on_b);
    return distance;
  }
  if (a.vertex_count() != 2 && b.vertex_count() != 2) return unknown_distance();
  if (a.vertex_count() == 2 && b.vertex_count() == 2) return formula_distance(rod_of(a), rod_of(b));
  if (a.radius() + b.radius() == 0) return unknown_distance();
  if (a.vertex_count() == 2) return is_box(b) ? close_formula_distance(rod_of(a), b) : unknown_distance();
  return is_box(a) ? flipped(close_formula_distance(rod_of(b), a)) : unknown_distance();
}

Penetration depth_of_primitives(const PosedPolytope& a, const PosedPolytope& b) {
  return asked_of_round(
      a, b, [](const auto& x, const auto& y) { return formula_depth(x, y); }, unknown_depth());
}

Manifold manifold_of_primitives(const PosedPolytope& a, const PosedPolytope& b) {
  return asked_of_round(
      a, b, [](const auto& x, const auto& y) { return formula_manifold(x, y); }, unknown_manifold());
}

}  // namespace toccata
