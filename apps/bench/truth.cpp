#include "truth.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "oracle/convex.hpp"
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

/// What a triangle covers of a line along a direction: certainly no more than this.
struct Shadow {
  double lower;
  double upper;
};

Shadow shadow_of(const Triangle& triangle, const Vec3& direction) {
  double lower = INFINITY, upper = -INFINITY, size = 0;
  for (const Vec3& v : triangle.vertex) {
    const double place = dot(direction, v);
    lower = std::min(lower, place);
    upper = std::max(upper, place);
    size = std::max(size, std::abs(direction.x * v.x) + std::abs(direction.y * v.y) + std::abs(direction.z * v.z));
  }
  // Three products and two sums are wrong by less than 2^-51 of the terms' sizes; the rest is for what underflows.
  const double error = 0x1p-50 * size + 1e-300;
  return {lower - error, upper + error};
}

/// A rounded direction is as good as any other to prove that triangles are apart: the shadows on it are apart.
bool are_apart_along(const Triangle& a, const Triangle& b, const Vec3& direction) {
  const Shadow of_a = shadow_of(a, direction), of_b = shadow_of(b, direction);
  return of_a.upper < of_b.lower || of_b.upper < of_a.lower;
}

/// Spares rational arithmetic most pairs of triangles that are clearly apart.
bool are_clearly_apart(const Triangle& a, const Triangle& b) {
  const auto edge = [](const Triangle& t, std::size_t i) { return t.vertex[(i + 1) % 3] - t.vertex[i]; };
  if (are_apart_along(a, b, cross(edge(a, 0), edge(a, 1))) || are_apart_along(a, b, cross(edge(b, 0), edge(b, 1))))
    return true;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (are_apart_along(a, b, cross(edge(a, i), edge(b, j)))) return true;
  return false;
}

}  // namespace

bool truly_meet(const Triangle& a, const Triangle& b) { return oracle::overlap(oracle::exact(a), oracle::exact(b)); }

TrueMeshes::TrueMeshes(const TriangleMesh& a, const TriangleMesh& b, const PosePair& poses)
    : a_(world_triangles(a, poses.a)), b_(world_triangles(b, poses.b)) {}

bool TrueMeshes::meet(const std::pair<Index, Index>& pair) const {
  const Triangle &a = a_[pair.first], &b = b_[pair.second];
  return !are_clearly_apart(a, b) && truly_meet(a, b);
}

double TrueMeshes::squared_distance(const std::pair<Index, Index>& pair) const {
  const Triangle &a = a_[pair.first], &b = b_[pair.second];
  const auto nearest =
      oracle::nearest_points(oracle::triangle_set(a[0], a[1], a[2]), oracle::triangle_set(b[0], b[1], b[2]));
  return static_cast<double>(nearest.squared_distance);
}

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
