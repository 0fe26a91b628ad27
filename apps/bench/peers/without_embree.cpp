#include "library.hpp"
#include "rays.hpp"

namespace toccata::bench {

MeshLibraries embree_mesh_libraries() { peer_is_missing("embree"); }
RayLibraries embree_ray_libraries() { peer_is_missing("embree"); }

}  // namespace toccata::bench
