#include "toccata/shapes/mesh_health.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "shapes/union_find.hpp"
#include "shapes/welded_mesh.hpp"
#include "toccata/shapes/primitives.hpp"

namespace toccata {
namespace {

/// For each distinct vertex, the first that has its coordinates and is in a triangle.
std::vector<Index> first_vertices(const TriangleMesh& mesh, const WeldedTriangles& welded) {
  std::vector<Index> first(welded.distinct_vertices, static_cast<Index>(mesh.vertices().size()));
  for (std::size_t t = 0; t < welded.triangles.size(); ++t)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      Index& vertex = first[welded.triangles[t][corner]];
      vertex = std::min(vertex, mesh.triangles()[t][corner]);
    }
  return first;
}

/// Puts faults of one kind into groups: those with a distinct vertex in common are in one.
class Grouping {
 public:
  Grouping(MeshFaultKind kind, const WeldedTriangles& welded)
      : kind_(kind), welded_(welded), sets_(welded.distinct_vertices) {}

  void unite(const EdgeUse& edge) { sets_.unite(edge.low, edge.high); }
  void unite(Index triangle) {
    const auto& [a, b, c] = welded_.triangles[triangle];
    sets_.unite(a, b);
    sets_.unite(b, c);
  }

  /// After all are united.
  MeshFault& group_at(Index vertex) {
    const auto [found, is_new] = number_of_.try_emplace(sets_.leader(vertex), faults_.size());
    if (is_new) faults_.push_back({kind_, {}, {}, {}});
    return faults_[found->second];
  }

  /// The larger first.
  void append_to(std::vector<MeshFault>& all) {
    std::stable_sort(faults_.begin(), faults_.end(),
                     [](const MeshFault& a, const MeshFault& b) { return a.count() > b.count(); });
    std::move(faults_.begin(), faults_.end(), std::back_inserter(all));
  }

 private:
  MeshFaultKind kind_;
  const WeldedTriangles& welded_;
  UnionFind sets_;
  std::map<Index, std::size_t> number_of_;
  std::vector<MeshFault> faults_;
};

bool has_fault(const EdgeUse& edge, MeshFaultKind kind) {
  const std::size_t uses = edge.upward + edge.downward;
  if (kind == MeshFaultKind::boundary_edges) return uses == 1;
  if (kind == MeshFaultKind::non_manifold_edges) return uses > 2;
  return uses == 2 && edge.upward != edge.downward;
}

void add_edges(std::vector<MeshFault>& all, MeshFaultKind kind, const std::vector<EdgeUse>& edges,
               const WeldedTriangles& welded, const std::vector<Index>& first) {
  Grouping grouping(kind, welded);
  for (const EdgeUse& edge : edges)
    if (has_fault(edge, kind)) grouping.unite(edge);
  for (const EdgeUse& edge : edges)
    if (has_fault(edge, kind)) grouping.group_at(edge.low).edges.push_back({first[edge.low], first[edge.high]});
  grouping.append_to(all);
}

void add_triangles(std::vector<MeshFault>& all, MeshFaultKind kind, const std::vector<Index>& triangles,
                   const WeldedTriangles& welded) {
  Grouping grouping(kind, welded);
  for (const Index triangle : triangles) grouping.unite(triangle);
  for (const Index triangle : triangles) grouping.group_at(welded.triangles[triangle][0]).triangles.push_back(triangle);
  grouping.append_to(all);
}

std::vector<Index> degenerate_triangles(const TriangleMesh& mesh) {
  const auto v = mesh.vertices();
  std::vector<Index> found;
  for (Index t = 0; t < mesh.triangle_count(); ++t) {
    const auto& [a, b, c] = mesh.triangles()[t];
    if (!has_area({{v[a], v[b], v[c]}})) found.push_back(t);
  }
  return found;
}

/// All but the first of those that have the same three vertices.
std::vector<Index> duplicate_triangles(const WeldedTriangles& welded) {
  const auto sorted = [&](Index t) {
    std::array<Index, 3> corners = welded.triangles[t];
    std::sort(corners.begin(), corners.end());
    return corners;
  };
  std::vector<std::pair<std::array<Index, 3>, Index>> all;
  for (Index t = 0; t < welded.triangles.size(); ++t) all.emplace_back(sorted(t), t);
  std::sort(all.begin(), all.end());
  std::vector<Index> found;
  for (std::size_t i = 1; i < all.size(); ++i)
    if (all[i].first == all[i - 1].first) found.push_back(all[i].second);
  std::sort(found.begin(), found.end());
  return found;
}

void add_unused(std::vector<MeshFault>& all, const TriangleMesh& mesh) {
  std::vector<char> used(mesh.vertices().size(), 0);
  for (const auto& triangle : mesh.triangles())
    for (const Index vertex : triangle) used[vertex] = 1;
  MeshFault fault{MeshFaultKind::unused_vertices, {}, {}, {}};
  for (Index vertex = 0; vertex < used.size(); ++vertex)
    if (used[vertex] == 0) fault.vertices.push_back(vertex);
  if (!fault.vertices.empty()) all.push_back(std::move(fault));
}

}  // namespace

std::vector<MeshFault> mesh_faults(const TriangleMesh& mesh) {
  const WeldedTriangles welded = weld(mesh);
  const std::vector<EdgeUse> edges = edge_uses(welded);
  const std::vector<Index> first = first_vertices(mesh, welded);
  std::vector<MeshFault> faults;
  for (const MeshFaultKind kind :
       {MeshFaultKind::boundary_edges, MeshFaultKind::non_manifold_edges, MeshFaultKind::flipped_edges})
    add_edges(faults, kind, edges, welded, first);
  add_triangles(faults, MeshFaultKind::degenerate_triangles, degenerate_triangles(mesh), welded);
  add_triangles(faults, MeshFaultKind::duplicate_triangles, duplicate_triangles(welded), welded);
  add_unused(faults, mesh);
  return faults;
}

}  // namespace toccata
