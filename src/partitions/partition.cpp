#include "toccata/partitions/partition.hpp"

#include <utility>

#include <fmt/format.h>

#include "toccata/bounds/volume.hpp"
#include "toccata/core/error.hpp"
#include "toccata/narrow/triangle_triangle.hpp"

namespace toccata {
namespace {

Aabb around(std::span<const Aabb> boxes) {
  Aabb all;
  for (const Aabb& box : boxes) all = merge(all, box);
  return all;
}

std::vector<Triangle> triangles_of(const TriangleMesh& mesh) {
  std::vector<Triangle> triangles;
  triangles.reserve(mesh.triangle_count());
  const std::span<const Vec3> vertices = mesh.vertices();
  for (const auto& [a, b, c] : mesh.triangles()) triangles.push_back({{vertices[a], vertices[b], vertices[c]}});
  return triangles;
}

}  // namespace

PartitionItems::PartitionItems(std::vector<Aabb> boxes) {
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const auto& [lower, upper] = boxes[i];
    if (!is_finite(lower) || !is_finite(upper))
      throw Error(fmt::format("box {} has a coordinate that is not finite: leave it out of the partition", i));
    for (int axis = 0; axis < 3; ++axis)
      if (lower[axis] > upper[axis])
        throw Error(fmt::format("box {}: its lower {} {} is above its upper one, {}", i, "xyz"[axis], lower[axis],
                                upper[axis]));
  }
  const Aabb bounds = around(boxes);
  data_ = std::make_shared<const Data>(Data{std::move(boxes), {}, bounds});
}

PartitionItems::PartitionItems(std::vector<Triangle> triangles) {
  std::vector<Aabb> boxes;
  boxes.reserve(triangles.size());
  for (const Triangle& triangle : triangles) {
    for (const Vec3& vertex : triangle.vertex)
      if (!is_finite(vertex)) throw Error(fmt::format("triangle {} has a coordinate that is not finite", boxes.size()));
    boxes.push_back(fit_aabb(triangle.vertex));
  }
  const Aabb bounds = around(boxes);
  data_ = std::make_shared<const Data>(Data{std::move(boxes), std::move(triangles), bounds});
}

PartitionItems::PartitionItems(const TriangleMesh& mesh) : PartitionItems(triangles_of(mesh)) {}

bool PartitionItems::meets(Index item, const Aabb& box) const {
  const Aabb& around = boxes()[item];
  return overlap(around, box) && (triangles().empty() || contains(box, around) || overlap(box, triangles()[item]));
}

bool PartitionItems::meet(Index a, Index b) const {
  return overlap(boxes()[a], boxes()[b]) && (triangles().empty() || overlap(triangles()[a], triangles()[b]));
}

}  // namespace toccata
