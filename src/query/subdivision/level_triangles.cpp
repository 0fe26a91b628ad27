#include "query/subdivision/level_triangles.hpp"

#include <algorithm>
#include <utility>

#include "math/constants.hpp"
#include "query/subdivision/refinement_rules.hpp"

namespace toccata {
namespace {

/// What `own` points are off by, in units of the roundoff of the largest coordinate, with the length of a difference.
constexpr double border_roundings = 32;

constexpr double up_by_distances = 1 + 0x1p-48;

double border_slack(const LevelMesh& mesh) { return border_roundings * unit_roundoff * mesh.largest_coordinate; }

}  // namespace

LevelTriangles::LevelTriangles(const AdaptiveLevels& levels) : levels_(levels) {
  for (const LevelMesh& mesh : levels.meshes) known_.emplace_back(mesh.points.size(), no_index);
  for (std::size_t level = 0; level < levels.meshes.size(); ++level)
    for (Index f = 0; f < levels.meshes[level].face_count(); ++f)
      if (levels.meshes[level].whole[f] && !levels.refined[level][f]) add_leaf(level, f);
}

Index LevelTriangles::point_of(std::size_t level, Index vertex) {
  while (level + 1 < levels_.meshes.size() && levels_.meshes[level].point_of_vertex[vertex] != no_index)
    vertex = levels_.meshes[level++].point_of_vertex[vertex];
  Index& point = known_[level][vertex];
  if (point == no_index) {
    point = static_cast<Index>(points_.size());
    points_.push_back(levels_.meshes[level].points[vertex]);
  }
  return point;
}

/// The points within the side, in its direction, that the face beside it has because it was refined.
void LevelTriangles::add_between(std::size_t level, Index side, double from, double to, std::vector<Between>& found) {
  const LevelMesh& mesh = levels_.meshes[level];
  if (!levels_.refined[level][mesh.face_of_side[side]]) return;
  const LevelMesh& finer = levels_.meshes[level + 1];
  // The first side of a child goes from its vertex along the parent's side; its last comes back to its vertex.
  const Index first_half = finer.first_side[mesh.child_of_side[side]];
  const Index second_half = finer.first_side[mesh.child_of_side[mesh.next(side)] + 1] - 1;
  const double middle = (from + to) / 2;
  add_between(level + 1, first_half, from, middle, found);
  found.push_back({point_of(level + 1, mesh.point_of_edge[mesh.edge_of_side[side]]), middle});
  add_between(level + 1, second_half, middle, to, found);
}

void LevelTriangles::take_border(std::size_t level, Index face) {
  const LevelMesh& mesh = levels_.meshes[level];
  border_.clear();
  std::vector<Between> between;
  for (Index side = mesh.first_side[face]; side < mesh.first_side[face + 1]; ++side) {
    const Vec3 &begin = mesh.points[mesh.corners[side]], &end = mesh.points[mesh.end_of(side)];
    border_.push_back({point_of(level, mesh.corners[side]), begin});
    const Index other = mesh.twin(side);
    if (other == no_index) continue;
    between.clear();
    add_between(level, other, 1, 0, between);
    std::reverse(between.begin(), between.end());
    for (const Between& b : between) border_.push_back({b.point, begin + b.share * (end - begin)});
  }
}

void LevelTriangles::add_fan(std::size_t level, Index face, double distance) {
  const LevelMesh& mesh = levels_.meshes[level];
  const auto middle = static_cast<Index>(points_.size());
  points_.push_back(point_for_face(mesh, face));
  for (std::size_t i = 0; i < border_.size(); ++i)
    triangles_.push_back(
        {{middle, border_[i].point, border_[(i + 1) % border_.size()].point}, mesh.cage_face[face], distance});
}

/// Along its shorter diagonal; but from a vertex of two faces, which both have the other, and would lie upon each
/// other.
void LevelTriangles::add_quadrangle(const LevelMesh& mesh, Index face, double distance) {
  const auto corner = [this](std::size_t i) { return border_[i % 4].point; };
  const double one = length(points_[corner(2)] - points_[corner(0)]);
  std::size_t begin = length(points_[corner(3)] - points_[corner(1)]) < one ? 1 : 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::span<const Index> sides = mesh.sides_at(mesh.face(face)[i]);
    if (sides.size() == 2 && mesh.twin(sides[0]) != no_index && mesh.twin(sides[1]) != no_index) begin = i % 2;
  }
  const Index cage_face = mesh.cage_face[face];
  triangles_.push_back({{corner(begin), corner(begin + 1), corner(begin + 2)}, cage_face, distance});
  triangles_.push_back({{corner(begin), corner(begin + 2), corner(begin + 3)}, cage_face, distance});
}

void LevelTriangles::add_leaf(std::size_t level, Index face) {
  const LevelMesh& mesh = levels_.meshes[level];
  take_border(level, face);
  double moved = 0;
  for (const BorderPoint& b : border_) moved = std::max(moved, length(points_[b.point] - b.own));
  const FaceBound& bound = levels_.bounds[level][face];
  const double slack = border_slack(mesh);
  const double distance = up_by_distances * (bound.to_limit + bound.from_triangles + moved + slack);
  if (border_.size() > mesh.corner_count(face)) return add_fan(level, face, distance);
  if (border_.size() == 4) return add_quadrangle(mesh, face, distance);
  triangles_.push_back({{border_[0].point, border_[1].point, border_[2].point}, mesh.cage_face[face], distance});
}

LeafMesh leaf_mesh(const AdaptiveLevels& levels) {
  auto [points, triangles] = LevelTriangles(levels).taken();
  std::stable_sort(triangles.begin(), triangles.end(),
                   [](const LimitTriangle& a, const LimitTriangle& b) { return a.cage_face < b.cage_face; });
  std::vector<std::array<Index, 3>> corners;
  std::vector<Index> faces;
  std::vector<double> distances;
  for (const LimitTriangle& triangle : triangles) {
    corners.push_back(triangle.corners);
    faces.push_back(triangle.cage_face);
    distances.push_back(triangle.distance);
  }
  return {TriangleMesh(std::move(points), std::move(corners), std::move(faces)), std::move(distances)};
}

double rounding_of_triangles(const LevelMesh& mesh) { return rounding_of_bounds(mesh) + border_slack(mesh); }

}  // namespace toccata
