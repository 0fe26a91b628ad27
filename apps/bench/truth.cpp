#include "truth.hpp"

#include <algorithm>
#include <numeric>

#include "oracle/triangles.hpp"
#include "toccata/bounds/aabb.hpp"

namespace toccata::bench {
namespace {

std::vector<Triangle> world_triangles(const TriangleMesh& mesh, const Pose& pose) {
  std::vector<Vec3> vertices;
  for (const Vec3& vertex : mesh.vertices()) vertices.push_back(oracle::world_vertex(pose, vertex));
  std::vector<Triangle> triangles;
  for (const auto& corner : mesh.triangles())
    triangles.push_back({{vertices[corner[0]], vertices[corner[1]], vertices[corner[2]]}});
  return triangles;
}

std::vector<Aabb> boxes_of(const std::vector<Triangle>& triangles) {
  std::vector<Aabb> boxes;
  for (const Triangle& triangle : triangles) boxes.push_back(fit_aabb(triangle.vertex));
  return boxes;
}

}  // namespace

bool truly_meet(const Triangle& a, const Triangle& b) { return oracle::overlap(oracle::exact(a), oracle::exact(b)); }

TrueMeshes::TrueMeshes(const TriangleMesh& a, const TriangleMesh& b, const PosePair& poses)
    : a_(world_triangles(a, poses.a)), b_(world_triangles(b, poses.b)) {}

bool TrueMeshes::meet() const {
  const TrianglePairs pairs = candidates();
  return std::any_of(pairs.begin(), pairs.end(), [&](const auto& pair) { return meet(pair); });
}

TrianglePairs TrueMeshes::candidates() const {
  const std::vector<Aabb> boxes_a = boxes_of(a_), boxes_b = boxes_of(b_);
  std::vector<Index> order(b_.size());
  std::iota(order.begin(), order.end(), Index{0});
  const auto starts_before = [&](Index i, Index j) { return boxes_b[i].lower.x < boxes_b[j].lower.x; };
  std::sort(order.begin(), order.end(), starts_before);
  TrianglePairs pairs;
  double widest = 0;
  for (const Aabb& box : boxes_b) widest = std::max(widest, box.upper.x - box.lower.x);
  for (Index i = 0; i < boxes_a.size(); ++i) {
    // Twice the width: the difference may have been rounded down.
    const double from = boxes_a[i].lower.x - 2 * widest;
    auto next =
        std::lower_bound(order.begin(), order.end(), from, [&](Index j, double x) { return boxes_b[j].lower.x < x; });
    for (; next != order.end() && boxes_b[*next].lower.x <= boxes_a[i].upper.x; ++next)
      if (overlap(boxes_a[i], boxes_b[*next])) pairs.emplace_back(i, *next);
  }
  return pairs;
}

}  // namespace toccata::bench
