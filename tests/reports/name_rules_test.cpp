// Patterns and rules of pairs against the slow, obvious way.
#include "reports/name_rules.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "toccata/core/random.hpp"
#include "toccata/reports.hpp"
#include "toccata/toccata.hpp"

namespace toccata {
namespace {

/// By the definition, with letters of one byte.
bool matches_slowly(std::string_view pattern, std::string_view name) {
  if (pattern.empty()) return name.empty();
  const std::string_view rest = pattern.substr(1);
  if (pattern[0] == '*')
    return matches_slowly(rest, name) || (!name.empty() && matches_slowly(pattern, name.substr(1)));
  if (name.empty()) return false;
  if (pattern[0] == '?') return matches_slowly(rest, name.substr(1));
  if (pattern[0] == '\\' && !rest.empty()) return rest[0] == name[0] && matches_slowly(rest.substr(1), name.substr(1));
  return pattern[0] == name[0] && matches_slowly(rest, name.substr(1));
}

std::string word(Random& random, std::string_view letters, std::size_t most) {
  std::string text;
  for (std::size_t i = random.below(most + 1); i-- > 0;) text += letters[random.below(letters.size())];
  return text;
}

TEST(NameRules, PatternsMatchAsTheyAreDefined) {
  Random random(7);
  std::size_t matching = 0;
  for (int i = 0; i < 200'000; ++i) {
    const std::string pattern = word(random, "ab*?\\/", 7), name = word(random, "ab*?\\/", 7);
    ASSERT_EQ(matches_pattern(pattern, name), matches_slowly(pattern, name)) << pattern << "  " << name;
    matching += matches_slowly(pattern, name) ? 1 : 0;
  }
  EXPECT_GT(matching, 5'000U);
}

TEST(NameRules, PatternsKnowCharactersOfMoreThanAByte) {
  EXPECT_TRUE(matches_pattern("Tür ?", "Tür ß"));
  EXPECT_TRUE(matches_pattern("T?r", "Tür"));
  EXPECT_FALSE(matches_pattern("T??r", "Tür"));
  EXPECT_TRUE(matches_pattern("*/螺栓-?", "组件/螺栓-八"));
  EXPECT_TRUE(matches_pattern("\\ü*", "übrig"));
  EXPECT_FALSE(matches_pattern("tür", "Tür"));
}

TEST(NameRules, ManyStarsTakeNoTimeToSpeakOf) {
  std::string pattern;
  for (int i = 0; i < 50; ++i) pattern += "*a";
  EXPECT_FALSE(matches_pattern(pattern + "*b", std::string(20'000, 'a')));
}

bool is_of(const std::vector<NameRule>& rules, const std::string& one, const std::string& other) {
  const auto is_in = [](const std::vector<std::string>& patterns, const std::string& name) {
    return std::ranges::any_of(patterns, [&](const std::string& pattern) { return matches_slowly(pattern, name); });
  };
  return std::ranges::any_of(rules, [&](const NameRule& rule) {
    return (is_in(rule.a, one) && is_in(rule.b, other)) || (is_in(rule.a, other) && is_in(rule.b, one));
  });
}

std::vector<NameRule> some_rules(Random& random) {
  std::vector<NameRule> rules(random.below(4));
  for (NameRule& rule : rules)
    for (std::vector<std::string>* side : {&rule.a, &rule.b})
      for (std::size_t i = random.below(3) + 1; i-- > 0;) side->push_back(word(random, "ab*?", 3));
  return rules;
}

TEST(NameRules, LeaveThePairsOfTheDefinition) {
  Random random(8);
  for (int i = 0; i < 500; ++i) {
    std::vector<SceneInstance> models;
    for (const char* const name : {"a", "b", "ab", "ba", "aab", "bb"}) models.push_back({Sphere{1}, {}, {}, name, {}});
    const NameRules rules{some_rules(random), some_rules(random)};
    const PairFilter wanted = io::pair_rules(rules, models).wanted;
    ASSERT_EQ(wanted == nullptr, rules.empty());
    for (Index a = 0; wanted && a < models.size(); ++a)
      for (Index b = a + 1; b < models.size(); ++b) {
        const std::string &one = models[a].name, &other = models[b].name;
        const bool expected =
            (rules.between.empty() || is_of(rules.between, one, other)) && !is_of(rules.ignored, one, other);
        ASSERT_EQ(wanted({a, b}), expected) << one << " " << other;
      }
  }
}

TEST(NameRules, TellTheLengthsOfTheDefinition) {
  Random random(10);
  std::size_t told = 0;
  for (int i = 0; i < 200; ++i) {
    std::vector<SceneInstance> models;
    for (const char* const name : {"a", "b", "ab", "ba", "aab", "bb"}) models.push_back({Sphere{1}, {}, {}, name, {}});
    NameRules rules;
    for (const NameRule& rule : some_rules(random)) rules.clearances.push_back({rule, random.unit()});
    const RuleClearances found = io::pair_rules(rules, models).clearances;
    ASSERT_EQ(found.of_pair == nullptr, rules.clearances.empty());
    for (Index a = 0; found.of_pair && a < models.size(); ++a)
      for (Index b = a + 1; b < models.size(); ++b) {
        std::optional<double> expected;
        for (const LengthRule& rule : rules.clearances)
          if (is_of({rule.pairs}, models[a].name, models[b].name)) expected = rule.length;
        ASSERT_EQ(found.of_pair({a, b}), expected) << models[a].name << " " << models[b].name;
        ASSERT_GE(std::min(found.greatest[a], found.greatest[b]), expected.value_or(0));
        told += expected ? 1U : 0U;
      }
  }
  EXPECT_GT(told, 300U);
}

TEST(NameRules, LeaveAPairWhereTheDefinitionDoes) {
  Random random(9);
  std::size_t leaving = 0;
  for (int i = 0; i < 2'000; ++i) {
    std::vector<SceneInstance> models;
    for (std::size_t n = random.below(7); n-- > 0;)
      models.push_back({Sphere{1}, {}, {}, word(random, "ab", 2), word(random, "g", 1)});
    const NameRules rules{some_rules(random), some_rules(random)};
    bool expected = false;
    for (std::size_t a = 0; a < models.size(); ++a)
      for (std::size_t b = a + 1; b < models.size(); ++b) {
        const std::string &one = models[a].name, &other = models[b].name;
        const bool share_group = !models[a].group.empty() && models[a].group == models[b].group;
        expected = expected || (!share_group && (rules.between.empty() || is_of(rules.between, one, other)) &&
                                !is_of(rules.ignored, one, other));
      }
    ASSERT_EQ(leave_a_pair(rules, models), expected) << i;
    leaving += expected ? 1 : 0;
  }
  EXPECT_GT(leaving, 300U);
  EXPECT_LT(leaving, 1'700U);
}

TEST(NameRules, WhatTheyLeaveOutIsCountedOnceAndNotLookedAt) {
  std::vector<SceneInstance> models;
  for (int i = 0; i < 40; ++i)
    models.push_back({Sphere{1}, {}, {}, (i < 30 ? "bolt-" : "plate-") + std::to_string(i), {}});
  CheckQuestion question;
  question.rules.ignored = {{{"bolt-*"}, {"bolt-*"}}, {{"bolt-1*"}, {"*"}}};
  for (const int threads : {1, 4}) {
    const auto report = std::get<CheckReport>(ask(models, question, {.threads = threads}));
    EXPECT_EQ(report.left_out, 30U * 29 / 2 + 11 * 10);
    EXPECT_EQ(report.candidate_pairs, 40U * 39 / 2 - *report.left_out);
    EXPECT_EQ(report.pairs.size(), report.candidate_pairs);
  }
  EXPECT_EQ(std::get<CheckReport>(ask(models, CheckQuestion{})).left_out, std::nullopt);
}

}  // namespace
}  // namespace toccata
