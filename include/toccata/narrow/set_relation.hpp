#pragma once

#include "toccata/core/status.hpp"

namespace toccata {

/// How two sets lie (docs/truth.md). Solids: apart, touching, overlapping. A surface involved: apart, touching,
/// crossing.
enum class RelationKind { apart, touching, overlapping, crossing };

/// For overlapping solids, whether one contains the other; for a surface crossing a solid, whether all of it is inside.
enum class Containment { none, a_in_b, b_in_a, equal };

struct Relation {
  RelationKind kind = RelationKind::apart;
  Containment containment = Containment::none;
  /// Two surfaces touch without any pair of faces crossing, so whether they pass through each other is not told by the
  /// faces alone. Callers that ignore touching must still count this.
  bool side_unresolved = false;
  bool a_solid = false;  ///< what each shape was taken for
  bool b_solid = false;
  Status status = Status::exact;
  friend constexpr bool operator==(const Relation&, const Relation&) = default;
};

}  // namespace toccata
