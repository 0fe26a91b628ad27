#include "toccata/query/subdivision.hpp"

#include <algorithm>
#include <optional>

#include "query/subdivision/limit_inside.hpp"
#include "query/subdivision/limit_search.hpp"
#include "toccata/bounds/aabb.hpp"
#include "toccata/core/error.hpp"
#include "toccata/query/signed_distance.hpp"

namespace toccata {
namespace {

/// How near a point of a limit surface must be known, of how far it is from the other, to tell whether it is within.
constexpr double share_of_distance = 0.25;

/// The meshes in which points are looked for that lie deep within: so much of the cage's size from the limit, and no
/// more triangles than a moment allows.
constexpr double share_of_size = 1.0 / 256;
constexpr std::size_t most_triangles_to_probe = std::size_t{1} << 14;

/// Whether the cage is taken as a solid; checks the question.
bool taken_as_solid(const SubdivisionCage& cage, Solid solid, const Pose& pose) {
  if (solid == Solid::all && !cage.closed())
    throw Error("the cage has a border, so its limit surface encloses nothing: close it, or ask about a surface");
  if (!cage.closed() || solid == Solid::none) return false;
  if (is_singular(pose.linear))
    throw Error("the pose of the cage is singular and leaves no solid: ask about a surface (Solid::none)");
  return true;
}

void check_limit_query(const LimitQuery& query) {
  if (!(query.tolerance > 0)) throw Error("the tolerance of a question about a limit surface must be positive");
}

/// A limit surface and what it is asked about, both in the world.
class LimitPair {
 public:
  LimitPair(const SubdivisionCage& surface, const Model& model, const LimitQuery& query)
      : query_(query), first_(surface.posed(query.pair.pose_a)), model_(model) {
    check_limit_query(query);
    first_is_solid_ = taken_as_solid(surface, query.pair.solid_a, query.pair.pose_a);
  }
  LimitPair(const SubdivisionCage& surface, const SubdivisionCage& other, const LimitQuery& query)
      : query_(query), first_(surface.posed(query.pair.pose_a)), second_(other.posed(query.pair.pose_b)) {
    check_limit_query(query);
    first_is_solid_ = taken_as_solid(surface, query.pair.solid_a, query.pair.pose_a);
    second_is_solid_ = taken_as_solid(other, query.pair.solid_b, query.pair.pose_b);
  }

  [[nodiscard]] LimitDistance distance() const;
  [[nodiscard]] LimitOverlap overlap() const;

 private:
  [[nodiscard]] LimitFinding found(LimitGoal goal) const;
  [[nodiscard]] std::optional<bool> has_within(double apart) const;

  LimitQuery query_;
  SubdivisionCage first_;
  std::optional<SubdivisionCage> second_;
  std::optional<Model> model_;
  bool first_is_solid_ = false;
  bool second_is_solid_ = false;
};

/// Some vertex of a coarse mesh of the one that lies deeper within a coarse mesh of the other than both are from their
/// limits.
bool is_surely_within(const SubdividedMesh& mesh, const SubdividedMesh& solid) {
  const Model model(solid.mesh);
  const Aabb box = model.bounds();
  const double needed = mesh.distance_to_limit + solid.distance_to_limit;
  return std::any_of(mesh.mesh.vertices().begin(), mesh.mesh.vertices().end(), [&](const Vec3& p) {
    return toccata::overlap(box, Aabb{p, p}) && signed_distance(p, model).upper < -needed;
  });
}

SubdividedMesh probing_mesh(const SubdivisionCage& cage) {
  const Aabb box = fit_aabb(cage.polygons().vertices);
  const double size = length(box.upper - box.lower);
  return refine(cage, {.tolerance = std::max(share_of_size * size, least_tolerance(cage)),
                       .max_triangles = most_triangles_to_probe});
}

LimitFinding LimitPair::found(LimitGoal goal) const {
  if (!second_) return LimitSearch(first_, *model_, query_, goal).found();
  const bool boxes_meet =
      toccata::overlap(fit_aabb(first_.polygons().vertices), fit_aabb(second_->polygons().vertices));
  if (boxes_meet && (first_is_solid_ || second_is_solid_)) {
    const SubdividedMesh first = probing_mesh(first_), second = probing_mesh(*second_);
    if ((second_is_solid_ && is_surely_within(first, second)) || (first_is_solid_ && is_surely_within(second, first)))
      return {.best = {.upper = 0}, .is_proved_contact = true};
  }
  return LimitSearch(first_, *second_, query_, goal).found();
}

/// Whether some part of one of two surfaces that are at least `apart` lies within the other; nothing where a cage would
/// have to be refined too far to know. No part is on both sides, so one point of each tells.
std::optional<bool> LimitPair::has_within(double apart) const {
  const std::size_t most = 2 * query_.max_faces;
  const double radius = share_of_distance * apart;
  std::optional<bool> first_has = false, second_has = false;
  if (first_is_solid_)
    first_has = has_point_within(
        first_, second_ ? points_of_parts(*second_, radius) : points_of_parts(*model_, query_.pair.pose_b), most);
  if (second_is_solid_) second_has = has_point_within(*second_, points_of_parts(first_, radius), most);
  if (first_has.value_or(false) || second_has.value_or(false)) return true;
  if (!first_has || !second_has) return std::nullopt;
  return false;
}

LimitDistance LimitPair::distance() const {
  const LimitFinding finding = found(LimitGoal::distance);
  LimitDistance answer = finding.best;
  answer.lower = finding.is_proved_contact ? 0 : finding.lower;
  const std::optional<bool> is_held = answer.lower > 0 ? has_within(answer.lower) : false;
  if (!is_held) answer.lower = 0;
  if (is_held.value_or(false) || finding.is_proved_contact) answer.lower = answer.upper = 0;
  const bool is_narrow = answer.upper - answer.lower <= query_.tolerance;
  answer.status = is_narrow ? Status::exact : Status::not_converged;
  return answer;
}

LimitOverlap LimitPair::overlap() const {
  const LimitFinding finding = found(LimitGoal::overlap);
  LimitOverlap answer{.overlap = true, .distance = finding.best.upper, .level = finding.level};
  if (finding.is_proved_contact) return answer.distance = 0, answer;
  if (finding.lower > 0) {
    const std::optional<bool> is_held = has_within(finding.lower);
    if (is_held.value_or(false)) answer.distance = 0;
    answer.overlap = is_held.value_or(true);
    answer.status = is_held ? Status::exact : Status::not_converged;
    return answer;
  }
  answer.status = finding.best.upper <= query_.tolerance ? Status::undecided : Status::not_converged;
  return answer;
}

}  // namespace

LimitDistance distance(const SubdivisionCage& surface, const Model& model, const LimitQuery& query) {
  return LimitPair(surface, model, query).distance();
}

LimitDistance distance(const SubdivisionCage& a, const SubdivisionCage& b, const LimitQuery& query) {
  return LimitPair(a, b, query).distance();
}

LimitOverlap overlap(const SubdivisionCage& surface, const Model& model, const LimitQuery& query) {
  return LimitPair(surface, model, query).overlap();
}

LimitOverlap overlap(const SubdivisionCage& a, const SubdivisionCage& b, const LimitQuery& query) {
  return LimitPair(a, b, query).overlap();
}

}  // namespace toccata
