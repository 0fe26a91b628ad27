#include "query/subdivision/refinement_rules.hpp"

#include <algorithm>
#include <cmath>

#include "math/constants.hpp"
#include "toccata/math/trigonometry.hpp"

namespace toccata {
namespace {

Vec3 midpoint(const Vec3& a, const Vec3& b) { return 0.5 * a + 0.5 * b; }

Vec3 blended(const Vec3& smooth, const Vec3& sharp, double share_of_sharp) {
  return smooth + share_of_sharp * (sharp - smooth);
}

/// v and what it is moved by the differences of its neighbours from it, which are exact where all are equal.
Vec3 smooth_vertex_point(const LevelMesh& mesh, Index vertex, const Spokes& spokes) {
  const Vec3& v = mesh.points[vertex];
  const double valence = spokes.count();
  Vec3 sum{};
  for (const Index end : spokes.ends) sum += mesh.points[end] - v;
  if (mesh.scheme == SubdivisionScheme::loop) return v + loop_weight(spokes.count()) * sum;
  for (const Index side : mesh.sides_at(vertex)) sum += mesh.face_points[mesh.face_of_side[side]] - v;
  return v + sum / (valence * valence);
}

/// The new place of a vertex of a crease, by the two ends whose edges are sharp.
Vec3 crease_vertex_point(const LevelMesh& mesh, Index vertex, const Spokes& spokes, std::span<const double> sharpness) {
  Vec3 ends{};
  for (Index i = 0; i < spokes.count(); ++i)
    if (sharpness[i] > 0) ends += mesh.points[spokes.ends[i]];
  return 0.75 * mesh.points[vertex] + 0.125 * ends;
}

Vec3 point_by_rule(const LevelMesh& mesh, Index vertex, const Spokes& spokes, VertexRule rule,
                   std::span<const double> sharpness) {
  if (rule == VertexRule::corner) return mesh.points[vertex];
  if (rule == VertexRule::crease) return crease_vertex_point(mesh, vertex, spokes, sharpness);
  return smooth_vertex_point(mesh, vertex, spokes);
}

/// The mean of those sharpnesses that end with this level: how much of the sharper rule remains.
double ending_share(const Spokes& spokes, double vertex_sharpness) {
  double sum = 0;
  Index count = 0;
  const auto add = [&](double sharpness) {
    if (sharpness <= 0 || child_sharpness(sharpness) > 0) return;
    sum += sharpness;
    ++count;
  };
  add(vertex_sharpness);
  for (const double sharpness : spokes.sharpness) add(sharpness);
  return count == 0 ? 0 : std::min(sum / count, 1.0);
}

}  // namespace

VertexRule vertex_rule(double vertex_sharpness, std::span<const double> spoke_sharpness) {
  const auto sharp = std::count_if(spoke_sharpness.begin(), spoke_sharpness.end(), [](double s) { return s > 0; });
  if (vertex_sharpness > 0 || sharp > 2) return VertexRule::corner;
  return sharp == 0 ? VertexRule::smooth : sharp == 1 ? VertexRule::dart : VertexRule::crease;
}

double child_sharpness(double sharpness) { return is_for_ever(sharpness) ? sharpness : std::max(sharpness - 1, 0.0); }

double loop_weight(Index valence) {
  if (valence == 6) return 0.0625;
  const double root = 0.375 + 0.25 * sine_cosine_of_turns(1.0 / valence).cosine;
  return (0.625 - root * root) / valence;
}

Vec3 point_for_vertex(const LevelMesh& mesh, Index vertex, Spokes& spokes) {
  spokes.gather(mesh, vertex);
  const double sharpness = mesh.vertex_sharpness[vertex];
  const VertexRule rule = vertex_rule(sharpness, spokes.sharpness);
  const Vec3 point = point_by_rule(mesh, vertex, spokes, rule, spokes.sharpness);
  if (rule == VertexRule::smooth || rule == VertexRule::dart) return point;

  std::vector<double> later;
  for (const double s : spokes.sharpness) later.push_back(child_sharpness(s));
  const VertexRule later_rule = vertex_rule(child_sharpness(sharpness), later);
  if (later_rule == rule) return point;
  return blended(point_by_rule(mesh, vertex, spokes, later_rule, later), point, ending_share(spokes, sharpness));
}

Vec3 point_for_edge(const LevelMesh& mesh, Index edge) {
  const LevelEdge& e = mesh.edges[edge];
  const Vec3 &a = mesh.points[e.ends[0]], &b = mesh.points[e.ends[1]];
  if (e.sharpness >= 1) return midpoint(a, b);
  Vec3 smooth;
  if (mesh.scheme == SubdivisionScheme::loop) {
    const Vec3& c = mesh.points[mesh.end_of(mesh.next(e.sides[0]))];
    const Vec3& d = mesh.points[mesh.end_of(mesh.next(e.sides[1]))];
    smooth = 0.375 * (a + b) + 0.125 * (c + d);
  } else {
    const Vec3& c = mesh.face_points[mesh.face_of_side[e.sides[0]]];
    const Vec3& d = mesh.face_points[mesh.face_of_side[e.sides[1]]];
    smooth = 0.25 * ((a + b) + (c + d));
  }
  return e.sharpness > 0 ? blended(smooth, midpoint(a, b), e.sharpness) : smooth;
}

Vec3 point_for_face(const LevelMesh& mesh, Index face) {
  Vec3 sum{};
  for (const Index corner : mesh.face(face)) sum += mesh.points[corner];
  return sum / static_cast<double>(mesh.corner_count(face));
}

double rule_rounding(const LevelMesh& mesh) {
  const double roundings = 8.0 * mesh.most_neighbours + 64;
  return roundings * (unit_roundoff * mesh.largest_coordinate + std::numeric_limits<double>::denorm_min());
}

}  // namespace toccata
