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
  std::size_t left_out = 0;    ///< pairs that would have been looked at and are not wanted
  std::size_t unfinished = 0;  ///< of the candidates those that were not looked at, as it was stopped before
};

/// Who looks on while the pairs are looked at.
struct CheckWatch {
  /// Asked before each pair, from any thread: once it is true no pair is begun any more.
  std::function<bool()> stop{};
  /// Told each pair that is found, in the order in which they are; from any thread, never from two at once.
  std::function<void(const PairAnswer&)> found{};
};

/// Without a filter all are wanted. The pair clearances are of pairs that are. A tolerance of its own takes the place
/// of that of all.
[[nodiscard]] WantedAnswer check_wanted(std::span<const SceneInstance> models, const CheckOptions& options,
                                        const PairFilter& wanted, const PairTolerances& tolerances = {},
                                        const CheckWatch& watch = {});

}  // namespace toccata
