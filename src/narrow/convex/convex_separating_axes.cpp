#include "toccata/narrow/convex_convex.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "math/constants.hpp"
#include "narrow/boxes/box_axes.hpp"
#include "narrow/convex/canonical_order.hpp"
#include "narrow/convex/convex_containment.hpp"
#include "narrow/convex/convex_separation.hpp"
#include "narrow/convex/core_separation.hpp"
#include "narrow/convex/face_clipping.hpp"
#include "narrow/convex/polyhedron_axes.hpp"
#include "narrow/convex/solid_check.hpp"
#include "narrow/triangles/contact_faces.hpp"

namespace toccata {
namespace {

/// The points of two edges that are nearest to each other; false where their lines are nearest elsewhere: the edges of
/// two faces that lie across the direction.
bool find_points_of_edges(CoreSeparation& separation, const PosedPolytope& a, const PosedPolytope& b,
                          const PolyhedronAxes& axes, const PolyhedronAxes::Edge& e, const PolyhedronAxes::Edge& f) {
  const DifferenceBody& body = axes.body();
  const auto in_world = [&](const Vec3& v) { return Vec3{body.unscaled(v.x), body.unscaled(v.y), body.unscaled(v.z)}; };
  // The way from one point to the other is the depth, along the direction: what is left lies in the plane of the edges.
  const Vec3 way = body.point(e.vertex, f.vertex).value;
  const Vec3 n = cross(e.along, f.along);
  const double squared = dot(n, n);
  const double share_e = -dot(cross(way, f.along), n) / squared, share_f = -dot(cross(way, e.along), n) / squared;
  // Under a pose that mirrors, the edge lies against `along` from its vertex.
  const auto is_on_edge = [](double share, const PosedPolytope& shape) {
    return std::fabs(turn_of_faces(shape.pose().linear) * share - 0.5) <= 0.5 + 0x1p-30;
  };
  if (!is_on_edge(share_e, a) || !is_on_edge(share_f, b)) return false;
  separation.on_a = body.a()[e.vertex] + in_world(share_e * e.along);
  separation.on_b = body.b()[f.vertex] + in_world(share_f * f.along);
  return true;
}

/// One face lies across the direction, and the other core's deepest points over it.
bool find_points_of_face(CoreSeparation& separation, const PosedPolytope& a, const PosedPolytope& b) {
  const Vec3 &n = separation.direction, way = separation.upper * n;
  const ContactFace face_a = facing_face(a, n), face_b = facing_face(b, -n);
  const bool of_a = face_a.facing >= face_b.facing;
  const std::optional<Vec3> deepest =
      of_a ? deepest_of_incident(face_a, face_b, n) : deepest_of_incident(face_b, face_a, -n);
  if (!deepest) return false;
  separation.on_a = of_a ? *deepest + way : *deepest;
  separation.on_b = of_a ? *deepest : *deepest - way;
  return true;
}

/// Nothing when the bracket is wider than it may be, or the points are not at hand.
std::optional<CoreSeparation> part_cores_by_edges(const PosedPolytope& a, const PosedPolytope& b) {
  PolyhedronAxes axes(a, b);
  const PolyhedronAxes::Least least = axes.least({});
  const DifferenceBody& body = axes.body();
  const double reach = body.scaled_length(a.radius() + b.radius());
  if (!(least.lower > 0) || !(least.upper - least.lower <= relative_width_of_depth * (least.upper + reach))) return {};
  CoreSeparation separation;
  separation.kind = CoreSeparation::Kind::deep;
  separation.direction = least.direction;
  separation.upper = body.upper_in_world(least.upper);
  separation.lower = body.lower_in_world(least.lower);
  if (least.edge_a != nullptr && find_points_of_edges(separation, a, b, axes, *least.edge_a, *least.edge_b))
    return separation;
  if (!find_points_of_face(separation, a, b)) return {};
  return separation;
}

Penetration in_canonical_order(const PosedPolytope& a, const PosedPolytope& b) {
  if (const std::optional<CoreSeparation> core = part_cores_by_edges(a, b))
    return offset_outward(*core, a.radius(), b.radius());
  return part_by_expansion(a, b).penetration;
}

}  // namespace

bool overlap_by_separating_axes(const PosedPolytope& a, const PosedPolytope& b, SimplexCache* workspace) {
  const double radii = a.radius() + b.radius();
  std::optional<bool> meet;
  if (radii == 0 && is_box(a) && is_box(b)) {
    meet = BoxAxes(a, b).meet();
  } else {
    PolyhedronAxes axes(a, b);
    const PolyhedronAxes::Least least = axes.least(workspace != nullptr ? workspace->direction : Vec3{});
    if (least.lower > 0) meet = true;
    if (radii == 0 && least.upper < 0) meet = false;
    if (workspace != nullptr && least.upper < 0) workspace->direction = least.direction;
  }
  if (!meet) return overlap(a, b, workspace);
  if (workspace != nullptr) ++workspace->counts.certificates;
  return *meet;
}

Penetration penetration_by_separating_axes(const PosedPolytope& a, const PosedPolytope& b) {
  require_solids(a, b);
  if (is_flattened(a) || is_flattened(b)) return without_depth(a, b);
  return is_canonical_order(a, b) ? in_canonical_order(a, b) : flipped(in_canonical_order(b, a));
}

}  // namespace toccata
