#include "query/contacts/region_depth.hpp"

#include "query/relation/relation_locality.hpp"

namespace toccata {

VertexGraph::VertexGraph(const PosedMesh& mesh) : mesh_(mesh), welded_(weld(mesh.model().mesh())) {
  const std::size_t count = welded_.distinct_vertices;
  representative_.resize(count);
  first_.assign(count + 1, 0);
  const auto triangles = mesh.model().mesh().triangles();
  for (Index t = 0; t < welded_.triangles.size(); ++t)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      representative_[welded_.triangles[t][corner]] = triangles[t][corner];
      ++first_[welded_.triangles[t][corner] + 1];
    }
  for (std::size_t i = 0; i < count; ++i) first_[i + 1] += first_[i];
  around_.resize(first_[count]);
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (Index t = 0; t < welded_.triangles.size(); ++t)
    for (const Index corner : welded_.triangles[t]) around_[next[corner]++] = t;
}

std::vector<Vec3> VertexGraph::inside(const PosedMesh& solid, std::span<const Index> triangles) const {
  std::vector<Vec3> found;
  std::vector<char> seen(welded_.distinct_vertices);
  std::vector<Index> waiting(triangles.begin(), triangles.end());
  while (!waiting.empty()) {
    const Index triangle = waiting.back();
    waiting.pop_back();
    for (const Index corner : welded_.triangles[triangle]) {
      if (seen[corner] != 0) continue;
      seen[corner] = 1;
      const Vec3 vertex = mesh_.vertex(representative_[corner]);
      if (!is_interior(vertex, solid)) continue;
      found.push_back(vertex);
      const auto around = triangles_at(corner);
      waiting.insert(waiting.end(), around.begin(), around.end());
    }
  }
  return found;
}

}  // namespace toccata
