#pragma once

#include "query/posed_mesh.hpp"
#include "toccata/query/relation.hpp"

namespace toccata {

/// A posed mesh and what it is taken for; a solid is closed and posed regularly.
struct TakenMesh {
  const PosedMesh& mesh;
  bool solid;
};

/// `relation` of two meshes that are posed already.
[[nodiscard]] Relation relation_of(const TakenMesh& a, const TakenMesh& b);

}  // namespace toccata
