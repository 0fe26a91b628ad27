// World::step with a filter: the pairs that are wanted, and no others.
#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "toccata/core/error.hpp"
#include "toccata/world/world.hpp"
#include "world/random_bodies.hpp"

namespace toccata::test {
namespace {

using Pairs = std::vector<std::pair<BodyId, BodyId>>;

Pairs pairs_of(std::span<const PairReport> reports) {
  Pairs pairs;
  for (const PairReport& pair : reports) pairs.emplace_back(pair.a, pair.b);
  return pairs;
}

/// Whichever pairs are wanted in a step, they are told as a step of all tells them, also where they were not looked at
/// before; and no other is asked about.
TEST(WantedPairs, AreToldAsByAStepOfAll) {
  Random random(11);
  World all;
  std::vector<Body> bodies;
  for (int i = 0; i < 60; ++i) bodies.push_back(random_body("any", random));
  const std::vector<BodyId> ids = all.add(bodies);
  World some = all;
  Pairs before;
  for (std::uint64_t frame = 0; frame < 20; ++frame) {
    const auto is_wanted = [&](BodyId a, BodyId b) { return (a.index + 3 * b.index + frame / 3) % 4 != 0; };
    const std::size_t candidates = all.step().candidates;
    const WorldStep& found = some.step([&](BodyId a, BodyId b) {
      EXPECT_LT(a.index, b.index);
      return is_wanted(a, b);
    });
    EXPECT_LE(found.candidates, candidates);
    Pairs expected;
    for (const auto& [a, b] : pairs_of(all.pairs()))
      if (is_wanted(a, b)) expected.emplace_back(a, b);
    EXPECT_EQ(pairs_of(some.pairs()), expected) << frame;
    Pairs told = before;
    std::erase_if(told, [&](const auto& pair) { return std::ranges::count(expected, pair) == 0; });
    EXPECT_EQ(pairs_of(found.persist), told) << frame;
    EXPECT_EQ(found.begin.size() + found.persist.size(), expected.size()) << frame;
    EXPECT_EQ(found.end.size() + found.persist.size(), before.size()) << frame;
    before = expected;
    for (const BodyId id : ids) {
      if (random.below(6) != 0) continue;
      const Pose to = random_place("any", random);
      all.move(id, to);
      some.move(id, to);
    }
  }
}

/// What is shown is what the lists of another World tell, and no list is kept.
TEST(WantedPairs, AreShownWithoutLists) {
  Random random(12);
  World listed;
  std::vector<Body> bodies;
  for (int i = 0; i < 60; ++i) bodies.push_back(random_body("any", random));
  const std::vector<BodyId> ids = listed.add(bodies);
  World shown = listed;
  shown.step();
  EXPECT_FALSE(shown.pairs().empty());
  for (std::uint64_t frame = 0; frame < 10; ++frame) {
    const auto is_wanted = [&](BodyId a, BodyId b) { return (a.index + b.index + frame) % 3 != 0; };
    std::vector<PairReport> seen;
    const WorldStep& step = shown.step(is_wanted, [&](const PairReport& pair) { seen.push_back(pair); });
    EXPECT_EQ(step.candidates, listed.step(is_wanted).candidates);
    EXPECT_EQ(pairs_of(seen), pairs_of(listed.pairs())) << frame;
    for (std::size_t i = 0; i < std::min(seen.size(), listed.pairs().size()); ++i)
      EXPECT_EQ(seen[i].in_contact, listed.pairs()[i].in_contact);
    EXPECT_TRUE(shown.pairs().empty() && step.begin.empty() && step.persist.empty() && step.end.empty());
    for (const BodyId id : ids) {
      if (random.below(4) != 0) continue;
      const Pose to = random_place("any", random);
      listed.move(id, to);
      shown.move(id, to);
    }
  }
  listed.step();
  EXPECT_EQ(pairs_of(shown.step().begin), pairs_of(listed.pairs()));
  EXPECT_TRUE(shown.last_step().persist.empty() && shown.last_step().end.empty());
}

TEST(WantedPairs, AreNoneOfAWorldThatHasToKnowAll) {
  World world({.space_time = true});
  EXPECT_THROW(world.step([](BodyId, BodyId) { return true; }), Error);
  EXPECT_EQ(world.step().candidates, 0U);
}

/// What `progress` throws ends a step wherever it comes, and nothing of the steps after it shows that, also where steps
/// are scheduled ahead.
TEST(StepProgress, EndsAStepThatIsThenAsIfItHadNotBegun) {
  struct Ended {};
  for (const bool space_time : {false, true}) {
    Random random(5);
    World undisturbed({.distance = true, .space_time = space_time});
    std::vector<Body> bodies;
    for (int i = 0; i < 40; ++i) bodies.push_back(random_body("convex", random));
    const std::vector<BodyId> ids = undisturbed.add(bodies);
    World ended = undisturbed;
    std::size_t times_ended = 0;
    for (std::size_t frame = 0; frame < 24; ++frame) {
      const WorldStep before = ended.last_step();
      std::size_t seen = 0, total = 0;
      try {
        ended.step([&](std::size_t done, std::size_t all) {
          EXPECT_EQ(done, ++seen);
          total = all;
          if (done == frame % 7 + 1) throw Ended();
        });
        EXPECT_EQ(seen, total);
      } catch (const Ended&) {
        ++times_ended;
        EXPECT_EQ(pairs_of(ended.last_step().begin), pairs_of(before.begin));
        EXPECT_EQ(pairs_of(ended.last_step().end), pairs_of(before.end));
        ended.step();
      }
      undisturbed.step();
      EXPECT_EQ(pairs_of(ended.pairs()), pairs_of(undisturbed.pairs())) << frame;
      EXPECT_EQ(pairs_of(ended.last_step().begin), pairs_of(undisturbed.last_step().begin)) << frame;
      for (const BodyId id : ids) {
        Pose to = undisturbed.body(id).pose;
        to.offset = to.offset + vector_in(random, -0.05, 0.05);
        undisturbed.move(id, to);
        ended.move(id, to);
      }
    }
    EXPECT_GT(times_ended, 5U);
  }
}

}  // namespace
}  // namespace toccata::test
