#include "world/pair_rules.hpp"

#include <algorithm>

namespace toccata {

void PairRules::set(Index a, Index b, const Rule& rule) {
  for (const auto& key : {std::pair{a, b}, std::pair{b, a}}) {
    if (rule.is_empty())
      rules_.erase(key);
    else
      rules_.insert_or_assign(key, rule);
  }
}

const PairRules::Rule* PairRules::find(Index a, Index b) const {
  const auto at = rules_.find({a, b});
  return at == rules_.end() ? nullptr : &at->second;
}

bool PairRules::has_any(Index body) const {
  const auto at = rules_.lower_bound({body, 0});
  return at != rules_.end() && at->first.first == body;
}

double PairRules::largest_margin(Index body) const {
  double largest = 0;
  for (auto at = rules_.lower_bound({body, 0}); at != rules_.end() && at->first.first == body; ++at)
    if (!at->second.excluded) largest = std::max(largest, at->second.margin.value_or(0));
  return largest;
}

}  // namespace toccata
