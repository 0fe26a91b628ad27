#include "query/scenes/clearances.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/require_length.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

std::string names_of(const NamedModels& models, const PairClearance& pair) {
  const auto [first, second] = std::minmax(pair.a, pair.b);
  return models.name(first) + " and " + models.name(second);
}

void require_checked_pair(const NamedModels& models, const PairClearance& pair) {
  if (pair.a >= models.count || pair.b >= models.count || pair.a == pair.b)
    throw Error(fmt::format("a clearance is asked for models {} and {}, and there are two different ones of {}", pair.a,
                            pair.b, models.count));
  const std::string_view group = models.group(pair.a);
  if (!group.empty() && group == models.group(pair.b))
    throw Error(
        fmt::format("a clearance is asked for {}, which are not checked against each other: both are in the "
                    "group \"{}\"",
                    names_of(models, pair), group));
}

}  // namespace

const RuleClearances Clearances::no_rules{};

Clearances::Clearances(const NamedModels& models, const CheckOptions& options, const RuleClearances& rules)
    : is_asked_(options.clearance || !options.pair_clearances.empty() || rules.of_pair),
      common_(options.clearance.value_or(0)),
      rules_(&rules) {
  require_length(common_, "a clearance");
  for (const PairClearance& pair : options.pair_clearances) {
    require_length(pair.clearance, "a clearance");
    require_checked_pair(models, pair);
    const auto [place, is_new] = of_pair_.emplace(std::minmax(pair.a, pair.b), pair.clearance);
    if (!is_new && place->second != pair.clearance)
      throw Error(fmt::format("for {} two clearances are asked, {} and {}; a pair has one", names_of(models, pair),
                              place->second, pair.clearance));
  }
}

}  // namespace toccata
