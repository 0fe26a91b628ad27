#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/convex_decomposition_3.h>
#include <CGAL/version.h>

#include "decomposing.hpp"
#include "measure.hpp"
#include "toccata/core/error.hpp"

namespace toccata::bench {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;

Surface surface_of(const TriangleMesh& mesh) {
  Surface surface;
  for (const Vec3& v : mesh.vertices()) surface.add_vertex({v.x, v.y, v.z});
  bool is_manifold = true;
  for (const auto& [i, j, k] : mesh.triangles())
    is_manifold = is_manifold && surface.add_face(Surface::Vertex_index(i), Surface::Vertex_index(j),
                                                  Surface::Vertex_index(k)) != Surface::null_face();
  if (!is_manifold || !CGAL::is_closed(surface))
    throw Error("CGAL decomposes closed manifold meshes only; name another mesh, or leave --peer out");
  return surface;
}

double volume_of(const Polyhedron& part) {
  double sum = 0;
  const Kernel::Point_3 apex = part.vertices_begin()->point();
  for (auto face = part.facets_begin(); face != part.facets_end(); ++face) {
    const auto first = face->halfedge();
    for (auto h = first->next(); h->next() != first; h = h->next())
      sum += CGAL::to_double(
          CGAL::volume(apex, first->vertex()->point(), h->vertex()->point(), h->next()->vertex()->point()));
  }
  return sum;
}

/// The volumes that are marked are the parts; the first is all that is outside.
void add_parts(Nef& solid, PeerParts& result) {
  for (auto volume = ++solid.volumes_begin(); volume != solid.volumes_end(); ++volume) {
    if (!volume->mark()) continue;
    Polyhedron part;
    solid.convert_inner_shell_to_polyhedron(volume->shells_begin(), part);
    result.volume += volume_of(part);
    ++result.parts;
  }
}

}  // namespace

PeerParts cgal_convex_parts(const TriangleMesh& mesh) {
  PeerParts result{{"cgal", "convex_decomposition_3 of Nef polyhedra, EPECK", CGAL_VERSION_STR,
                    TOCCATA_BENCH_COMPILER ", -O3 -DNDEBUG -frounding-math"}};
  Surface surface = surface_of(mesh);
  Nef solid;
  result.seconds = seconds_of(
      [&] {
        solid = Nef(surface);
        CGAL::convex_decomposition_3(solid);
      },
      Clock::thread);
  add_parts(solid, result);
  return result;
}

}  // namespace toccata::bench
