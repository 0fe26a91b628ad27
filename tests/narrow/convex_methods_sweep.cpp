#include <algorithm>
#include <array>

#include "narrow/convex_cells.hpp"
#include "toccata/methods/sphere_ways.hpp"
#include "toccata/narrow/casts.hpp"
#include "toccata/narrow/convex_convex.hpp"
#include "toccata/narrow/primitives.hpp"

// Methods against each other, without the oracle and so in great numbers: every question that tells whether two shapes
// meet says the same, and the ways to the penetration give brackets that have a number in common.
namespace toccata::test {
namespace {

bool have_common_number(const Penetration& p, const Penetration& q) {
  return std::max(p.lower, q.lower) <= std::min(p.upper, q.upper);
}

std::string check_penetration(const PosedPolytope& a, const PosedPolytope& b) {
  const Penetration chosen = penetration(a, b);
  const Penetration by_expansion = penetration_by_expansion(a, b), by_axes = penetration_by_separating_axes(a, b);
  if (!have_common_number(by_expansion, by_axes)) return "expansion and axes";
  if (!have_common_number(chosen, by_expansion)) return "penetration and expansion";
  if (!have_common_number(chosen, by_axes)) return "penetration and axes";
  if ((chosen.upper > 0) != (by_expansion.upper > 0) || (chosen.upper > 0) != (by_axes.upper > 0)) return "depth 0";
  if (chosen.upper > 0 && !overlap(a, b)) return "a penetration of what is apart";
  return "";
}

/// In every manner, without and with a workspace: the same bits.
std::string check_gjk(const PosedPolytope& a, const PosedPolytope& b, bool meet) {
  const Distance chosen = distance(a, b), plain = distance_by_gjk(a, b);
  if (std::max(chosen.lower, plain.lower) > std::min(chosen.upper, plain.upper)) return "distance and GJK";
  for (const GjkSupport support : {GjkSupport::scan, GjkSupport::hill_climbing})
    for (const GjkAcceleration acceleration : {GjkAcceleration::none, GjkAcceleration::nesterov}) {
      const GjkOptions options{support, acceleration};
      SimplexCache workspace;
      if (overlap_by_gjk(a, b, options, &workspace) != meet) return "overlap by GJK";
      if (!(distance_by_gjk(a, b, options) == plain)) return "the manner of GJK";
      if (!(distance_by_gjk(a, b, options, &workspace) == plain)) return "the manner of GJK, warm";
    }
  return "";
}

std::string check_convex_methods(const ConvexCase& pair, Random&) {
  const PosedPolytope a = posed(pair.a), b = posed(pair.b);
  const bool meet = overlap(a, b);
  if (std::string wrong = check_gjk(a, b, meet); !wrong.empty()) return wrong;
  if (overlap_by_separating_axes(a, b) != meet) return "separating axes";
  if ((distance(a, b).upper == 0) != meet) return "distance";
  if ((relation(a, b).kind != RelationKind::apart) != meet) return "relation";
  if ((manifold(a, b).count > 0) != meet) return "manifold";
  if (cast_shape(a, {}, b).has_value() != meet) return "cast";
  return a.solid() && b.solid() ? check_penetration(a, b) : "";
}

SweepResult run_convex_methods(const std::string& cell, std::uint64_t seed, std::uint64_t cases) {
  return run_cell(cell, seed, cases, check_convex_methods);
}

const bool convex_methods_known = register_sweep({"convex-methods", cells_of(convex_kinds()), cell_goal,
                                                  20 * cell_round, run_convex_methods, 2 * cell_shard, cell_round});

// The lecture's ways for spheres.

PosedSphere sphere_of(const PlacedPolytope& placed) { return PosedSphere(std::get<Sphere>(placed.shape), placed.pose); }

/// A sphere against a triangle in the world, in four ways and by the general search.
std::string check_triangle(const PosedSphere& ball, const PlacedPolytope& placed) {
  const auto& local = std::get<Triangle>(placed.shape);
  const Triangle triangle{
      {transform(placed.pose, local[0]), transform(placed.pose, local[1]), transform(placed.pose, local[2])}};
  const bool meet = overlap(PosedPolytope(Sphere(ball.radius, ball.centre)), posed(placed));
  if (overlap(ball, triangle) != meet) return "closed form";
  if (overlap_by_plane_projection(ball, triangle) != meet) return "by plane projection";
  if (overlap_by_features(ball, triangle) != meet) return "by features";
  if (overlap_by_minimisation(ball, triangle) != meet) return "by minimisation";
  if (overlap_by_voronoi_regions(ball, triangle) != meet) return "by Voronoi regions";
  if (meet && plane_rejects(ball, triangle)) return "rejected by the plane";
  return (distance(ball, triangle).upper == 0) == meet ? "" : "distance";
}

/// A sphere against the box's own box along the world's axes, in two ways and by the general search.
std::string check_aligned(const PosedSphere& ball, const PosedPolytope& box) {
  Vec3 lower = box.vertex(0), upper = lower;
  for (Index i = 1; i < box.vertex_count(); ++i)
    for (int axis = 0; axis < 3; ++axis) {
      lower[axis] = std::min(lower[axis], box.vertex(i)[axis]);
      upper[axis] = std::max(upper[axis], box.vertex(i)[axis]);
    }
  std::vector<Vec3> corners;
  for (const double x : {lower.x, upper.x})
    for (const double y : {lower.y, upper.y})
      for (const double z : {lower.z, upper.z}) corners.push_back({x, y, z});
  const ConvexHull hull(corners);
  const bool meet = overlap(PosedPolytope(Sphere(ball.radius, ball.centre)), PosedPolytope(hull));
  if (overlap_by_regions(ball, lower, upper) != meet) return "by regions";
  return overlap_by_clamping(ball, lower, upper) == meet ? "" : "by clamping";
}

std::string check_box(const PosedSphere& ball, const PlacedPolytope& placed) {
  const PosedPolytope box = posed(placed);
  const PosedBox formed(std::get<Box>(placed.shape), placed.pose);
  const bool meet = overlap(PosedPolytope(Sphere(ball.radius, ball.centre)), box);
  if (overlap(ball, formed) != meet) return "closed form";
  if ((distance(ball, formed).upper == 0) != meet) return "distance";
  return check_aligned(ball, box);
}

std::string check_sphere(const ConvexCase& pair, Random&) {
  const bool first = std::holds_alternative<Sphere>(pair.a.shape);
  const PosedSphere ball = sphere_of(first ? pair.a : pair.b);
  const PlacedPolytope& other = first ? pair.b : pair.a;
  return std::holds_alternative<Box>(other.shape) ? check_box(ball, other) : check_triangle(ball, other);
}

SweepResult run_sphere(const std::string& cell, std::uint64_t seed, std::uint64_t cases) {
  return run_cell(cell, seed, cases, check_sphere);
}

const bool sphere_known = register_sweep(
    {"sphere-ways", {"sphere/triangle", "sphere/box"}, 10 * cell_goal, 20 * cell_round, run_sphere, 20 * cell_shard});

}  // namespace
}  // namespace toccata::test
