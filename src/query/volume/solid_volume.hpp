#pragma once

#include <cstddef>
#include <optional>

#include "query/contacts/surface_within.hpp"
#include "query/posed_shape.hpp"
#include "query/search_scratch.hpp"
#include "toccata/query/overlap.hpp"
#include "toccata/query/relation.hpp"

namespace toccata {

/// What two solids have in common.
struct CommonSolid {
  OverlapVolume volume;
  /// For two that are not compounds: closed curves along which the surfaces cross, for what is round those of the
  /// polyhedra within; 0 where that was not found out: then a surface may lie inside its solid.
  std::size_t curve_count = 0;
  std::optional<ContactSide> pierces{};  ///< where there are several: the one that goes through the other, if one does
  std::optional<Vec3> point;             ///< certainly of both, closed; none where none was found
};

/// What two models have in common that are both solids, one of which is bounded.
[[nodiscard]] CommonSolid common_solid(const PosedModel& a, const PosedModel& b, SearchScratch& scratch);

/// Both are solids, and not both half-spaces.
[[nodiscard]] bool have_common_volume(const PosedModel& a, const PosedModel& b);

/// They touch, which is decided and hides no overlap: solids that do have no volume in common.
[[nodiscard]] inline bool are_surely_touching(const Relation& relation) {
  return relation.kind == RelationKind::touching && relation.status == Status::exact && !relation.side_unresolved;
}

}  // namespace toccata
