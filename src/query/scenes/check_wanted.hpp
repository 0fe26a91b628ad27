#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "toccata/broad/broad_phase.hpp"
#include "toccata/query/check_all.hpp"

namespace toccata {

/// The length that a rule tells of a pair, else nothing; pairs come in ascending order.
using PairLengths = std::function<std::optional<double>(const IndexPair&)>;

/// Clearances that rules tell, in place of that of all pairs.
struct RuleClearances {
  PairLengths of_pair{};           ///< empty where there are no rules
  std::vector<double> greatest{};  ///< of the rules that each model is in, 0 where it is in none; finite
};

/// What rules say of pairs. What is empty says nothing.
struct CheckPairRules {
  PairFilter wanted{};       ///< which are looked at; empty: all
  PairFilter here{};         ///< of which that is asked at all; empty: of all. Others are counted nowhere
  PairLengths tolerances{};  ///< in place of that of all pairs
  RuleClearances clearances{};
};

/// What `check_all` answers of the pairs that are wanted alone.
struct WantedAnswer {
  CheckAnswer answer;
  std::size_t left_out = 0;    ///< pairs that would have been looked at and are not wanted
  std::size_t unfinished = 0;  ///< of the candidates those that were not looked at, as it was stopped before
};

/// Who looks on while the pairs are looked at.
struct CheckWatch {
  /// Asked before each pair and while depths are looked for, from any thread: once it is true no pair is begun any
  /// more, and the brackets of depths are as wide as they are.
  std::function<bool()> stop{};
  /// Told each pair that is found, in the order in which they are; from any thread, never from two at once.
  std::function<void(const PairAnswer&)> found{};
  /// Where it is false, the answer has none of the pairs, and who has not looked on (`found`) never sees them.
  bool keeps_found = true;
};

/// The pair clearances are of pairs that are wanted, and count more than rules.
[[nodiscard]] WantedAnswer check_wanted(std::span<const SceneInstance> models, const CheckOptions& options,
                                        const CheckPairRules& rules, const CheckWatch& watch = {});

}  // namespace toccata
