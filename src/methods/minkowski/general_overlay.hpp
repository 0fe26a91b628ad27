#pragma once

#include <optional>

#include "methods/minkowski/gauss_overlay.hpp"

namespace toccata {

/// The overlay of two solids in general position, to the bit that of `overlay`, by rounded slopes alone: none where one
/// of them is within its error of zero, as where edges or faces are parallel.
[[nodiscard]] std::optional<SumFacets> general_overlay(const SumOperand& a, const SumOperand& b);

}  // namespace toccata
