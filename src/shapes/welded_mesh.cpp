#include "shapes/welded_mesh.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

#include "shapes/union_find.hpp"

namespace toccata {
namespace {

/// A use of an edge as one number to sort by: the lesser vertex, the greater, and the direction.
struct DirectedEdge {
  std::uint64_t ends;
  bool downward;
  friend bool operator<(const DirectedEdge& a, const DirectedEdge& b) {
    return std::tie(a.ends, a.downward) < std::tie(b.ends, b.downward);
  }
};

DirectedEdge directed_edge(Index from, Index to) {
  const std::uint64_t low = std::min(from, to), high = std::max(from, to);
  return {low << 32 | high, from > to};
}

std::vector<DirectedEdge> directed_edges(const WeldedTriangles& welded) {
  std::vector<DirectedEdge> edges;
  edges.reserve(3 * welded.triangles.size());
  for (const auto& [a, b, c] : welded.triangles) {
    if (a == b || b == c || c == a) continue;
    edges.insert(edges.end(), {directed_edge(a, b), directed_edge(b, c), directed_edge(c, a)});
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

}  // namespace

WeldedTriangles weld(const TriangleMesh& mesh) {
  const auto vertices = mesh.vertices();
  std::vector<Index> order(vertices.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::sort(order.begin(), order.end(),
            [&](Index i, Index j) { return lexicographically_less(vertices[i], vertices[j]); });
  std::vector<Index> distinct(vertices.size());
  Index count = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k > 0 && vertices[order[k]] != vertices[order[k - 1]]) ++count;
    distinct[order[k]] = count;
  }
  WeldedTriangles welded;
  welded.distinct_vertices = vertices.empty() ? 0 : std::size_t{count} + 1;
  welded.triangles.reserve(mesh.triangles().size());
  for (const auto& [a, b, c] : mesh.triangles()) welded.triangles.push_back({distinct[a], distinct[b], distinct[c]});
  return welded;
}

MeshParts connected_parts(const WeldedTriangles& welded) {
  UnionFind sets(welded.distinct_vertices);
  for (const auto& [a, b, c] : welded.triangles) {
    sets.unite(a, b);
    sets.unite(b, c);
  }
  constexpr Index none = std::numeric_limits<Index>::max();
  std::vector<Index> part_of_leader(welded.distinct_vertices, none);
  MeshParts parts;
  parts.part_of_triangle.reserve(welded.triangles.size());
  for (std::size_t t = 0; t < welded.triangles.size(); ++t) {
    Index& part = part_of_leader[sets.leader(welded.triangles[t][0])];
    if (part == none) {
      part = static_cast<Index>(parts.first_triangle.size());
      parts.first_triangle.push_back(static_cast<Index>(t));
    }
    parts.part_of_triangle.push_back(part);
  }
  return parts;
}

std::vector<EdgeUse> edge_uses(const WeldedTriangles& welded) {
  const std::vector<DirectedEdge> directed = directed_edges(welded);
  std::vector<EdgeUse> uses;
  for (std::size_t i = 0; i < directed.size(); ++i) {
    if (i == 0 || directed[i].ends != directed[i - 1].ends)
      uses.push_back({static_cast<Index>(directed[i].ends >> 32), static_cast<Index>(directed[i].ends)});
    ++(directed[i].downward ? uses.back().downward : uses.back().upward);
  }
  return uses;
}

}  // namespace toccata
