#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>

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
  /// Throws Error for what is no length, for pairs that are not there or not checked, and for a pair that has two.
  Clearances(const NamedModels& models, const CheckOptions& options);

  [[nodiscard]] bool is_asked() const { return is_asked_; }

  /// The clearance of all pairs that have none of their own.
  [[nodiscard]] double common() const { return common_; }

  /// The clearances of those that have one, by pairs in ascending order.
  [[nodiscard]] const std::map<std::pair<Index, Index>, double>& of_pairs() const { return of_pair_; }

  /// The clearance of a pair in ascending order.
  [[nodiscard]] double of(const IndexPair& pair) const {
    const auto found = of_pair_.find({pair.first, pair.second});
    return found == of_pair_.end() ? common_ : found->second;
  }

 private:
  bool is_asked_;
  double common_;
  std::map<std::pair<Index, Index>, double> of_pair_;
};

}  // namespace toccata
