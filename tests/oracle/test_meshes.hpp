#pragma once

#include "support/mesh_soups.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata::oracle {

/// `test::box_between` with every triangle turned round: it winds −1 times around its inside.
inline TriangleMesh inverted_box_mesh(const Vec3& lower, const Vec3& upper) {
  const TriangleMesh box = test::box_between(lower, upper);
  std::vector<std::array<Index, 3>> triangles;
  for (const auto& [i, j, k] : box.triangles()) triangles.push_back({i, k, j});
  return TriangleMesh({box.vertices().begin(), box.vertices().end()}, std::move(triangles));
}

/// Both meshes as one.
inline TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b) {
  std::vector<Vec3> vertices(a.vertices().begin(), a.vertices().end());
  vertices.insert(vertices.end(), b.vertices().begin(), b.vertices().end());
  std::vector<std::array<Index, 3>> triangles(a.triangles().begin(), a.triangles().end());
  const auto shift = static_cast<Index>(a.vertices().size());
  for (const auto& [i, j, k] : b.triangles()) triangles.push_back({i + shift, j + shift, k + shift});
  return TriangleMesh(std::move(vertices), std::move(triangles));
}

/// One triangle, as an open mesh.
inline TriangleMesh single_triangle(const Vec3& p, const Vec3& q, const Vec3& r) {
  return TriangleMesh({p, q, r}, {{0, 1, 2}});
}

}  // namespace toccata::oracle
