#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>

#include "toccata/broad/broad_phase.hpp"
#include "toccata/query/check_all.hpp"

namespace toccata {

/// The tolerance of a pair that has one of its own, else nothing; pairs come in ascending order.
using PairTolerances = std::function<std::optional<double>(const IndexPair&)>;

/// What `check_all` answers of the pairs that are wanted alone.
struct WantedAnswer {
  CheckAnswer answer;
  std::size_t left_out = 0;  ///< pairs that would have been looked at and are not wanted
};

/// Without a filter all are wanted. The pair clearances are of pairs that are. A tolerance of its own takes the place
/// of that of all.
[[nodiscard]] WantedAnswer check_wanted(std::span<const SceneInstance> models, const CheckOptions& options,
                                        const PairFilter& wanted, const PairTolerances& tolerances = {});

}  // namespace toccata
