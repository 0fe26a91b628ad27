#include "world/pair_rules.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "toccata/core/random.hpp"
#include "toccata/world/world.hpp"

namespace toccata {
namespace {

/// What is said of every two bodies, in a table.
struct RuleTable {
  explicit RuleTable(Index bodies) : count(bodies), rules(bodies * bodies) {}
  PairRules::Rule& of(Index a, Index b) { return rules[std::min(a, b) * count + std::max(a, b)]; }
  void forget(Index body) {
    for (Index other = 0; other < count; ++other) of(body, other) = {};
  }
  double largest_margin(Index body) {
    double largest = 0;
    for (Index other = 0; other < count; ++other)
      if (!of(body, other).excluded) largest = std::max(largest, of(body, other).margin.value_or(0));
    return largest;
  }
  bool has_any(Index body) {
    for (Index other = 0; other < count; ++other)
      if (!of(body, other).is_empty()) return true;
    return false;
  }
  Index count;
  std::vector<PairRules::Rule> rules;
};

TEST(PairRules, TellTheSameAsATableThroughALife) {
  constexpr Index bodies = 7;
  Random random(1);
  PairRules rules;
  RuleTable table(bodies);
  for (int i = 0; i < 4000; ++i) {
    const auto a = static_cast<Index>(random.below(bodies)), b = static_cast<Index>(random.below(bodies));
    if (random.below(20) == 0) {
      rules.forget(a, [](Index) {});
      table.forget(a);
    } else if (a != b) {
      PairRules::Rule rule;
      rule.excluded = random.below(4) == 0;
      if (random.below(2) == 0) rule.margin = 0.25 * static_cast<double>(random.below(4));
      rules.set(a, b, rule);
      table.of(a, b) = rule;
    }
    for (Index body = 0; body < bodies; ++body) {
      ASSERT_EQ(rules.largest_margin(body), table.largest_margin(body)) << i;
      ASSERT_EQ(rules.has_any(body), table.has_any(body)) << i;
    }
  }
}

/// With a walk over all rules of the one for each that comes or goes this would be two thousand million steps.
TEST(PairRules, OfOneBodyWithVeryManyOthersComeAndGoOneByOne) {
  constexpr Index others = 40'000;
  PairRules rules;
  for (Index i = 1; i <= others; ++i) {
    rules.set(0, i, {false, 1e-3 * i});
    ASSERT_EQ(rules.largest_margin(0), 1e-3 * i);
  }
  for (Index i = others; i > 0; --i) {
    ASSERT_EQ(rules.largest_margin(0), 1e-3 * i);
    rules.forget(i, [](Index partner) { ASSERT_EQ(partner, 0U); });
  }
  EXPECT_FALSE(rules.has_any(0));
  EXPECT_EQ(rules.largest_margin(0), 0);
}

TEST(World, HasVeryManyRulesOfOneBody) {
  constexpr int count = 3000;
  World world;
  const BodyId ground = world.add(Body{Box({1e4, 1e4, 1}), Pose::translation(0, 0, -1)});
  std::vector<BodyId> balls;
  for (int i = 0; i < count; ++i) balls.push_back(world.add(Body{Sphere(0.5), Pose::translation(3 * i, 0, 0.75)}));
  EXPECT_EQ(world.step().begin.size(), 0U);
  for (const BodyId ball : balls) world.set_rule({.a = ground, .b = ball, .margin = 0.5});
  EXPECT_EQ(world.step().begin.size(), balls.size());
  for (const BodyId ball : balls) world.set_rule({.a = ground, .b = ball, .excluded = true});
  EXPECT_EQ(world.step().end.size(), balls.size());
}

}  // namespace
}  // namespace toccata
