#include "shapes/welded_mesh.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

#include "shapes/point_numbers.hpp"
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

std::vector<Index> first_equal_vertices(const TriangleMesh& mesh) {
  const auto vertices = mesh.vertices();
  const auto equal = [](const Vec3& a, const Vec3& b) { return a == b; };
  PointNumbers numbers(vertices.size());
  std::vector<Index> first(vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v)
    first[v] = numbers.find_or_take(vertices[v], static_cast<Index>(v), vertices, equal);
  return first;
}

WeldedTriangles weld(const TriangleMesh& mesh) {
  const auto vertices = mesh.vertices();
  std::vector<Index> number = first_equal_vertices(mesh), distinct;
  for (Index v = 0; v < number.size(); ++v)
    if (number[v] == v) distinct.push_back(v);
  std::sort(distinct.begin(), distinct.end(),
            [&](Index i, Index j) { return lexicographically_less(vertices[i], vertices[j]); });
  std::vector<Index> place(vertices.size());
  for (Index k = 0; k < distinct.size(); ++k) place[distinct[k]] = k;
  for (Index& n : number) n = place[n];
  WeldedTriangles welded;
  welded.distinct_vertices = distinct.size();
  welded.triangles.reserve(mesh.triangles().size());
  for (const auto& [a, b, c] : mesh.triangles()) welded.triangles.push_back({number[a], number[b], number[c]});
  return welded;
}

std::vector<WeldedEdge> edges_of_triangles(const WeldedTriangles& welded) {
  std::vector<WeldedEdge> edges;
  edges.reserve(3 * welded.triangles.size());
  for (Index t = 0; t < welded.triangles.size(); ++t)
    for (Index corner = 0; corner < 3; ++corner) {
      const Index from = welded.triangles[t][corner], to = welded.triangles[t][(corner + 1) % 3];
      edges.push_back({std::min(from, to), std::max(from, to), t, corner, from < to});
    }
  std::sort(edges.begin(), edges.end(), [](const WeldedEdge& a, const WeldedEdge& b) {
    return std::tie(a.low, a.high, a.triangle, a.corner) < std::tie(b.low, b.high, b.triangle, b.corner);
  });
  return edges;
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
