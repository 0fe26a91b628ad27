#include "reports/name_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "toccata/core/error.hpp"
#include "toccata/reports/scene_question.hpp"

namespace toccata {
namespace {

/// How many bytes the character of UTF-8 has that the text begins with.
std::size_t character_size(std::string_view text) {
  std::size_t size = 1;
  while (size < text.size() && (static_cast<unsigned char>(text[size]) & 0xC0U) == 0x80U) ++size;
  return size;
}

/// Takes from both what one sign other than `*` stands for; false where it stands for something else.
bool take_one(std::string_view& pattern, std::string_view& name) {
  if (pattern.empty() || name.empty()) return false;
  if (pattern[0] == '?') {
    pattern.remove_prefix(1);
    name.remove_prefix(character_size(name));
    return true;
  }
  const std::size_t size = pattern[0] == '\\' && pattern.size() > 1 ? 2 : 1;
  if (pattern[size - 1] != name[0]) return false;
  pattern.remove_prefix(size);
  name.remove_prefix(1);
  return true;
}

}  // namespace

bool matches_pattern(std::string_view pattern, std::string_view name) {
  // Where there are several `*`, only the last has to be tried again: what is before it is matched as early as can be.
  std::optional<std::string_view> after_star;
  std::string_view tried;
  while (!name.empty() || !pattern.empty()) {
    if (pattern.starts_with('*')) {
      pattern.remove_prefix(1);
      after_star = pattern;
      tried = name;
    } else if (!take_one(pattern, name)) {
      if (!after_star || tried.empty()) return false;
      tried.remove_prefix(character_size(tried));
      pattern = *after_star;
      name = tried;
    }
  }
  return true;
}

namespace io {
namespace {

/// The objects of a scene by their names.
class Names {
 public:
  explicit Names(std::span<const SceneInstance> models) : models_(models) {
    for (std::size_t i = 0; i < models.size(); ++i) places_[models[i].name].push_back(i);
  }

  [[nodiscard]] std::size_t count() const { return models_.size(); }

  /// Ascending, each once.
  [[nodiscard]] std::vector<std::size_t> of_any(std::span<const std::string> patterns) const {
    std::vector<std::size_t> members;
    for (const std::string& pattern : patterns) add(pattern, members);
    std::sort(members.begin(), members.end());
    members.erase(std::unique(members.begin(), members.end()), members.end());
    return members;
  }

 private:
  /// A name that means itself is looked up: there may be a rule for each of very many objects.
  void add(const std::string& pattern, std::vector<std::size_t>& members) const {
    if (pattern.find_first_of("*?\\") == std::string::npos) {
      if (const auto found = places_.find(pattern); found != places_.end())
        members.insert(members.end(), found->second.begin(), found->second.end());
      return;
    }
    for (std::size_t i = 0; i < models_.size(); ++i)
      if (matches_pattern(pattern, models_[i].name)) members.push_back(i);
  }

  std::span<const SceneInstance> models_;
  std::map<std::string_view, std::vector<std::size_t>> places_;
};

bool have_common(const std::vector<std::size_t>& a, const std::vector<std::size_t>& b) {
  for (auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end();) {
    if (*i == *j) return true;
    if (*i < *j)
      ++i;
    else
      ++j;
  }
  return false;
}

/// Knows the rules that each object is in, so that a pair is decided by those of two objects.
class RuleMembers {
 public:
  RuleMembers(std::span<const NameRule> rules, const Names& names)
      : in_a_(names.count()), in_b_(names.count()), with_all_(names.count()) {
    for (std::size_t rule = 0; rule < rules.size(); ++rule) add(rules[rule], rule, names);
  }

  /// In which rules an object is. Objects of the same ones are in the same pairs.
  using Membership = std::tuple<std::vector<std::size_t>, std::vector<std::size_t>, bool>;
  [[nodiscard]] Membership of(std::size_t object) const { return {in_a_[object], in_b_[object], with_all_[object]}; }

  /// Whether it is a pair of some rule.
  [[nodiscard]] bool contain(const IndexPair& pair) const {
    const auto [i, j] = pair;
    return with_all_[i] || with_all_[j] || have_common(in_a_[i], in_b_[j]) || have_common(in_b_[i], in_a_[j]);
  }

