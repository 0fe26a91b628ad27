#include "world/pair_rules.hpp"

#include "math/constants.hpp"

namespace toccata {
namespace {

bool has_margin(const PairRules::Rule& rule) { return !rule.excluded && rule.margin.has_value(); }

}  // namespace

void PairRules::rank(Index body, Index other, const Rule& before, const Rule& now) {
  if (has_margin(before)) by_margin_.erase({body, -*before.margin, other});
  if (has_margin(now)) by_margin_.insert({body, -*now.margin, other});
}

void PairRules::set(Index a, Index b, const Rule& rule) {
  const Rule* known = find(a, b);
  const Rule before = known != nullptr ? *known : Rule{};
  for (const auto& key : {std::pair{a, b}, std::pair{b, a}}) {
    rank(key.first, key.second, before, rule);
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
  const auto at = by_margin_.lower_bound({body, -infinity, 0});
  return at != by_margin_.end() && std::get<0>(*at) == body ? -std::get<1>(*at) : 0;
}

}  // namespace toccata
