#include "narrow/quadrics/inside/quadric_containment.hpp"

#include <cmath>
#include <vector>

#include "narrow/convex/vertices_of.hpp"
#include "narrow/quadrics/distance/quadric_proof.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {
namespace {

bool reaches_beyond(const QuadricBody& held, const QuadricBody& holder, const Vec3& direction) {
  const FineDirection along = fine(direction);
  return (height_of<BoundedDouble>(held, along) - height_of<BoundedDouble>(holder, along)).is_positive();
}

/// What one look along some directions shows: mostly what does not hold another shape is soon seen not to.
bool sticks_out(const QuadricBody& held, const QuadricBody& holder) {
  for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
    if (reaches_beyond(held, holder, axis) || reaches_beyond(held, holder, -axis)) return true;
  for (const QuadricBody* body : {&held, &holder}) {
    if (!body->quadric_kind()) continue;
    for (const BoundedVector& axis : body->axes())
      if (reaches_beyond(held, holder, plain(axis)) || reaches_beyond(held, holder, -plain(axis))) return true;
  }
  return false;
}

/// The height of a quadric body's highest point along a normal.
BoundedNumber top_of(const QuadricBody& body, const BoundedVector& normal) {
  BoundedNumber squared = exactly(0);
  for (std::size_t j = 0; j < body.column_count(); ++j) {
    const BoundedNumber along = dot(normal, body.column(j));
    squared = squared + along * along;
  }
  const BoundedNumber growth = root_of_squares(squared);
  BoundedNumber top = dot(normal, body.centre(0));
  if (body.grown(0)) top = top + growth;
  for (Index i = 1; i < body.generator_count(); ++i) {
    BoundedNumber height = dot(normal, body.centre(i));
    if (body.grown(i)) height = height + growth;
    const double error = std::fmax(top.error, height.error);
    if (height.value.high > top.value.high || (height.value.high == top.value.high && height.value.low > top.value.low))
      top = height;
    top.error = error;
  }
  return top;
}

/// Decides by all faces of the world vertices' hull, which is the shape.
Within is_held_by_polytope(const QuadricBody& held, const PosedPolytope& by, const PairFrame& frame) {
  const ConvexHull hull(vertices_of(by));
  if (hull.dimension() < 3) return Within::no;
  const HullTopology topology = hull.topology();
  Within all = Within::yes;
  for (Index face = 0; face < topology.face_count() && all != Within::no; ++face) {
    const Index first = topology.face_start[face];
    const auto corner = [&](Index k) { return frame.place(hull.vertex(topology.origin[first + k])); };
    const BoundedVector at = corner(0), normal = cross(corner(1) - at, corner(2) - at);
    all = both(all, from_sign(top_of(held, normal) - dot(normal, at)));
  }
  return all;
}

/// A ball is a quadric with as long half axes: its unit coordinates are those from its centre, over the radius.
Within is_held_by_ball(const QuadricBody& held, const PosedPolytope& by, const PairFrame& frame) {
  const PosedQuadric ball(Ellipsoid({by.radius(), by.radius(), by.radius()}),
                          Pose::translation(by.vertex(0).x, by.vertex(0).y, by.vertex(0).z));
  return is_held(UnitFrame(QuadricBody(ball, frame)), held);
}

Within is_held_by_rounded(const QuadricBody& held, const PosedPolytope& by, const PairFrame& frame) {
  std::vector<Vec3> vertices = vertices_of(by);
  for (Vec3& vertex : vertices) vertex = plain(frame.place(vertex));
  const ConvexHull core(vertices);
  return is_held_by_offset(held, PosedPolytope(core), frame.factor * by.radius());
}

}  // namespace

Within is_held_by_quadric_body(const PosedPolytope& shape, const QuadricBody& held, const PosedQuadric& by,
                               const QuadricBody& holder) {
  if (shape.radius() > 0) return sticks_out(held, holder) ? Within::no : is_held(UnitFrame(holder), held);
  const UnitFrame unit(holder);
  for (Index i = 0; i < shape.vertex_count(); ++i) {
    const Within within = is_held(unit, unit.generator(held, i));
    if (within == Within::yes) continue;
    if (within == Within::no) return within;
    const Sign side = side_of(shape.vertex(i), by);
    if (side == Sign::positive || (side == Sign::zero && !shape.solid())) return Within::no;
  }
  return Within::yes;
}

Within is_held_by_quadric_body(const QuadricBody& held, const QuadricBody& holder) {
  return sticks_out(held, holder) ? Within::no : is_held(UnitFrame(holder), held);
}

Within is_held_by_convex(const QuadricBody& held, const PosedPolytope& by, const QuadricBody& holder,
                         const PairFrame& frame) {
  if (sticks_out(held, holder)) return Within::no;
  if (!(by.radius() > 0)) return is_held_by_polytope(held, by, frame);
  return by.vertex_count() == 1 ? is_held_by_ball(held, by, frame) : is_held_by_rounded(held, by, frame);
}

}  // namespace toccata
