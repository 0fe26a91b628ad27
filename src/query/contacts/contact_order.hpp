#pragma once

#include "query/meshes/posed_mesh.hpp"
#include "query/search_scratch.hpp"

namespace toccata {

/// A pair that was found, with the faces of its triangles.
[[nodiscard]] Contact contact_of(const PosedMesh& a, const PosedMesh& b, const FoundPair& pair);

/// Makes what the parts of a search found the contacts of the scratch, ascending. On up to `threads` threads (0: as
/// many as the machine has): each takes a range of the pairs' numbers, whoever found them.
void order_contacts(const PosedMesh& a, const PosedMesh& b, SearchScratch& scratch, int threads);

}  // namespace toccata
