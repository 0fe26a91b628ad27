#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/version.h>

#include <algorithm>
#include <iterator>

#include "self.hpp"

namespace toccata::bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

/// Polygon_mesh_processing::self_intersections, on one thread. It tells neighbours by the numbers of vertices.
class CgalSelf : public SelfLibrary {
 public:
  Description description() const override {
    return {"cgal", "PMP::self_intersections, EPICK", CGAL_VERSION_STR,
            TOCCATA_BENCH_COMPILER ", -O3 -DNDEBUG -frounding-math"};
  }

  bool prepare(const TriangleMesh& mesh) override {
    for (const Vec3& v : mesh.vertices()) surface_.add_vertex({v.x, v.y, v.z});
    for (const auto& [i, j, k] : mesh.triangles()) {
      const Surface::Vertex_index p(i), q(j), r(k);
      if (CGAL::collinear(surface_.point(p), surface_.point(q), surface_.point(r))) return false;
      if (surface_.add_face(p, q, r) == Surface::null_face()) return false;
    }
    return true;
  }

  TrianglePairs pairs() override {
    std::vector<std::pair<Surface::Face_index, Surface::Face_index>> found;
    CGAL::Polygon_mesh_processing::self_intersections(surface_, std::back_inserter(found));
    TrianglePairs pairs;
    for (const auto& [f, g] : found) pairs.push_back(std::minmax<Index>(f, g));
    return pairs;
  }

 private:
  Surface surface_;
};

}  // namespace

SelfLibraries cgal_self_libraries() {
  SelfLibraries libraries;
  libraries.push_back(std::make_unique<CgalSelf>());
  return libraries;
}

}  // namespace toccata::bench
