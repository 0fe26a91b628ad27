#include "library.hpp"
#include "nearest.hpp"
#include "rays.hpp"
#include "refits.hpp"

namespace toccata::bench {

MeshLibraries embree_mesh_libraries() { peer_is_missing("embree"); }
NearestLibraries embree_nearest_libraries() { peer_is_missing("embree"); }
RayLibraries embree_ray_libraries() { peer_is_missing("embree"); }
RefitLibraries embree_refit_libraries(int) { peer_is_missing("embree"); }

}  // namespace toccata::bench
