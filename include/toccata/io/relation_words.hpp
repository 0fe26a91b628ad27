#pragma once

#include <string>

#include "toccata/narrow/set_relation.hpp"

namespace toccata {

/// The relation as a verb between the names of a and b: "overlaps", "contains", "lies inside", "touches", …
[[nodiscard]] std::string verb_of(const Relation& relation);

/// What the two were taken for, and what the relation leaves open: "(both solids)", "(a surface, a solid)",
/// "(undecided: …)", …
[[nodiscard]] std::string remark_on(const Relation& relation);

}  // namespace toccata
