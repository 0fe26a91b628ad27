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

double sum_up(double a, double b) { return (a + b) * up_by_sum; }

/// At most a − b, and not below 0.
double difference_down(double a, double b) { return std::max(0.0, a - b * up_by_sum - a * 0x1p-50); }

}  // namespace

LimitSearch::LimitSearch(const SubdivisionCage& cage, const Model& model, const LimitQuery& query, LimitGoal goal)
    : model_(model), query_(query), goal_(goal), mesh_(first_level(cage)) {
  query_.pair.pose_a = {};
  query_.pair.solid_a = Solid::automatic;
  is_solid_ = taken_as_solid(model, query.pair.solid_b);
}

LimitFinding LimitSearch::found() {
  while (true) {
    look_at_level();
    finding_.level = mesh_.level;
    if (is_enough()) break;
    const std::vector<char> open = open_faces();
    const auto count = static_cast<std::size_t>(std::count(open.begin(), open.end(), 1));
    if (count == 0) break;
    finding_.is_exhausted = count > query_.max_faces / 4 || mesh_.level >= deepest_searched_level;
    if (finding_.is_exhausted) break;
    mesh_ = subdivided(mesh_, open);
  }
  finding_.lower = std::min(settled_, finding_.best.upper);
  for (const Candidate& candidate : candidates_) finding_.lower = std::min(finding_.lower, candidate.lower);
  return finding_;
}

void LimitSearch::look_at_level() {
  LimitBounds bounds(mesh_);
  candidates_.clear();
  for (Index face = 0; face < mesh_.face_count(); ++face) {
    if (!mesh_.whole[face]) continue;
    const FaceBound bound = bounds.of(face);
    const double lower = looked_at(face, sum_up(bound.to_limit, bound.from_triangles));
    if (lower <= finding_.best.upper) candidates_.push_back({face, lower});
    if (finding_.is_proved_contact) return;
  }
}

/// The least distance that the limit of the face may have; infinite where it cannot be the nearest.
double LimitSearch::looked_at(Index face, double within) {
  const std::span<const Index> c = mesh_.face(face);
  const auto triangle = [&](std::size_t i, std::size_t j) {
    return Triangle{{mesh_.points[c[0]], mesh_.points[c[i]], mesh_.points[c[j]]}};
  };
  double lower = looked_at(triangle(1, 2), face, within);
  if (c.size() == 4) lower = std::min(lower, looked_at(triangle(2, 3), face, within));
  return lower;
}

double LimitSearch::looked_at(const Triangle& triangle, Index face, double within) {
  const double limit = sum_up(finding_.best.upper, within);
  const std::optional<Distance> found = distance_within(triangle, model_, limit, query_.pair, workspace_);
  if (!found) return infinity;
  const double upper = sum_up(found->upper, within);
  if (upper < finding_.best.upper)
    finding_.best = {.upper = upper,
                     .on_mesh = found->on_a,
                     .on_model = found->on_b,
                     .distance_to_limit = within,
                     .cage_face = mesh_.cage_face[face],
                     .element = found->element_b,
                     .level = mesh_.level};
  if (is_solid_ && found->upper == 0 && is_deep_inside(triangle, within)) finding_.is_proved_contact = true;
  return difference_down(found->lower, within);
}

/// Then so is the point of the limit surface that belongs to the corner.
bool LimitSearch::is_deep_inside(const Triangle& triangle, double within) const {
  return std::any_of(triangle.vertex.begin(), triangle.vertex.end(), [&](const Vec3& corner) {
    return signed_distance(corner, model_, query_.pair.pose_b).upper < -within;
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
std::vector<char> LimitSearch::open_faces() {
  std::vector<char> open(mesh_.face_count(), 0);
  for (const Candidate& candidate : candidates_)
    if (candidate.lower > finding_.best.upper) {
      continue;
    } else if (is_open(candidate.lower)) {
      open[candidate.face] = 1;
    } else {
      settled_ = std::min(settled_, candidate.lower);
    }
  return open;
}

}  // namespace toccata
