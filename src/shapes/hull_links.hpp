#pragma once

#include <span>

#include "shapes/hull_faces.hpp"

namespace toccata {

/// Where the links of faces go: as HullTopology describes them, one of `leaving` for each vertex, one of the others for
/// each corner.
struct HullLinks {
  std::span<Index> leaving, twin, face;
};

/// Links the half-edges of faces of which every directed edge belongs to one alone. `leaving` has for each vertex the
/// least half-edge that leaves it; 0 for a vertex without any.
void link_faces(const HullFaces& faces, const HullLinks& links);

}  // namespace toccata
