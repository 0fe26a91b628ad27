#include "query/relation_parts.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

#include "query/inside_winding.hpp"
#include "query/relation_union_find.hpp"

namespace toccata {
namespace {

/// For every vertex, the one that stands for all of equal coordinates.
std::vector<Index> welded_vertices(std::span<const Vec3> vertices) {
  std::vector<Index> order(vertices.size());
  std::iota(order.begin(), order.end(), Index{0});
  const auto key = [&](Index i) { return std::tie(vertices[i].x, vertices[i].y, vertices[i].z); };
  std::sort(order.begin(), order.end(), [&](Index i, Index j) { return key(i) < key(j); });
  std::vector<Index> welded(vertices.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool repeated = k > 0 && vertices[order[k]] == vertices[order[k - 1]];
    welded[order[k]] = repeated ? welded[order[k - 1]] : order[k];
  }
  return welded;
}

}  // namespace

std::vector<std::vector<Index>> connected_parts(const PosedMesh& mesh, std::span<const Index> triangles) {
  const std::vector<Vec3> vertices = mesh.vertices();
  const std::vector<Index> welded = welded_vertices(vertices);
  const auto corners = mesh.model().mesh().triangles();
  UnionFind sets(welded.size());
  for (const Index t : triangles)
    for (std::size_t i = 1; i < 3; ++i) sets.unite(welded[corners[t][0]], welded[corners[t][i]]);

  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> part_of_leader(welded.size(), none);
  std::vector<std::vector<Index>> parts;
  for (const Index t : triangles) {
    std::size_t& part = part_of_leader[sets.leader(welded[corners[t][0]])];
    if (part == none) {
      part = parts.size();
      parts.emplace_back();
    }
    parts[part].push_back(t);
  }
  return parts;
}

std::vector<std::vector<Index>> connected_parts(const PosedMesh& mesh) {
  std::vector<Index> all(mesh.model().mesh().triangle_count());
  std::iota(all.begin(), all.end(), Index{0});
  return connected_parts(mesh, all);
}

bool is_interior(const Vec3& point, const PosedMesh& closed) {
  const LineWinding winding = wind_along(closed, ExactPoint(point), 0);
  return !winding.on_face && winding.ahead != 0;
}

}  // namespace toccata
