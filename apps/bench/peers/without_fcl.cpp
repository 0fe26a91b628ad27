#include "broad.hpp"
#include "casts.hpp"
#include "convex_library.hpp"
#include "parts.hpp"
#include "refits.hpp"
#include "robots.hpp"
#include "sweeps.hpp"
#include "world.hpp"
#include "world_queries.hpp"

namespace toccata::bench {

MeshLibraries fcl_mesh_libraries() { peer_is_missing("fcl"); }
TriangleLibraries fcl_triangle_libraries() { peer_is_missing("fcl"); }
ConvexOffer fcl_convex(const ConvexWork&) { peer_is_missing("fcl"); }
RefitLibraries fcl_refit_libraries() { peer_is_missing("fcl"); }
BroadLibraries fcl_broad_libraries() { peer_is_missing("fcl"); }
PartsLibraries fcl_parts() { peer_is_missing("fcl"); }
std::unique_ptr<WorldLibrary> fcl_world() { peer_is_missing("fcl"); }
WorldQueryLibraries fcl_world_query_libraries(WorldTask) { peer_is_missing("fcl"); }
CastOffer fcl_casts(const CastWork&) { peer_is_missing("fcl"); }
RobotLibraries fcl_robots() { peer_is_missing("fcl"); }
SweepOffer fcl_sweeps(const SweepWork&) { peer_is_missing("fcl"); }

}  // namespace toccata::bench
