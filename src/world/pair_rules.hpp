#pragma once

#include <map>
#include <optional>
#include <utility>

#include "toccata/core/index.hpp"

namespace toccata {

/// What is said about two bodies in particular, by their indices.
class PairRules {
 public:
  struct Rule {
    bool excluded = false;
    std::optional<double> margin{};
    [[nodiscard]] bool is_empty() const { return !excluded && !margin; }
  };

  /// In place of what was said about the two; an empty rule ends it.
  void set(Index a, Index b, const Rule& rule);
  /// All rules of a body end. Calls `partner_of` for each other body that had one with it.
  template <class See>
  void forget(Index body, const See& partner_of) {
    const auto first = rules_.lower_bound({body, 0});
    auto last = first;
    for (; last != rules_.end() && last->first.first == body; ++last) {
      rules_.erase({last->first.second, body});
      partner_of(last->first.second);
    }
    rules_.erase(first, last);
  }

  /// Null where nothing is said.
  [[nodiscard]] const Rule* find(Index a, Index b) const;
  [[nodiscard]] bool has_any(Index body) const;
  /// The greatest margin of its rules, or 0.
  [[nodiscard]] double largest_margin(Index body) const;

 private:
  std::map<std::pair<Index, Index>, Rule> rules_;  ///< each in both orders
};

}  // namespace toccata
