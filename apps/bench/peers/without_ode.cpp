#include "broad.hpp"
#include "casts.hpp"
#include "convex_library.hpp"

namespace toccata::bench {

MeshLibraries ode_mesh_libraries() { peer_is_missing("ode"); }
ConvexOffer ode_convex(const ConvexWork&) { peer_is_missing("ode"); }
BroadLibraries ode_broad_libraries() { peer_is_missing("ode"); }
CastOffer ode_casts(const CastWork&) { peer_is_missing("ode"); }

}  // namespace toccata::bench
