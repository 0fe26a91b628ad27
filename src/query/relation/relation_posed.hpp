#pragma once

#include <span>

#include "query/meshes/posed_mesh.hpp"
#include "query/posed_shape.hpp"
#include "query/search_scratch.hpp"
#include "toccata/core/function_ref.hpp"
#include "toccata/query/contacts.hpp"
#include "toccata/query/relation.hpp"

namespace toccata {

/// A posed mesh and what it is taken for; a solid is closed and posed regularly.
struct PosedTrianglesView {
  const PosedMesh& mesh;
  bool solid;
};

/// `relation` of two meshes that are posed already.
[[nodiscard]] Relation relation_of(const PosedTrianglesView& a, const PosedTrianglesView& b, SearchScratch& scratch);

/// The same where all contacts of the two are known: their trees are not walked again.
[[nodiscard]] Relation relation_of(const PosedTrianglesView& a, const PosedTrianglesView& b,
                                   std::span<const Contact> contacts);

/// `relation` of any two models that are posed already.
[[nodiscard]] Relation relation_of(const PosedModel& a, const PosedModel& b, SearchScratch& scratch);

/// Calls `see` with all contacts of two meshes, in any order; ends early when it returns false.
using SeeContact = FunctionRef<bool(const Contact&)>;
using VisitContacts = FunctionRef<void(SeeContact see)>;

}  // namespace toccata
