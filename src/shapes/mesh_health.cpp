#include "toccata/shapes/mesh_health.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "shapes/welded_mesh.hpp"
#include "toccata/shapes/primitives.hpp"

namespace toccata {
namespace {

std::size_t count_duplicates(const WeldedTriangles& welded) {
  std::vector<std::array<Index, 3>> sorted = welded.triangles;
  for (auto& triangle : sorted) std::sort(triangle.begin(), triangle.end());
  std::sort(sorted.begin(), sorted.end());
  const auto distinct_end = std::unique(sorted.begin(), sorted.end());
  return static_cast<std::size_t>(sorted.end() - distinct_end);
}

std::size_t count_degenerate(const TriangleMesh& mesh) {
  const auto v = mesh.vertices();
  return static_cast<std::size_t>(std::count_if(mesh.triangles().begin(), mesh.triangles().end(), [&](const auto& t) {
    return !has_area({{v[t[0]], v[t[1]], v[t[2]]}});
  }));
}

bool balanced(const EdgeUse& edge) { return edge.upward == edge.downward; }

void count_edges(const WeldedTriangles& welded, MeshHealth& health) {
  for (const EdgeUse& edge : edge_uses(welded)) {
    const std::size_t uses = edge.upward + edge.downward;
    if (!balanced(edge)) ++health.unbalanced_edges;
    if (uses == 1) ++health.boundary_edges;
    if (uses > 2) ++health.non_manifold_edges;
    if (uses == 2 && !balanced(edge)) ++health.flipped_edges;
  }
}

std::vector<char> marks_of_used_vertices(const TriangleMesh& mesh) {
  std::vector<char> used(mesh.vertices().size(), 0);
  for (const auto& triangle : mesh.triangles())
    for (const Index v : triangle) used[v] = 1;
  return used;
}

void measure_vertices(const TriangleMesh& mesh, MeshHealth& health) {
  const std::vector<char> used = marks_of_used_vertices(mesh);
  health.lower = health.upper = mesh.vertices()[mesh.triangles()[0][0]];
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (used[i] == 0) {
      ++health.unused_vertices;
      continue;
    }
    const Vec3& p = mesh.vertices()[i];
    for (int axis = 0; axis < 3; ++axis) {
      health.lower[axis] = std::min(health.lower[axis], p[axis]);
      health.upper[axis] = std::max(health.upper[axis], p[axis]);
    }
  }
}

/// The sum of the signed volumes of the tetrahedra over the triangles, from the middle of the mesh: the nearer the
/// apex, the less is lost to rounding. Scaled to a size near 1, so that only the result itself can over- or underflow.
double signed_volume(const TriangleMesh& mesh, const Vec3& lower, const Vec3& upper) {
  const Vec3 middle = 0.5 * lower + 0.5 * upper;
  const double size = std::max({std::abs(lower.x), std::abs(lower.y), std::abs(lower.z), std::abs(upper.x),
                                std::abs(upper.y), std::abs(upper.z)});
  if (size == 0) return 0;
  const int exponent = std::ilogb(size) + 1;
  const auto local = [&](Index v) {
    const Vec3& p = mesh.vertices()[v];
    return Vec3{std::ldexp(p.x, -exponent) - std::ldexp(middle.x, -exponent),
                std::ldexp(p.y, -exponent) - std::ldexp(middle.y, -exponent),
                std::ldexp(p.z, -exponent) - std::ldexp(middle.z, -exponent)};
  };
  double sum = 0;
  for (const auto& t : mesh.triangles()) sum += dot(cross(local(t[0]), local(t[1])), local(t[2]));
  return std::ldexp(sum / 6, 3 * exponent);
}

}  // namespace

MeshHealth inspect(const TriangleMesh& mesh) {
  const WeldedTriangles welded = weld(mesh);
  MeshHealth health;
  health.vertices = mesh.vertices().size();
  health.distinct_vertices = welded.distinct_vertices;
  health.triangles = mesh.triangles().size();
  health.faces = mesh.face_count();
  health.components = connected_parts(welded).first_triangle.size();
  count_edges(welded, health);
  health.degenerate_triangles = count_degenerate(mesh);
  health.duplicate_triangles = count_duplicates(welded);
  health.closed = health.unbalanced_edges == 0;
  measure_vertices(mesh, health);
  if (health.closed) health.signed_volume = signed_volume(mesh, health.lower, health.upper);
  return health;
}

bool is_closed(const TriangleMesh& mesh) {
  const std::vector<EdgeUse> edges = edge_uses(weld(mesh));
  return std::all_of(edges.begin(), edges.end(), balanced);
}

}  // namespace toccata
