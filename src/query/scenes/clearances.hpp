#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "query/scenes/check_wanted.hpp"
#include "toccata/broad/broad_phase.hpp"
#include "toccata/core/function_ref.hpp"
#include "toccata/query/check_all.hpp"

namespace toccata {

/// What is known of the models of a scene before any of them is looked at.
struct NamedModels {
  std::size_t count = 0;
  FunctionRef<std::string(std::size_t model)> name;  ///< as messages have it
  FunctionRef<std::string_view(std::size_t model)> group;
};

/// How near which pairs have to be to be told.
class Clearances {
 public:
  /// Throws Error for what is no length, for pairs that are not there or not checked, and for a pair that has two. The
  /// rules must outlive it.
  Clearances(const NamedModels& models, const CheckOptions& options, const RuleClearances& rules = no_rules);

  [[nodiscard]] bool is_asked() const { return is_asked_; }

  /// The clearance of all pairs that have none of their own.
  [[nodiscard]] double common() const { return common_; }

  /// The clearance of a model and those that it may be near to, at least that of each, but for the pairs that have one
  /// of their own.
  [[nodiscard]] double greatest_of(std::size_t model) const {
    return rules_->of_pair ? std::max(common_, rules_->greatest[model]) : common_;
  }

  /// Whether not all pairs without one of their own have the common one.
  [[nodiscard]] bool have_rules() const { return static_cast<bool>(rules_->of_pair); }

  /// The clearances of those that have one of their own, by pairs in ascending order.
  [[nodiscard]] const std::map<std::pair<Index, Index>, double>& of_pairs() const { return of_pair_; }

  /// The clearance of a pair in ascending order.
  [[nodiscard]] double of(const IndexPair& pair) const {
    const auto found = of_pair_.find({pair.first, pair.second});
    if (found != of_pair_.end()) return found->second;
    const std::optional<double> by_rule = have_rules() ? rules_->of_pair(pair) : std::nullopt;
    return by_rule.value_or(common_);
  }

 private:
  static const RuleClearances no_rules;

  bool is_asked_;
  double common_;
  std::map<std::pair<Index, Index>, double> of_pair_;
  const RuleClearances* rules_;
};

}  // namespace toccata
