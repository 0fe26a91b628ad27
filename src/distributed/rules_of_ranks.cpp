#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "distributed/distributed_state.hpp"
#include "query/posed_shape.hpp"
#include "toccata/core/error.hpp"

// Rules are few, and a body's holders have to know all of its own: so what is said is sent to all ranks, and each keeps
// what is about bodies that it has.
namespace toccata {
namespace {

PairRules::Rule rule_of(const GlobalPairRule& said) { return {said.excluded, said.margin}; }

std::pair<GlobalId, GlobalId> bodies_of(const GlobalPairRule& rule) {
  const auto [a, b] = std::minmax(rule.a, rule.b);
  return {a, b};
}

void put_rule(MessageWriter& writer, const GlobalPairRule& rule) {
  writer.put_number(rule.a);
  writer.put_number(rule.b);
  writer.put(rule.excluded);
  writer.put(rule.margin.has_value());
  writer.put(rule.margin.value_or(0));
}

GlobalPairRule get_rule(MessageReader& reader) {
  GlobalPairRule rule;
  rule.a = reader.get_number();
  rule.b = reader.get_number();
  rule.excluded = reader.get<bool>();
  const bool has_margin = reader.get<bool>();
  const auto margin = reader.get<double>();
  if (has_margin) rule.margin = margin;
  return rule;
}

void put_all_rules(MessageWriter& writer, std::span<const GlobalPairRule> rules) {
  writer.put_number(rules.size());
  for (const GlobalPairRule& rule : rules) put_rule(writer, rule);
}

void get_all_rules(MessageReader& reader, std::vector<GlobalPairRule>& rules) {
  for (std::uint64_t count = reader.get_number(); count > 0; --count) rules.push_back(get_rule(reader));
}

}  // namespace

RulesOfBody get_rules(MessageReader& reader) {
  std::vector<GlobalPairRule> said;
  get_all_rules(reader, said);
  RulesOfBody rules;
  for (const GlobalPairRule& one : said) rules.emplace(one.b, rule_of(one));
  return rules;
}

void DistributedWorld::State::put_rules(MessageWriter& letter, GlobalId id) const {
  std::vector<GlobalPairRule> rules;
  if (const auto found = rules_.find(id); found != rules_.end())
    for (const auto& [other, rule] : found->second) rules.push_back({id, other, rule.excluded, rule.margin});
  put_all_rules(letter, rules);
}

double DistributedWorld::State::rule_reach(GlobalId id) const {
  if (rules_.empty()) return 0;
  const auto found = rules_.find(id);
  if (found == rules_.end()) return 0;
  double largest = 0;
  for (const auto& [other, rule] : found->second)
    if (!rule.excluded) largest = std::max(largest, rule.margin.value_or(0));
  return half_rounded_up(largest);
}

void DistributedWorld::State::share_rules(WantedChanges& changes) {
  std::vector<GlobalPairRule> ended;
  for (const GlobalId id : changes.removed)
    if (const auto found = rules_.find(id); found != rules_.end())
      for (const auto& [other, rule] : found->second) ended.push_back({id, other});
  std::uint64_t count = ended.size() + changes.rules.size();
  ranks_.add_up({&count, 1});
  if (count == 0) return;
  MessageWriter own;
  put_all_rules(own, ended);
  put_all_rules(own, changes.rules);
  changes.rules.clear();
  for (const Bytes& bytes : ranks_.of_all(own.take())) {
    MessageReader reader(bytes);
    get_all_rules(reader, changes.rules_of_all);
    get_all_rules(reader, changes.rules);
  }
  require_rules_right(changes);
  changes.rules_of_all.insert(changes.rules_of_all.end(), changes.rules.begin(), changes.rules.end());
}

/// All ranks look at the same rules, and find the same.
void DistributedWorld::State::require_rules_right(const WantedChanges& changes) {
  std::unordered_set<GlobalId> here;
  for (const GlobalBody& added : changes.added) here.insert(added.id);
  const std::unordered_set<GlobalId> removed(changes.removed.begin(), changes.removed.end());
  std::vector<std::uint64_t> homes;
  for (const GlobalPairRule& rule : changes.rules)
    for (const GlobalId id : {rule.a, rule.b})
      homes.push_back(here.contains(id) || (lives_here(id) && !removed.contains(id)) ? 1 : 0);
  ranks_.add_up(homes);
  std::set<std::pair<GlobalId, GlobalId>> said;
  for (std::size_t i = 0; i < changes.rules.size(); ++i) {
    const GlobalPairRule& rule = changes.rules[i];
    const std::string name = fmt::format("the rule for {} and {}", name_of_body(rule.a), name_of_body(rule.b));
    for (const std::size_t end : {std::size_t{0}, std::size_t{1}})
      if (homes[2 * i + end] == 0)
        throw Error(fmt::format("{}: {} lives on no rank", name, name_of_body(end == 0 ? rule.a : rule.b)));
    if (!said.insert(bodies_of(rule)).second) throw Error(name + " is given twice for one step");
  }
}

void DistributedWorld::State::follow(const WantedChanges& changes) {
  if (changes.rules_of_all.empty()) return;
  std::unordered_set<GlobalId> added;
  for (const GlobalBody& one : changes.added) added.insert(one.id);
  const auto say = [&](GlobalId id, GlobalId other, const PairRules::Rule& rule) {
    const auto local = local_.find(id);
    if (local == local_.end() && !added.contains(id)) return;
    if (rule.is_empty())
      rules_[id].erase(other);
    else
      rules_[id].insert_or_assign(other, rule);
    // Its box may reach other ranks now.
    if (local == local_.end() || !copy(local->second).lives_here) return;
    note(local->second, Change::reach);
  };
  for (const GlobalPairRule& rule : changes.rules_of_all) {
    say(rule.a, rule.b, rule_of(rule));
    say(rule.b, rule.a, rule_of(rule));
  }
}

void DistributedWorld::State::tell_rules(const WantedChanges& changes, const News& news) {
  std::vector<PairRule> rules;
  const auto tell = [&](GlobalId a, GlobalId b, const PairRules::Rule& rule) {
    const auto first = local_.find(a), second = local_.find(b);
    if (first != local_.end() && second != local_.end())
      rules.push_back({first->second, second->second, rule.excluded, rule.margin});
  };
  for (const GlobalPairRule& rule : changes.rules_of_all) tell(rule.a, rule.b, rule_of(rule));
  for (const GlobalId id : news.with_rules)
    if (const auto found = rules_.find(id); found != rules_.end())
      for (const auto& [other, rule] : found->second) tell(id, other, rule);
  if (!rules.empty()) world_.set_rules(rules);
  // What came from here and went elsewhere, and what has no rules left.
  std::erase_if(rules_, [&](const auto& one) { return one.second.empty() || !local_.contains(one.first); });
}

}  // namespace toccata
