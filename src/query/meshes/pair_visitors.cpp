#include "query/meshes/pair_visitors.hpp"

#include "query/meshes/world_search.hpp"

namespace toccata {
namespace {

void put_local(const TriangleMesh& mesh, Index triangle, std::size_t lane, TrianglePairBlock::Corners& corners) {
  const std::span<const Vec3> vertices = mesh.vertices();
  const auto& corner = mesh.triangles()[triangle];
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& v = vertices[corner[i]];
    corners[i][0][lane] = v.x;
    corners[i][1][lane] = v.y;
    corners[i][2][lane] = v.z;
  }
}

}  // namespace

void PairVisitor::ask_for_triangles(std::span<const ItemPair> pairs) const {
  for (const ItemPair& pair : pairs) {
    __builtin_prefetch(&mesh_a_.triangles()[pair.first]);
    __builtin_prefetch(&mesh_b_.triangles()[pair.second]);
  }
}

void PairVisitor::ask_for_vertices(std::span<const ItemPair> pairs) const {
  for (const ItemPair& pair : pairs) {
    for (const Index corner : mesh_a_.triangles()[pair.first]) __builtin_prefetch(&mesh_a_.vertices()[corner]);
    for (const Index corner : mesh_b_.triangles()[pair.second]) __builtin_prefetch(&mesh_b_.vertices()[corner]);
  }
}

WideProbe PairVisitor::region_of(std::size_t side, Index triangle) {
  return side == 0 ? probe_of(b_, a_.triangle(triangle)) : probe_of(a_, b_.triangle(triangle));
}

std::span<const TrianglePairBlock> PairVisitor::classified(std::span<const ItemPair> pairs) {
  constexpr std::size_t lanes = TrianglePairBlock::lanes;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    put_local(mesh_a_, pairs[i].first, i % lanes, blocks_[i / lanes].a);
    put_local(mesh_b_, pairs[i].second, i % lanes, blocks_[i / lanes].b);
  }
  const auto used = blocks_.first((pairs.size() + lanes - 1) / lanes);
  for (TrianglePairBlock& block : used) block.count = lanes;
  used.back().count = pairs.size() - (used.size() - 1) * lanes;
  if (one_mesh_)
    classify_neighbours(a_.pose(), used);
  else
    classify_pairs(a_.pose(), b_.pose(), used);
  return used;
}

}  // namespace toccata
