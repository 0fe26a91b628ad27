#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "toccata/query/self_contacts.hpp"

namespace toccata::test {

// Where a mesh intersects itself, by CGAL's Polygon_mesh_processing::self_intersections.

using CgalKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalSurface = CGAL::Surface_mesh<CgalKernel::Point_3>;
using TrianglePairs = std::vector<std::pair<Index, Index>>;

/// No two vertices that a triangle uses are at one place: CGAL tells neighbours by the numbers of vertices.
inline bool vertices_are_distinct(const TriangleMesh& mesh, const Pose& pose) {
  std::set<Index> used;
  for (const auto& corners : mesh.triangles()) used.insert(corners.begin(), corners.end());
  std::set<std::tuple<double, double, double>> places;
  return std::all_of(used.begin(), used.end(), [&](Index i) {
    const Vec3 w = transform(pose, mesh.vertices()[i]);
    return places.insert({w.x, w.y, w.z}).second;
  });
}

/// None where CGAL does not take the mesh: not manifold, or a triangle without area.
inline std::optional<CgalSurface> surface_of(const TriangleMesh& mesh, const Pose& pose) {
  CgalSurface surface;
  for (const Vec3& v : mesh.vertices()) {
    const Vec3 w = transform(pose, v);
    surface.add_vertex({w.x, w.y, w.z});
  }
  for (const auto& [i, j, k] : mesh.triangles()) {
    const CgalSurface::Vertex_index p(i), q(j), r(k);
    if (CGAL::collinear(surface.point(p), surface.point(q), surface.point(r))) return std::nullopt;
    if (surface.add_face(p, q, r) == CgalSurface::null_face()) return std::nullopt;
  }
  if (!vertices_are_distinct(mesh, pose)) return std::nullopt;
  return surface;
}

inline TrianglePairs pairs_by_cgal(const CgalSurface& surface) {
  std::vector<std::pair<CgalSurface::Face_index, CgalSurface::Face_index>> found;
  CGAL::Polygon_mesh_processing::self_intersections(surface, std::back_inserter(found));
  TrianglePairs pairs;
  for (const auto& [f, g] : found) pairs.push_back(std::minmax<Index>(f, g));
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

inline TrianglePairs pairs_by_toccata(const TriangleMesh& mesh, const Pose& pose) {
  TrianglePairs pairs;
  for (const Contact& contact : self_contacts(Model(mesh), pose))
    pairs.emplace_back(contact.element_a, contact.element_b);
  return pairs;
}

}  // namespace toccata::test
