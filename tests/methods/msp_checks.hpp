#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "methods/closed_meshes.hpp"
#include "oracle/oracle.hpp"
#include "toccata/methods/msp_tree.hpp"
#include "toccata/query/signed_distance.hpp"

// Closed meshes for MSP trees, many of them on a grid, and where a point lies by every triangle.
namespace toccata::test {

/// Every coordinate on a grid of so many steps to 1: then middles of edges and faces are doubles, and lie on them.
inline TriangleMesh on_grid(const TriangleMesh& mesh, double steps) {
  std::vector<Vec3> vertices(mesh.vertices().begin(), mesh.vertices().end());
  for (Vec3& v : vertices)
    for (int axis = 0; axis < 3; ++axis) v[axis] = std::round(steps * v[axis]) / steps;
  return mesh.with_vertices(std::move(vertices));
}

/// Every triangle has vertices of its own.
inline TriangleMesh soup_of(const TriangleMesh& mesh) {
  std::vector<Vec3> vertices;
  std::vector<std::array<Index, 3>> triangles;
  for (Index t = 0; t < mesh.triangle_count(); ++t) {
    triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    for (int i = 0; i < 3; ++i) vertices.push_back(vertex_of(mesh, t, i));
  }
  return TriangleMesh(std::move(vertices), std::move(triangles));
}

inline std::vector<NamedMesh> closed_meshes_and_more() {
  std::vector<NamedMesh> meshes = closed_meshes();
  for (const char* name : {"gen:icosphere?subdivisions=1", "gen:noise-sphere?roughness=0.5", "gen:torus", "gen:gear",
                           "gen:torus-knot?around=60&sides=5"})
    meshes.push_back({std::string(name) + " on a grid", on_grid(generated(name), 4096)});
  meshes.push_back({"a soup", soup_of(on_grid(generated("gen:gear"), 4096))});
  meshes.push_back(
      {"boxes on a common edge", oracle::joined(box_between({0, 0, 0}, {2, 2, 2}), box_between({2, 2, 0}, {4, 4, 2}))});
  meshes.push_back({"boxes on a common vertex",
                    oracle::joined(box_between({0, 0, 0}, {2, 2, 2}), box_between({2, 2, 2}, {4, 4, 4}))});
  return meshes;
}

inline bool is_in_box(const Vec3& p, const Triangle& t) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto [least, greatest] = std::minmax({t[0][axis], t[1][axis], t[2][axis]});
    if (p[axis] < least || p[axis] > greatest) return false;
  }
  return true;
}

/// What of a triangle the point lies on, in rationals.
inline std::optional<Feature> feature_with(const Vec3& p, const Triangle& t) {
  const auto feature = [](FeatureKind kind, int index) { return Feature{kind, static_cast<std::uint8_t>(index)}; };
  for (int i = 0; i < 3; ++i)
    if (p == t[i]) return feature(FeatureKind::vertex, i);
  const oracle::RationalPoint at = oracle::exact(p);
  if (!oracle::contains({oracle::exact(t[0]), oracle::exact(t[1]), oracle::exact(t[2])}, at)) return {};
  for (int i = 0; i < 3; ++i) {
    const oracle::RationalPoint from = oracle::exact(t[i]), to = oracle::exact(t[(i + 1) % 3]);
    if (is_zero(cross(to - from, at - from))) return feature(FeatureKind::edge, i);
  }
  return feature(FeatureKind::face, 0);
}

/// By every triangle; the first is the least.
inline MspLocation location_by_all(const Vec3& p, const Model& model) {
  const TriangleMesh& mesh = model.mesh();
  for (Index i = 0; i < mesh.triangle_count(); ++i) {
    const Triangle t{vertex_of(mesh, i, 0), vertex_of(mesh, i, 1), vertex_of(mesh, i, 2)};
    if (!is_in_box(p, t)) continue;
    if (const auto feature = feature_with(p, t)) return {{Side::boundary, 0}, i, *feature};
  }
  return {locate(p, model), 0, {}};
}

}  // namespace toccata::test
