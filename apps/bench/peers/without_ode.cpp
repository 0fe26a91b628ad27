#include "library.hpp"

namespace toccata::bench {

MeshLibraries ode_mesh_libraries() { peer_is_missing("ode"); }

}  // namespace toccata::bench
