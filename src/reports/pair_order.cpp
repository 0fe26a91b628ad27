#include "reports/pair_order.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

namespace toccata::io {
namespace {

/// Ascending from what is gravest; of brackets the graver end counts.
std::tuple<int, double> severity_of(const ReportedPair& pair) {
  if (pair.relation.kind == RelationKind::apart) return {3, pair.distance ? pair.distance->lower : 0};
  if (pair.relation.kind == RelationKind::touching)
    return {counts_as_contact(pair.relation, Touching::ignore) ? 1 : 2, 0};
  if (!is_clash(pair)) return {4, 0};
  return {0, pair.penetration ? -pair.penetration->upper : -std::numeric_limits<double>::infinity()};
}

}  // namespace

void sort_by_severity(std::vector<ReportedPair>& pairs) {
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const ReportedPair& x, const ReportedPair& y) { return severity_of(x) < severity_of(y); });
}

PairOrder pair_order_of(const JsonValue& question) {
  const std::string word = question.text_or("sort", "objects");
  if (word != "objects" && word != "severity")
    question.at("sort").fail(word + " is not known here", "write \"objects\" or \"severity\"");
  return word == "severity" ? PairOrder::severity : PairOrder::objects;
}

}  // namespace toccata::io
