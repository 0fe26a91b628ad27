#include "query/manifolds/vertex_fans.hpp"

#include <utility>

#include "query/contacts/outward_turn.hpp"
#include "shapes/welded_mesh.hpp"

namespace toccata {

VertexFans::VertexFans(const Model& model) {
  WeldedTriangles welded = weld(model.mesh());
  first_.assign(welded.distinct_vertices + 1, 0);
  for (const auto& corners : welded.triangles)
    for (const Index corner : corners) ++first_[corner + 1];
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  triangles_.resize(3 * welded.triangles.size());
  std::vector<Index> next(first_.begin(), first_.end() - 1);
  for (Index t = 0; t < welded.triangles.size(); ++t)
    for (const Index corner : welded.triangles[t]) triangles_[next[corner]++] = t;
  corners_ = std::move(welded.triangles);
  if (!model.closed()) return;
  const MeshParts& parts = model.mesh_parts();
  part_of_triangle_ = parts.part_of_triangle;
  const PosedMesh mesh(model, {});
  for (const Index triangle : parts.first_triangle) turn_of_part_.push_back(outward_turn(mesh, triangle) < 0 ? -1 : 1);
}

}  // namespace toccata
