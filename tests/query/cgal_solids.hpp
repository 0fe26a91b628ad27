#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_incremental_builder_3.h>

#include "toccata/math/pose.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata::test {

// Posed meshes as CGAL's solids, in exact numbers.

using CgalKernel = CGAL::Exact_predicates_exact_constructions_kernel;
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

}  // namespace toccata::test
