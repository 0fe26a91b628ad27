#include "query/pair_visitors.hpp"

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

std::span<const TrianglePairBlock> PairVisitor::classified(std::span<const ItemPair> pairs) {
  constexpr std::size_t lanes = TrianglePairBlock::lanes;
  const TriangleMesh &mesh_a = a_.model().mesh(), &mesh_b = b_.model().mesh();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    put_local(mesh_a, pairs[i].first, i % lanes, blocks_[i / lanes].a);
    put_local(mesh_b, pairs[i].second, i % lanes, blocks_[i / lanes].b);
  }
  const auto used = blocks_.first((pairs.size() + lanes - 1) / lanes);
  for (TrianglePairBlock& block : used) block.count = lanes;
  used.back().count = pairs.size() - (used.size() - 1) * lanes;
  classify_pairs(a_.pose(), b_.pose(), used);
  return used;
}

}  // namespace toccata
