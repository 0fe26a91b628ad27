#pragma once

#include "query/meshes/posed_mesh.hpp"
#include "query/search_scratch.hpp"

namespace toccata {

/// Finds all pairs of triangles that meet, on up to `threads` threads. They lie in the
/// parts of the scratch; which lies where depends on the threads, all together and the counts do not.
void find_on_threads(const PosedMesh& a, const PosedMesh& b, SearchScratch& scratch, int threads);

}  // namespace toccata
