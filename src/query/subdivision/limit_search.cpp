#include "query/subdivision/limit_search.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "math/constants.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/query/signed_distance.hpp"

namespace toccata {
namespace {

/// Deeper than this doubles do not resolve what is near a point.
constexpr int deepest_searched_level = 60;

/// More than the rounding of a sum of two.
constexpr double up_by_sum = 1 + 0x1p-50;

/// A bound that is no more than so many times what rounding contributes is not worth another level, which adds to that.
constexpr double worth_of_rounding = 4;

double sum_up(double a, double b) { return (a + b) * up_by_sum; }

/// At most a − b, and not below 0.
double difference_down(double a, double b) { return std::max(0.0, a - b * up_by_sum - a * 0x1p-50); }

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

LimitSearch::LimitSearch(const SubdivisionCage& cage, const Model& model, const LimitQuery& query, LimitGoal goal)
    : query_(query), goal_(goal) {
  PairQuery pair = query.pair;
  pair.pose_a = {};
  pair.solid_a = Solid::automatic;
  is_solid_ = taken_as_solid(model, query.pair.solid_b);
  model_ = Opposite{model, 0, pair, {}};
  sides_.push_back({first_level(cage), {}, {}});
}

LimitSearch::LimitSearch(const SubdivisionCage& cage, const SubdivisionCage& other, const LimitQuery& query,
                         LimitGoal goal)
    : query_(query), goal_(goal) {
  sides_.push_back({first_level(cage), {}, {}});
  sides_.push_back({first_level(other), {}, {}});
}

LimitFinding LimitSearch::found() {
  do {
    look_at_level();
    finding_.level = sides_[0].mesh.level;
  } while (!is_enough() && refine_open_faces());
  finding_.lower = std::min(settled_, finding_.best.upper);
  for (const CageSide& side : sides_)
    for (const Candidate& candidate : side.candidates) finding_.lower = std::min(finding_.lower, candidate.lower);
  return finding_;
}

void LimitSearch::look_at_level() {
  for (CageSide& side : sides_) side.within = bounds_of_faces(side.mesh);
  if (model_) return look_at(sides_[0], *model_, true);
  const Opposite second = as_opposite(sides_[1]);
  const Opposite first = as_opposite(sides_[0]);
  look_at(sides_[0], second, true);
  look_at(sides_[1], first, false);
}

/// All that is left of it as one mesh, of which the least near its limit counts.
LimitSearch::Opposite LimitSearch::as_opposite(const CageSide& side) {
  const LevelMesh& mesh = side.mesh;
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Index> faces;
  double within = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (!mesh.whole[f]) continue;
    within = std::max(within, side.within[f]);
    const std::span<const Index> c = mesh.face(f);
    for (std::size_t i = 2; i < c.size(); ++i) {
      triangles.push_back({c[0], c[i - 1], c[i]});
      faces.push_back(mesh.cage_face[f]);
    }
  }
  PairQuery pair;
  pair.solid_b = Solid::none;
  return {Model(TriangleMesh(mesh.points, std::move(triangles))), within, pair, std::move(faces)};
}

void LimitSearch::look_at(CageSide& side, const Opposite& opposite, bool is_first) {
  side.candidates.clear();
  const double rounding = worth_of_rounding * rounding_of_bounds(side.mesh);
  for (Index face = 0; face < side.mesh.face_count(); ++face) {
    if (!side.mesh.whole[face]) continue;
    const double lower = looked_at(side, face, opposite, is_first);
    if (lower <= finding_.best.upper) side.candidates.push_back({face, lower, side.within[face] <= rounding});
    if (finding_.is_proved_contact) return;
  }
}

/// The least distance that the limit of the face may have; infinite where it cannot be the nearest.
double LimitSearch::looked_at(const CageSide& side, Index face, const Opposite& opposite, bool is_first) {
  const std::span<const Index> c = side.mesh.face(face);
  const auto triangle = [&](std::size_t i, std::size_t j) {
    return Triangle{{side.mesh.points[c[0]], side.mesh.points[c[i]], side.mesh.points[c[j]]}};
  };
  double lower = looked_at(side, triangle(1, 2), face, opposite, is_first);
  if (c.size() == 4) lower = std::min(lower, looked_at(side, triangle(2, 3), face, opposite, is_first));
  return lower;
}

double LimitSearch::looked_at(const CageSide& side, const Triangle& triangle, Index face, const Opposite& opposite,
                              bool is_first) {
  const double within = side.within[face];
  const double both = sum_up(within, opposite.within);
  const double limit = sum_up(finding_.best.upper, both);
  const std::optional<Distance> found = distance_within(triangle, opposite.model, limit, opposite.pair, workspace_);
  if (!found) return infinity;
  const double upper = sum_up(found->upper, both);
  if (is_first && upper < finding_.best.upper)
    finding_.best = {
        .upper = upper,
        .on_mesh = found->on_a,
        .on_model = found->on_b,
        .distance_to_limit = within,
        .cage_face = side.mesh.cage_face[face],
        .element = opposite.cage_faces.empty() ? found->element_b : opposite.cage_faces[found->element_b],
        .level = side.mesh.level};
  if (is_solid_ && found->upper == 0 && is_deep_inside(triangle, within)) finding_.is_proved_contact = true;
  return difference_down(found->lower, both);
}

/// Then so is the point of the limit surface that belongs to the corner.
bool LimitSearch::is_deep_inside(const Triangle& triangle, double within) const {
  return std::any_of(triangle.vertex.begin(), triangle.vertex.end(), [&](const Vec3& corner) {
    return signed_distance(corner, model_->model, query_.pair.pose_b).upper < -within;
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
std::vector<char> LimitSearch::open_faces(const CageSide& side) {
  std::vector<char> open(side.mesh.face_count(), 0);
  for (const Candidate& candidate : side.candidates)
    if (candidate.lower > finding_.best.upper) {
      continue;
    } else if (is_open(candidate.lower) && !candidate.is_settled) {
      open[candidate.face] = 1;
    } else {
      settled_ = std::min(settled_, candidate.lower);
    }
  return open;
}

/// Whether there were any, on every side, and not too many. Where one side has none, what the other has is settled.
bool LimitSearch::refine_open_faces() {
  std::vector<std::vector<char>> open;
  for (const CageSide& side : sides_) {
    open.push_back(open_faces(side));
    const auto count = static_cast<std::size_t>(std::count(open.back().begin(), open.back().end(), 1));
    if (count == 0 || count > query_.max_faces / 4 || side.mesh.level >= deepest_searched_level) return false;
  }
  for (std::size_t i = 0; i < sides_.size(); ++i) sides_[i].mesh = subdivided(sides_[i].mesh, open[i]);
  return true;
}

}  // namespace toccata
