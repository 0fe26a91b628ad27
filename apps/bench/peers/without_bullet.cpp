#include "broad.hpp"
#include "casts.hpp"
#include "convex_library.hpp"
#include "movers.hpp"
#include "sweeps.hpp"
#include "world.hpp"
#include "world_queries.hpp"

namespace toccata::bench {

MeshLibraries bullet_mesh_libraries() { peer_is_missing("bullet"); }
ConvexOffer bullet_convex(const ConvexWork&) { peer_is_missing("bullet"); }
BroadLibraries bullet_broad_libraries(std::span<const Aabb>) { peer_is_missing("bullet"); }
std::unique_ptr<WorldLibrary> bullet_world() { peer_is_missing("bullet"); }
WorldQueryLibraries bullet_world_query_libraries(WorldTask) { peer_is_missing("bullet"); }
MoverLibraries bullet_movers() { peer_is_missing("bullet"); }
CastOffer bullet_casts(const CastWork&) { peer_is_missing("bullet"); }
SweepOffer bullet_sweeps(const SweepWork&) { peer_is_missing("bullet"); }

}  // namespace toccata::bench
