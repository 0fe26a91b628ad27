#include "broad.hpp"
#include "convex_library.hpp"
#include "world.hpp"

namespace toccata::bench {

MeshLibraries bullet_mesh_libraries() { peer_is_missing("bullet"); }
ConvexOffer bullet_convex(const ConvexWork&) { peer_is_missing("bullet"); }
BroadLibraries bullet_broad_libraries(std::span<const Aabb>) { peer_is_missing("bullet"); }
std::unique_ptr<WorldLibrary> bullet_world() { peer_is_missing("bullet"); }

}  // namespace toccata::bench
