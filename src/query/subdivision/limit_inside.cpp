#include "query/subdivision/limit_inside.hpp"

#include <algorithm>

#include "bounds/box_bounds.hpp"
#include "math/vec3_measures.hpp"
#include "query/subdivision/level_triangles.hpp"
#include "toccata/bounds/aabb.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/query/nearest.hpp"
#include "toccata/query/signed_distance.hpp"

namespace toccata {
namespace {

/// A face may be off by so much of what lies between it and the point nearest to it.
constexpr double share_of_gap = 0.25;

/// What witness points are off by, in units of the greatest coordinate: ten times what `distance` promises.
constexpr double inside_witness_share = 1e-11;

/// Deeper than this doubles do not resolve what is near a vertex.
constexpr int deepest_around_vertex = 60;

double gap_to_box(const Vec3& p, const Aabb& box) { return box_gap({p, p}, box); }

/// From any of the points to the box of the face's corners.
double least_gap(const LevelMesh& mesh, Index face, std::span<const RoughPoint> points) {
  Aabb box;
  for (const Index corner : mesh.face(face)) box = merge(box, mesh.points[corner]);
  double least = std::numeric_limits<double>::infinity();
  for (const RoughPoint& p : points) least = std::min(least, gap_to_box(p.at, box) - p.radius);
  return std::max(least, 0.0);
}

/// Moving the mesh into the limit surface, point by point, passes none of them.
bool stays_clear(const LeafMesh& leaves, std::span<const RoughPoint> points) {
  for (std::size_t t = 0; t < leaves.triangle_distances.size(); ++t) {
    Triangle triangle;
    for (std::size_t i = 0; i < 3; ++i) triangle.vertex[i] = leaves.mesh.vertices()[leaves.mesh.triangles()[t][i]];
    const double needed = leaves.triangle_distances[t];
    const Aabb box = fit_aabb(triangle.vertex);
    for (const RoughPoint& p : points) {
      if (gap_to_box(p.at, box) > 2 * (needed + p.radius)) continue;
      if (!(nearest_point(p.at, triangle)->lower > (needed + p.radius) * (1 + 0x1p-50))) return false;
    }
  }
  return true;
}

RoughPoint point_of(const Model& model, const Pose& pose) {
  const Vec3 from = transform(pose, Vec3{});
  const Vec3 found = distance(Point(from), model, {.pose_b = pose, .solid_b = Solid::none}).on_b;
  return {found, inside_witness_share * std::max(largest_magnitude(found), largest_magnitude(from))};
}

/// Faces that touch the vertex, so that the next level has it again and what its bound needs.
LevelMesh subdivided_around(LevelMesh mesh, Index& vertex) {
  std::vector<char> refined(mesh.face_count(), 0);
  for (const Index side : mesh.sides_at(vertex)) refined[mesh.face_of_side[side]] = 1;
  LevelMesh finer = subdivided(mesh, refined);
  vertex = mesh.point_of_vertex[vertex];
  return finer;
}

/// How far the vertex is from where it comes to lie in the limit.
double bound_at(const LevelMesh& mesh, Index vertex) {
  LimitBounds bounds(mesh);
  return bounds.of(mesh.face_of_side[mesh.sides_at(vertex).front()]).to_limit;
}

/// A face of every part that is connected through vertices.
std::vector<Index> first_faces_of_parts(const LevelMesh& mesh) {
  std::vector<Index> first, waiting;
  std::vector<char> seen(mesh.face_count(), 0);
  const auto see = [&](Index face) {
    if (seen[face]) return;
    seen[face] = 1;
    waiting.push_back(face);
  };
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (!seen[f]) first.push_back(f);
    see(f);
    while (!waiting.empty()) {
      const Index face = waiting.back();
      waiting.pop_back();
      for (const Index corner : mesh.face(face))
        for (const Index side : mesh.sides_at(corner)) see(mesh.face_of_side[side]);
    }
  }
  return first;
}

}  // namespace

std::vector<RoughPoint> points_of_parts(const Model& model, const Pose& pose) {
  std::vector<RoughPoint> points;
  for (const Model& part : model.parts())
    for (const RoughPoint& p : points_of_parts(part, pose)) points.push_back(p);
  if (!points.empty()) return points;
  if (!model.has_mesh()) return {point_of(model, pose)};
  const TriangleMesh& mesh = model.mesh();
  for (const Index triangle : model.mesh_parts().first_triangle)
    points.push_back({transform(pose, mesh.vertices()[mesh.triangles()[triangle][0]]), 0});
  return points;
}

std::vector<RoughPoint> points_of_parts(const SubdivisionCage& cage, double radius) {
  std::vector<RoughPoint> points;
  const LevelMesh first = first_level(cage);
  for (const Index face : first_faces_of_parts(first)) {
    LevelMesh mesh = first;
    Index vertex = mesh.face(face)[0];
    double bound = bound_at(mesh, vertex);
    while (bound > std::max(radius, 2 * rounding_of_bounds(mesh)) && mesh.level < deepest_around_vertex) {
      mesh = subdivided_around(std::move(mesh), vertex);
      bound = bound_at(mesh, vertex);
    }
    points.push_back({mesh.points[vertex], bound});
  }
  return points;
}

std::optional<bool> has_point_within(const SubdivisionCage& cage, std::span<const RoughPoint> points,
                                     std::size_t max_triangles) {
  // The limit lies in the box of the cage.
  const Aabb box = fit_aabb(cage.polygons().vertices);
  std::vector<RoughPoint> open(points.begin(), points.end());
  std::erase_if(open, [&](const RoughPoint& p) { return gap_to_box(p.at, box) > 2 * p.radius; });
  if (open.empty()) return false;
  const LeafMesh leaves =
      leaf_mesh(adaptive_levels(cage, {.max_triangles = max_triangles}, [&](const LevelMesh& mesh, Index face) {
        return share_of_gap * least_gap(mesh, face, open);
      }));
  if (!stays_clear(leaves, open)) return std::nullopt;
  const Model solid(leaves.mesh);
  return std::any_of(open.begin(), open.end(),
                     [&](const RoughPoint& p) { return locate(p.at, solid).side == Side::inside; });
}

}  // namespace toccata
