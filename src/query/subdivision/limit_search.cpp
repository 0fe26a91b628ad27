#include "query/subdivision/limit_search.hpp"

#include <utility>

#include "math/constants.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/query/signed_distance.hpp"

namespace toccata {
namespace {

/// Deeper than this doubles do not resolve what is near a point.
constexpr int deepest_searched_level = 60;

/// A bound that is no more than so many times what rounding contributes is not worth another level, which adds to that.
constexpr double worth_of_rounding = 4;

std::vector<double> bounds_of_faces(const LevelMesh& mesh) {
  LimitBounds bounds(mesh);
  std::vector<double> within(mesh.face_count(), 0);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (!mesh.whole[f]) continue;
    const FaceBound bound = bounds.of(f);
    within[f] = sum_up(bound.to_limit, bound.from_triangles);
  }
  return within;
}

}  // namespace

void CageSide::keep(const std::vector<double>& lowers, double upper) {
  const double rounding = worth_of_rounding * rounding_of_bounds(mesh);
  candidates.clear();
  for (Index face = 0; face < mesh.face_count(); ++face)
    if (mesh.whole[face] && lowers[face] <= upper) candidates.push_back({face, lowers[face], within[face] <= rounding});
}

double CageSide::least() const {
  double least = infinity;
  for (const Candidate& candidate : candidates) least = std::min(least, candidate.lower);
  return least;
}

std::vector<Triangle> CageSide::triangles_of(Index face) const {
  const std::span<const Index> c = mesh.face(face);
  std::vector<Triangle> triangles;
  for (std::size_t i = 2; i < c.size(); ++i)
    triangles.push_back({{mesh.points[c[0]], mesh.points[c[i - 1]], mesh.points[c[i]]}});
  return triangles;
}

LimitSearch::LimitSearch(const SubdivisionCage& cage, const Model& model, const LimitQuery& query, LimitGoal goal)
    : query_(query),
      goal_(goal),
      model_(model),
      comparisons_{std::max<std::size_t>(query.max_comparisons, 1), query.progress} {
  query_.pair.pose_a = {};
  query_.pair.solid_a = Solid::automatic;
  is_solid_ = taken_as_solid(model, query.pair.solid_b);
  sides_.emplace_back(cage);
}

LimitSearch::LimitSearch(const SubdivisionCage& cage, const SubdivisionCage& other, const LimitQuery& query,
                         LimitGoal goal)
    : query_(query), goal_(goal), comparisons_{std::max<std::size_t>(query.max_comparisons, 1), query.progress} {
  sides_.emplace_back(cage);
  sides_.emplace_back(other);
}

LimitFinding LimitSearch::found() {
  do {
    look_at_level();
    if (comparisons_.are_spent()) break;  // not all of the level was looked at: what the one before proved stands
    finding_.level = sides_[0].mesh.level;
    finding_.lower = proved_lower();
  } while (!is_enough() && refine_open_faces());
  finding_.lower = std::min(finding_.lower, finding_.best.upper);
  return finding_;
}

/// Every pair of faces that is left has one of each side, so each side alone has a bound of them all.
double LimitSearch::proved_lower() const {
  double left = 0;
  for (const CageSide& side : sides_) left = std::max(left, side.least());
  return std::min({settled_, finding_.best.upper, left});
}

void LimitSearch::look_at_level() {
  for (CageSide& side : sides_) side.within = bounds_of_faces(side.mesh);
  if (model_) return look_at_model();
  look_at_both();
}

void LimitSearch::look_at_model() {
  CageSide& side = sides_[0];
  std::vector<double> lowers(side.mesh.face_count(), infinity);
  for (Index face = 0; face < side.mesh.face_count() && !finding_.is_proved_contact; ++face) {
    if (comparisons_.are_spent()) return;
    if (!side.mesh.whole[face]) continue;
    comparisons_.count();
    for (const Triangle& triangle : side.triangles_of(face))
      lowers[face] = std::min(lowers[face], looked_at(triangle, face));
  }
  side.keep(lowers, finding_.best.upper);
}

void LimitSearch::look_at_both() {
  const PairOfSides found = nearest_of_sides(sides_[0], sides_[1], finding_.best, comparisons_);
  finding_.best = found.best;
  for (std::size_t i = 0; i < 2; ++i) sides_[i].keep(found.lowers[i], found.best.upper);
}

/// The least distance that the limit of the face may have; infinite where it cannot be the nearest.
double LimitSearch::looked_at(const Triangle& triangle, Index face) {
  const double within = sides_[0].within[face];
  const double limit = sum_up(finding_.best.upper, within);
  const std::optional<Distance> found = distance_within(triangle, *model_, limit, query_.pair, workspace_);
  if (!found) return infinity;
  const double upper = sum_up(found->upper, within);
  if (upper < finding_.best.upper)
    finding_.best = {.upper = upper,
                     .on_mesh = found->on_a,
                     .on_model = found->on_b,
                     .distance_to_limit = within,
                     .cage_face = sides_[0].mesh.cage_face[face],
                     .element = found->element_b,
                     .level = sides_[0].mesh.level};
  if (is_solid_ && found->upper == 0 && is_deep_inside(triangle, within)) finding_.is_proved_contact = true;
  return difference_down(found->lower, within);
}

/// Then so is the point of the limit surface that belongs to the corner.
bool LimitSearch::is_deep_inside(const Triangle& triangle, double within) const {
  return std::any_of(triangle.vertex.begin(), triangle.vertex.end(), [&](const Vec3& corner) {
    return signed_distance(corner, *model_, query_.pair.pose_b).upper < -within;
  });
}

bool LimitSearch::is_open(double lower) const {
  return goal_ == LimitGoal::overlap ? lower <= 0 : lower < finding_.best.upper - query_.tolerance;
}

bool LimitSearch::is_enough() const {
  if (finding_.is_proved_contact) return true;
  return goal_ == LimitGoal::overlap && finding_.best.upper <= query_.tolerance;
}

/// What else may count is settled.
LimitSearch::OpenFaces LimitSearch::open_faces(const CageSide& side) const {
  OpenFaces open{std::vector<char>(side.mesh.face_count(), 0), 0, infinity};
  for (const CageSide::Candidate& candidate : side.candidates)
    if (candidate.lower > finding_.best.upper) {
      continue;
    } else if (is_open(candidate.lower) && !candidate.is_settled) {
      open.marks[candidate.face] = 1;
      ++open.count;
    } else {
      open.settled = std::min(open.settled, candidate.lower);
    }
  return open;
}

/// Whether there were any, on every side, and not too many.
bool LimitSearch::refine_open_faces() {
  std::vector<OpenFaces> open;
  for (const CageSide& side : sides_) {
    open.push_back(open_faces(side));
    const std::size_t count = open.back().count;
    if (count == 0 || count > query_.max_faces / 4 || side.mesh.level >= deepest_searched_level) return false;
  }
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    settled_ = std::min(settled_, open[i].settled);
    sides_[i].mesh = subdivided(sides_[i].mesh, open[i].marks);
  }
  return true;
}

}  // namespace toccata
