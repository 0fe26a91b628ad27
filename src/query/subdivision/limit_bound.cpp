#include "query/subdivision/limit_bound.hpp"

#include <algorithm>
#include <cmath>

#include "math/constants.hpp"

namespace toccata {
namespace {

/// The roundings of differences of four points at most, each rounded three times, and of the length; a length of three
/// coordinates is less than twice the largest.
constexpr double difference_roundings = 32;

/// A factor for the rounding of lengths, sums and products of a bound.
constexpr double up_by_lengths = 1 + 0x1p-48;

double difference_slack(const LevelMesh& mesh) {
  return difference_roundings * (unit_roundoff * mesh.largest_coordinate + std::numeric_limits<double>::denorm_min());
}

bool will_end(double sharpness) { return sharpness > 0 && !is_for_ever(sharpness); }

Index sharp_count(const Spokes& spokes) {
  return static_cast<Index>(
      std::count_if(spokes.sharpness.begin(), spokes.sharpness.end(), [](double s) { return s > 0; }));
}

/// The neighbour of the vertex in a face other than that along the side, which begins or ends at it.
Index neighbour_beside(const LevelMesh& mesh, Index vertex, Index side) {
  if (mesh.corners[side] == vertex) return mesh.corners[mesh.previous(side)];
  return mesh.end_of(mesh.next(side));
}

bool is_even_crease(const LevelMesh& mesh, Index vertex, const Spokes& spokes) {
  const auto is_sharp = [&](Index other) { return mesh.edges[mesh.edge_between(vertex, other)].sharpness > 0; };
  for (Index i = 0; i < spokes.count(); ++i) {
    if (spokes.sharpness[i] > 0) continue;
    for (const Index side : mesh.edges[spokes.edges[i]].sides)
      if (!is_sharp(neighbour_beside(mesh, vertex, side))) return false;
  }
  return true;
}

double crease_difference(const LevelMesh& mesh, Index vertex, const Spokes& spokes) {
  Vec3 ends{};
  for (Index i = 0; i < spokes.count(); ++i)
    if (spokes.sharpness[i] > 0) ends += mesh.points[spokes.ends[i]];
  return length(ends - 2 * mesh.points[vertex]);
}

double face_twist(const LevelMesh& mesh, Index face) {
  const std::span<const Index> c = mesh.face(face);
  return length((mesh.points[c[0]] - mesh.points[c[1]]) + (mesh.points[c[2]] - mesh.points[c[3]]));
}

}  // namespace

double LimitBounds::across(Index vertex, const LevelEdge& edge) const {
  const auto beside = [&](std::size_t i) { return mesh_.points[neighbour_beside(mesh_, vertex, edge.sides[i])]; };
  if (mesh_.scheme == SubdivisionScheme::catmull_clark)
    return length((beside(0) + beside(1)) - 2 * mesh_.points[vertex]);
  return length((beside(0) + beside(1)) - (mesh_.points[edge.ends[0]] + mesh_.points[edge.ends[1]]));
}

void LimitBounds::measure_spoke(Index vertex, Index edge, VertexRule rule, Surroundings& found) const {
  const LevelEdge& spoke = mesh_.edges[edge];
  double& most = found.differences[0];
  const bool is_sharp = spoke.sharpness > 0;
  if (is_sharp && rule != VertexRule::dart) return;
  most = std::max(most, across(vertex, spoke));
  if (is_sharp || mesh_.scheme == SubdivisionScheme::loop) return;
  most = std::max(most, across(spoke.ends[0] == vertex ? spoke.ends[1] : spoke.ends[0], spoke));
}

LimitBounds::Surroundings LimitBounds::looked_at(Index vertex) {
  Surroundings found;
  found.is_known = true;
  spokes_.gather(mesh_, vertex);
  const Index sharp = sharp_count(spokes_);
  const bool ends = std::any_of(spokes_.sharpness.begin(), spokes_.sharpness.end(), will_end);
  found.is_settled = !ends && !will_end(mesh_.vertex_sharpness[vertex]);
  found.has_creases = sharp > 0;
  const VertexRule rule = vertex_rule(mesh_.vertex_sharpness[vertex], spokes_.sharpness);
  VertexKind kind{.rule = rule, .valence = spokes_.count()};
  kind.has_smooth_edge = sharp < spokes_.count();
  if (rule == VertexRule::crease) {
    kind.is_even = is_even_crease(mesh_, vertex, spokes_);
    found.differences[2] = crease_difference(mesh_, vertex, spokes_);
  }
  for (const Index edge : spokes_.edges) measure_spoke(vertex, edge, rule, found);
  if (mesh_.scheme == SubdivisionScheme::catmull_clark)
    for (const Index side : mesh_.sides_at(vertex))
      found.differences[1] = std::max(found.differences[1], face_twist(mesh_, mesh_.face_of_side[side]));
  const Index regular = mesh_.scheme == SubdivisionScheme::loop ? 6 : 4;
  found.is_regular = rule == VertexRule::smooth && spokes_.count() == regular;
  found.growth = growth_at(mesh_.scheme, kind);
  return found;
}

const LimitBounds::Surroundings& LimitBounds::around(Index vertex) {
  if (!known_[vertex].is_known) known_[vertex] = looked_at(vertex);
  return known_[vertex];
}

const Aabb& LimitBounds::box_around(Index vertex) {
  Aabb& box = boxes_[vertex];
  if (!is_empty(box)) return box;
  for (const Index side : mesh_.sides_at(vertex))
    for (const Index corner : mesh_.face(mesh_.face_of_side[side])) box = merge(box, mesh_.points[corner]);
  return box;
}

/// Both the limit and the face lie in the hull of the corners of all faces that touch it. Its box is known from what
/// each corner of the face has around it, so a vertex of many faces is not looked at by each of them anew.
double LimitBounds::by_hull(Index face) {
  Aabb box;
  for (const Index corner : mesh_.face(face)) box = merge(box, box_around(corner));
  double farthest = 0;
  for (const Index own : mesh_.face(face)) {
    const Vec3& p = mesh_.points[own];
    Vec3 off;
    for (int axis = 0; axis < 3; ++axis) off[axis] = std::max(p[axis] - box.lower[axis], box.upper[axis] - p[axis]);
    farthest = std::max(farthest, length(off));
  }
  return farthest + difference_slack(mesh_);
}

LimitBounds::FaceDifferences LimitBounds::differences_around(Index face) {
  FaceDifferences all;
  bool has_creases = false;
  for (const Index corner : mesh_.face(face)) {
    const Surroundings& found = around(corner);
    all.is_settled = all.is_settled && found.is_settled;
    all.is_regular = all.is_regular && found.is_regular;
    has_creases = has_creases || found.has_creases;
    for (std::size_t i = 0; i < 3; ++i) all.differences[i] = std::max(all.differences[i], found.differences[i]);
    all.growth.include(found.growth);
  }
  for (double& difference : all.differences) difference += difference_slack(mesh_);
  all.growth.include(growth_at_new_vertices(mesh_.scheme, has_creases));
  return all;
}

FaceBound LimitBounds::of(Index face) {
  const FaceDifferences found = differences_around(face);
  FaceBound bound{.to_limit = infinity};
  if (found.is_settled) bound.to_limit = moved_by_all_levels(found.growth, found.differences);
  if (!found.is_regular) bound.to_limit = std::min(bound.to_limit, by_hull(face));
  bound.to_limit = bound.to_limit * up_by_lengths + rounding_of_bounds(mesh_);
  if (mesh_.scheme == SubdivisionScheme::catmull_clark)
    bound.from_triangles = up_by_lengths * (face_twist(mesh_, face) + difference_slack(mesh_)) / 4;
  return bound;
}

/// A vector is less than twice as long as its largest coordinate.
double rounding_of_bounds(const LevelMesh& mesh) { return 2 * mesh.rounding; }

}  // namespace toccata
