#include "toccata/shapes/mesh_health.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

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

using Triangles = std::span<const std::array<Index, 3>>;

/// Calls `see(low, high, upward)` for every use of an edge. Triangles with two equal corners have no edges.
template <class See>
void each_edge_use(Triangles triangles, const See& see) {
  for (const auto& [a, b, c] : triangles) {
    if (a == b || b == c || c == a) continue;
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      see(std::min(from, to), std::max(from, to), from < to);
  }
}

/// The greater ends of edges by their lesser ones: of vertex v they are [first[v], first[v + 1]).
struct EdgeEnds {
  std::vector<Index> upward;
  std::vector<Index> downward;
};

/// Where the ends of each vertex begin; nothing where some vertex has not as many of them in one direction as in the
/// other.
std::vector<std::size_t> first_ends(Triangles triangles, std::size_t vertex_count) {
  std::vector<std::array<Index, 2>> counts(vertex_count, {0, 0});
  each_edge_use(triangles, [&](Index low, Index, bool upward) { ++counts[low][upward ? 0 : 1]; });
  std::vector<std::size_t> first{0};
  first.reserve(vertex_count + 1);
  for (const auto& [up, down] : counts) {
    if (up != down) return {};
    first.push_back(first.back() + up);
  }
  return first;
}

EdgeEnds ends_of(Triangles triangles, std::vector<std::size_t> next) {
  EdgeEnds ends{std::vector<Index>(next.back()), std::vector<Index>(next.back())};
  std::vector<std::size_t> next_downward = next;
  each_edge_use(triangles, [&](Index low, Index high, bool upward) {
    if (upward)
      ends.upward[next[low]++] = high;
    else
      ends.downward[next_downward[low]++] = high;
  });
  return ends;
}

/// Whether every edge between such vertices is used equally in both directions. In time proportional to their number,
/// but for vertices of very many edges.
bool all_balanced(Triangles triangles, std::size_t vertex_count) {
  const std::vector<std::size_t> first = first_ends(triangles, vertex_count);
  if (first.empty()) return false;
  EdgeEnds ends = ends_of(triangles, first);
  const auto run = [&](std::vector<Index>& all, std::size_t vertex) {
    const auto own = std::span(all).subspan(first[vertex], first[vertex + 1] - first[vertex]);
    std::sort(own.begin(), own.end());
    return own;
  };
  for (std::size_t vertex = 0; vertex < vertex_count; ++vertex) {
    const auto up = run(ends.upward, vertex), down = run(ends.downward, vertex);
    if (!std::equal(up.begin(), up.end(), down.begin())) return false;
  }
  return true;
}

/// The triangles with each vertex replaced by the first of those that have its coordinates.
std::vector<std::array<Index, 3>> with_first_vertices(const TriangleMesh& mesh) {
  const std::vector<Index> first = first_equal_vertices(mesh);
  std::vector<std::array<Index, 3>> triangles;
  triangles.reserve(mesh.triangles().size());
  for (const auto& [a, b, c] : mesh.triangles()) triangles.push_back({first[a], first[b], first[c]});
  return triangles;
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
  // Edges that are balanced as they are stay so when equal vertices become one: that adds uses up, and the edges of a
  // triangle of which two corners become one go there and back again.
  const std::size_t vertex_count = mesh.vertices().size();
  return all_balanced(mesh.triangles(), vertex_count) || all_balanced(with_first_vertices(mesh), vertex_count);
}

}  // namespace toccata
