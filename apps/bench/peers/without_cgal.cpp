#include "broad.hpp"
#include "decomposing.hpp"
#include "library.hpp"
#include "nearest.hpp"
#include "self.hpp"
#include "sums.hpp"

namespace toccata::bench {

MeshLibraries cgal_mesh_libraries() { peer_is_missing("cgal"); }
NearestLibraries cgal_nearest_libraries() { peer_is_missing("cgal"); }
TriangleLibraries cgal_triangle_libraries() { peer_is_missing("cgal"); }
SelfLibraries cgal_self_libraries() { peer_is_missing("cgal"); }
BroadLibraries cgal_broad_libraries() { peer_is_missing("cgal"); }
PeerParts cgal_convex_parts(const TriangleMesh&) { peer_is_missing("cgal"); }
SumLibraries cgal_sum_libraries() { peer_is_missing("cgal"); }

}  // namespace toccata::bench
