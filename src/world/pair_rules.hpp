#pragma once

#include <map>
#include <optional>
#include <set>
#include <tuple>
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
      const Index partner = last->first.second;
      rank(body, partner, last->second, Rule{});
      rank(partner, body, last->second, Rule{});
      rules_.erase({partner, body});
      partner_of(partner);
    }
    rules_.erase(first, last);
  }

  /// Null where nothing is said.
  [[nodiscard]] const Rule* find(Index a, Index b) const;
  [[nodiscard]] bool has_any(Index body) const;
  /// The greatest margin of its rules, or 0. However many there are, few are looked at.
  [[nodiscard]] double largest_margin(Index body) const;

 private:
  /// Puts a body's margin with another where it belongs among all of the body's.
  void rank(Index body, Index other, const Rule& before, const Rule& now);

  std::map<std::pair<Index, Index>, Rule> rules_;  ///< each in both orders
  /// (body, −margin, other) of rules that let pairs be: a body's greatest margin comes first.
  std::set<std::tuple<Index, double, Index>> by_margin_;
};

}  // namespace toccata
