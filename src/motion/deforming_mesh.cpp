#include "toccata/motion/deforming_mesh.hpp"

#include <utility>

#include <fmt/format.h>

#include "motion/mesh_topology.hpp"
#include "toccata/bounds/aabb.hpp"
#include "toccata/core/error.hpp"
#include "trees/wide_refit.hpp"

namespace toccata {
namespace {

void check_ends(std::span<const Vec3> start, std::span<const Vec3> end) {
  if (end.size() != start.size())
    throw Error(fmt::format("a mesh of {} vertices is to move to {} positions: give each vertex one end", start.size(),
                            end.size()));
  for (std::size_t v = 0; v < end.size(); ++v)
    if (!is_finite(end[v]))
      throw Error(fmt::format("vertex {} of a mesh that deforms is to move to ({}, {}, {}): give finite numbers", v,
                              end[v].x, end[v].y, end[v].z));
}

std::vector<Aabb> boxes_of_ways(const MeshTopology& topology, std::span<const Vec3> start, std::span<const Vec3> end) {
  std::vector<Aabb> boxes;
  boxes.reserve(topology.triangles.size());
  for (const auto& corners : topology.triangles) {
    Aabb box;
    for (const Index corner : corners) box = merge(merge(box, start[corner]), end[corner]);
    boxes.push_back(box);
  }
  return boxes;
}

}  // namespace

DeformingMesh::DeformingMesh(const TriangleMesh& start, std::vector<Vec3> end, int threads)
    : start_(start.vertices().begin(), start.vertices().end()), end_(std::move(end)) {
  check_ends(start_, end_);
  topology_ = std::make_shared<const MeshTopology>(start.triangles());
  build(threads);
}

DeformingMesh::DeformingMesh(const TriangleMesh& mesh, int threads)
    : DeformingMesh(mesh, {mesh.vertices().begin(), mesh.vertices().end()}, threads) {}

void DeformingMesh::build(int threads) {
  tree_ = build_wide_bvh(boxes_of_ways(*topology_, start_, end_), {.threads = threads});
}

Refit DeformingMesh::refit(int threads) {
  const Refit done = refit_to_ways(tree_, topology_->triangles, start_, end_, threads);
  if (done.should_rebuild()) build(threads);
  return done;
}

Refit DeformingMesh::move_to(std::vector<Vec3> end, int threads) {
  check_ends(start_, end);
  end_ = std::move(end);
  return refit(threads);
}

Refit DeformingMesh::advance(std::vector<Vec3> end, int threads) {
  check_ends(end_, end);
  start_ = std::exchange(end_, std::move(end));
  return refit(threads);
}

std::span<const std::array<Index, 3>> DeformingMesh::triangles() const { return topology_->triangles; }

std::span<const IndexPair> DeformingMesh::edges() const { return topology_->edges; }

}  // namespace toccata
