#include "toccata/query/subdivision.hpp"

#include <algorithm>
#include <optional>

#include "math/vec3_measures.hpp"
#include "query/subdivision/limit_search.hpp"
#include "toccata/core/error.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/query/overlap.hpp"

namespace toccata {
namespace {

/// Whether the cage is taken as a solid; checks the question.
bool taken_as_solid(const SubdivisionCage& cage, const LimitQuery& query) {
  if (!(query.tolerance > 0)) throw Error("the tolerance of a question about a limit surface must be positive");
  if (query.pair.solid_a == Solid::all && !cage.closed())
    throw Error("the cage has a border, so its limit surface encloses nothing: close it, or ask about a surface");
  if (!cage.closed() || query.pair.solid_a == Solid::none) return false;
  if (is_singular(query.pair.pose_a.linear))
    throw Error("the pose of the cage is singular and leaves no solid: ask about a surface (Solid::none)");
  return true;
}

/// In the world, without its pose.
struct WorldQuestion {
  const SubdivisionCage& cage;
  const Model& model;
  LimitQuery query;
};

/// It is connected and reaches out of the box of the cage, so it lies not within.
bool reaches_out(const WorldQuestion& world) {
  const Model& model = world.model;
  const bool is_connected =
      model.parts().empty() && (!model.has_mesh() || model.mesh_parts().first_triangle.size() == 1);
  if (!is_connected) return false;
  Aabb box;
  double largest = 0;
  for (const Vec3& v : world.cage.polygons().vertices) {
    for (int axis = 0; axis < 3; ++axis) {
      box.lower[axis] = std::min(box.lower[axis], v[axis]);
      box.upper[axis] = std::max(box.upper[axis], v[axis]);
    }
    largest = std::max(largest, largest_magnitude(v));
  }
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) {
      Vec3 far{};
      far[axis] = sign * 16 * std::max(largest, 1e-100);
      const Vec3 found = distance(Point{far}, model, {.pose_b = world.query.pair.pose_b, .solid_b = Solid::none}).on_b;
      // Witness points are off by 10⁻¹² of the greatest coordinate.
      const double slack = 1e-11 * std::max(largest_magnitude(far), largest_magnitude(found));
      if (found[axis] * sign > (sign > 0 ? box.upper[axis] : -box.lower[axis]) + slack) return true;
    }
  return false;
}

/// Of a solid whose limit surface is at least `apart` from the model, whether some part of the model is within; nothing
/// where the cage would have to be refined too far. Within that distance of the limit surface, no point of the model
/// changes sides.
std::optional<bool> has_within(const WorldQuestion& world, double apart) {
  if (reaches_out(world)) return false;
  const SubdividedMesh refined =
      refine(world.cage, {.tolerance = apart / 2, .max_triangles = 2 * world.query.max_faces});
  if (refined.distance_to_limit >= apart) return std::nullopt;
  PairQuery pair = world.query.pair;
  pair.solid_a = Solid::all;
  return overlap(Model(refined.mesh), world.model, pair);
}

WorldQuestion in_the_world(const SubdivisionCage& posed, const Model& model, const LimitQuery& query) {
  WorldQuestion world{posed, model, query};
  world.query.pair.pose_a = {};
  return world;
}

}  // namespace

LimitDistance distance(const SubdivisionCage& surface, const Model& model, const LimitQuery& query) {
  const bool is_solid = taken_as_solid(surface, query);
  const SubdivisionCage posed = surface.posed(query.pair.pose_a);
  const WorldQuestion world = in_the_world(posed, model, query);
  const LimitFinding found = LimitSearch(posed, model, world.query, LimitGoal::distance).found();
  LimitDistance answer = found.best;
  if (found.is_proved_contact) {
    answer.lower = answer.upper = 0;
    return answer;
  }
  answer.lower = found.lower;
  const std::optional<bool> is_held = is_solid && answer.lower > 0 ? has_within(world, answer.lower) : false;
  if (!is_held) answer.lower = 0;
  if (is_held.value_or(false)) answer.lower = answer.upper = 0;
  const bool is_narrow = answer.upper - answer.lower <= query.tolerance;
  answer.status = is_narrow ? Status::exact : Status::not_converged;
  return answer;
}

LimitOverlap overlap(const SubdivisionCage& surface, const Model& model, const LimitQuery& query) {
  const bool is_solid = taken_as_solid(surface, query);
  const SubdivisionCage posed = surface.posed(query.pair.pose_a);
  const WorldQuestion world = in_the_world(posed, model, query);
  const LimitFinding found = LimitSearch(posed, model, world.query, LimitGoal::overlap).found();
  LimitOverlap answer{.overlap = true, .distance = found.best.upper, .level = found.level};
  if (found.is_proved_contact) return answer.distance = 0, answer;
  if (found.lower > 0) {
    const std::optional<bool> is_held = is_solid ? has_within(world, found.lower) : false;
    if (is_held.value_or(false)) answer.distance = 0;
    answer.overlap = is_held.value_or(true);
    answer.status = is_held ? Status::exact : Status::not_converged;
    return answer;
  }
  answer.status = found.best.upper <= query.tolerance ? Status::undecided : Status::not_converged;
  return answer;
}

}  // namespace toccata
