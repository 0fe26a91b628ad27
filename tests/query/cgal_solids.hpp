#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_incremental_builder_3.h>
#include <CGAL/boost/graph/convert_nef_polyhedron_to_polygon_mesh.h>

#include <string>
#include <vector>

#include "support/mesh_soups.hpp"
#include "support/relation_cases.hpp"
#include "toccata/core/random.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata::test {

// Posed meshes as CGAL's solids, in exact numbers.

using CgalKernel = CGAL::Exact_predicates_exact_constructions_kernel;
using CgalNumber = CgalKernel::FT;
using CgalPoint = CgalKernel::Point_3;
using CgalTriangle = CgalKernel::Triangle_3;
using CgalPolyhedron = CGAL::Polyhedron_3<CgalKernel>;
using CgalNef = CGAL::Nef_polyhedron_3<CgalKernel>;

/// Builds the posed mesh, whose vertices in the world are the rounded ones of the truth page.
class CgalBuilder : public CGAL::Modifier_base<CgalPolyhedron::HalfedgeDS> {
 public:
  CgalBuilder(const TriangleMesh& mesh, const Pose& pose) : mesh_(mesh), pose_(pose) {}
  void operator()(CgalPolyhedron::HalfedgeDS& target) override {
    CGAL::Polyhedron_incremental_builder_3<CgalPolyhedron::HalfedgeDS> builder(target, true);
    builder.begin_surface(mesh_.vertices().size(), mesh_.triangles().size());
    for (const Vec3& v : mesh_.vertices()) {
      const Vec3 w = transform(pose_, v);
      builder.add_vertex(CgalKernel::Point_3(w.x, w.y, w.z));
    }
    for (const auto& corners : mesh_.triangles()) builder.add_facet(corners.begin(), corners.end());
    builder.end_surface();
  }

 private:
  const TriangleMesh& mesh_;
  const Pose& pose_;
};

inline CgalPolyhedron cgal_polyhedron(const TriangleMesh& mesh, const Pose& pose) {
  CgalPolyhedron result;
  CgalBuilder builder(mesh, pose);
  result.delegate(builder);
  return result;
}

/// The closure of the interior.
inline CgalNef cgal_solid(const TriangleMesh& mesh, const Pose& pose) {
  CgalPolyhedron p = cgal_polyhedron(mesh, pose);
  return CgalNef(p).regularization();
}

/// The triangles of the surface of a bounded solid.
inline std::vector<CgalTriangle> triangles_of(const CgalNef& solid) {
  std::vector<CgalPoint> points;
  std::vector<std::vector<std::size_t>> corners;
  constexpr bool in_triangles = true;
  CGAL::convert_nef_polyhedron_to_polygon_soup(solid, points, corners, in_triangles);
  std::vector<CgalTriangle> triangles;
  for (const std::vector<std::size_t>& t : corners) triangles.emplace_back(points[t[0]], points[t[1]], points[t[2]]);
  return triangles;
}

inline TriangleMesh random_tetrahedron_for_cgal(Random& random) {
  for (;;) {
    const Vec3 p = random_vector(random, 1), q = random_vector(random, 1), r = random_vector(random, 1),
               s = random_vector(random, 1);
    if (dot(cross(q - p, r - p), s - p) < -0.05) return tetrahedron_mesh(p, q, r, s);
  }
}

/// A box, the mesh of a sphere, a prism, a tetrahedron, an L-shape; or any of them.
inline TriangleMesh solid_for_cgal(const std::string& family, Random& random) {
  const auto size = [&] { return random.between(0.2, 1); };
  if (family == "boxes") return box_mesh({size(), size(), size()});
  if (family == "spheres") return icosphere_mesh(size(), static_cast<int>(random.below(3)));
  if (family == "prisms") return prism_mesh(size(), 2 * size(), static_cast<int>(3 + random.below(6)));
  if (family == "tetrahedra") return random_tetrahedron_for_cgal(random);
  if (family == "l shapes") return l_mesh();
  static const std::vector<std::string> kinds = {"boxes", "spheres", "prisms", "tetrahedra", "l shapes"};
  return solid_for_cgal(kinds[random.below(kinds.size())], random);
}

/// As it is, or turned anyhow.
inline Mat3 some_turn(Random& random) { return random.below(4) == 0 ? Mat3{} : random_rotation(random); }

}  // namespace toccata::test
