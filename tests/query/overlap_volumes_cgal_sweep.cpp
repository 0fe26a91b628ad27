// Overlap volumes of solids against the exact booleans of CGAL's Nef polyhedra.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_incremental_builder_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/convert_nef_polyhedron_to_polygon_mesh.h>

#include "support/case_seeds.hpp"
#include "support/relation_cases.hpp"
#include "support/sweep.hpp"
#include "toccata/query/overlap.hpp"

namespace toccata::test {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

class WorldPolyhedron : public CGAL::Modifier_base<Polyhedron::HalfedgeDS> {
 public:
  WorldPolyhedron(const TriangleMesh& mesh, const Pose& pose) : mesh_(mesh), pose_(pose) {}
  void operator()(Polyhedron::HalfedgeDS& target) override {
    CGAL::Polyhedron_incremental_builder_3<Polyhedron::HalfedgeDS> builder(target, true);
    builder.begin_surface(mesh_.vertices().size(), mesh_.triangles().size());
    for (const Vec3& v : mesh_.vertices()) {
      const Vec3 w = transform(pose_, v);
      builder.add_vertex(Kernel::Point_3(w.x, w.y, w.z));
    }
    for (const auto& corners : mesh_.triangles()) builder.add_facet(corners.begin(), corners.end());
    builder.end_surface();
  }

 private:
  const TriangleMesh& mesh_;
  const Pose& pose_;
};

Nef solid_of(const TriangleMesh& mesh, const Pose& pose) {
  Polyhedron polyhedron;
  WorldPolyhedron builder(mesh, pose);
  polyhedron.delegate(builder);
  return Nef(polyhedron).regularization();
}

Kernel::FT exact_volume(const Nef& common) {
  Kernel::FT six = 0;
  if (common.interior().is_empty()) return six;
  Surface surface;
  CGAL::convert_nef_polyhedron_to_polygon_mesh(common, surface, true);
  for (const auto face : surface.faces()) {
    std::vector<Kernel::Point_3> corners;
    for (const auto vertex : CGAL::vertices_around_face(surface.halfedge(face), surface))
      corners.push_back(surface.point(vertex));
    for (std::size_t i = 2; i < corners.size(); ++i)
      six += CGAL::determinant(corners[0] - CGAL::ORIGIN, corners[i - 1] - CGAL::ORIGIN, corners[i] - CGAL::ORIGIN);
  }
  return six / 6;
}

std::string fault_beside_cgal(const std::string& family, std::uint64_t seed) {
  Random random(seed);
  RelationCase made = random_relation_case(family, random);
  const auto is_upright = [](const Pose& pose) {
    return dot(cross(pose.linear[0], pose.linear[1]), pose.linear[2]) > 0;
  };
  while (!is_upright(made.query.pose_a) || !is_upright(made.query.pose_b)) made = random_relation_case(family, random);
  const OverlapVolume found = overlap_volume(Model(made.a), Model(made.b), made.query);
  const Kernel::FT exact = exact_volume(solid_of(made.a, made.query.pose_a) * solid_of(made.b, made.query.pose_b));
  if (exact < found.lower) return "lower is above the volume that CGAL finds";
  if (found.upper < exact) return "upper is below the volume that CGAL finds";
  return "";
}

SweepResult run_overlap_volumes_cgal(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  return run_cases(family, seed, cases, [&](std::uint64_t case_seed) { return fault_beside_cgal(family, case_seed); });
}

const bool overlap_volumes_cgal_known = register_sweep(
    {"overlap-volumes-cgal", {"grid boxes", "l shapes", "rigid"}, 200, 5, run_overlap_volumes_cgal, 50, 1});

}  // namespace
}  // namespace toccata::test
