#include "library.hpp"

namespace toccata::bench {

MeshLibraries cgal_mesh_libraries() { peer_is_missing("cgal"); }
TriangleLibraries cgal_triangle_libraries() { peer_is_missing("cgal"); }

}  // namespace toccata::bench