 private:
  static bool is_all(const std::vector<std::string>& patterns) {
    return std::find(patterns.begin(), patterns.end(), "*") != patterns.end();
  }

  /// Rules of some objects with all are kept apart, as every object is in all of them.
  void add(const NameRule& rule, std::size_t number, const Names& names) {
    if (is_all(rule.a) || is_all(rule.b)) {
      for (const std::size_t i : names.of_any(is_all(rule.a) ? rule.b : rule.a)) with_all_[i] = true;
      return;
    }
    for (const std::size_t i : names.of_any(rule.a)) in_a_[i].push_back(number);
    for (const std::size_t i : names.of_any(rule.b)) in_b_[i].push_back(number);
  }

  std::vector<std::vector<std::size_t>> in_a_, in_b_;
  std::vector<bool> with_all_;
};

}  // namespace

namespace {

PairFilter wanted_pairs(const NameRules& rules, const Names& names) {
  if (rules.empty()) return {};
  const auto between = std::make_shared<const RuleMembers>(rules.between, names);
  const auto ignored = std::make_shared<const RuleMembers>(rules.ignored, names);
  return [between, ignored, all = rules.between.empty()](const IndexPair& pair) {
    return (all || between->contain(pair)) && !ignored->contain(pair);
  };
}

PairLengths lengths_of(std::span<const LengthRule> rules, const Names& names) {
  if (rules.empty()) return {};
  struct Told {
    RuleMembers members;
    double length;
  };
  const auto all = std::make_shared<std::vector<Told>>();
  for (const LengthRule& rule : rules) {
    if (!(rule.length >= 0) || !std::isfinite(rule.length))
      throw Error(fmt::format("a rule has the length {}; give a finite one of at least 0", rule.length));
    all->push_back({RuleMembers(std::span(&rule.pairs, 1), names), rule.length});
  }
  return [all](const IndexPair& pair) -> std::optional<double> {
    const auto found =
        std::find_if(all->rbegin(), all->rend(), [&](const Told& told) { return told.members.contain(pair); });
    return found == all->rend() ? std::nullopt : std::optional(found->length);
  };
}

/// Each object has the greatest length of the rules that it is in.
std::vector<double> greatest_lengths(std::span<const LengthRule> rules, const Names& names) {
  std::vector<double> greatest(rules.empty() ? 0 : names.count());
  for (const LengthRule& rule : rules)
    for (const std::vector<std::string>* patterns : {&rule.pairs.a, &rule.pairs.b})
      for (const std::size_t i : names.of_any(*patterns)) greatest[i] = std::max(greatest[i], rule.length);
  return greatest;
}

}  // namespace

CheckPairRules pair_rules(const NameRules& rules, std::span<const SceneInstance> models) {
  const Names names(models);
  CheckPairRules result;
  result.wanted = wanted_pairs(rules, names);
  result.tolerances = lengths_of(rules.tolerances, names);
  result.clearances = {lengths_of(rules.clearances, names), greatest_lengths(rules.clearances, names)};
  return result;
}

}  // namespace io

bool leave_a_pair(const NameRules& rules, std::span<const SceneInstance> models) {
  const io::Names names(models);
  const io::RuleMembers between(rules.between, names), ignored(rules.ignored, names);
  // Two objects are enough where no rule and no group tells more apart.
  using Kind = std::tuple<std::string_view, io::RuleMembers::Membership, io::RuleMembers::Membership>;
  std::map<Kind, int> seen;
  std::vector<Index> some;
  for (std::size_t i = 0; i < models.size(); ++i)
    if (seen[{models[i].group, between.of(i), ignored.of(i)}]++ < 2) some.push_back(static_cast<Index>(i));
  const auto is_left = [&](const IndexPair& pair) {
    const std::string& group = models[pair.first].group;
    if (!group.empty() && group == models[pair.second].group) return false;
    return (rules.between.empty() || between.contain(pair)) && !ignored.contain(pair);
  };
  for (auto a = some.begin(); a != some.end(); ++a)
    for (auto b = std::next(a); b != some.end(); ++b)
      if (is_left({*a, *b})) return true;
  return false;
}

}  // namespace toccata
