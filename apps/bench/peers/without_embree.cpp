#include "library.hpp"

namespace toccata::bench {

MeshLibraries embree_mesh_libraries() { peer_is_missing("embree"); }

}  // namespace toccata::bench
