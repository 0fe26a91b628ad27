// World::step with a filter: the pairs that are wanted, and no others.
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "toccata/core/error.hpp"
#include "toccata/world/world.hpp"
#include "world/random_bodies.hpp"

namespace toccata::test {
namespace {

std::vector<std::pair<BodyId, BodyId>> pairs_of(const World& world) {
  std::vector<std::pair<BodyId, BodyId>> pairs;
  for (const PairReport& pair : world.pairs()) pairs.emplace_back(pair.a, pair.b);
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
  for (std::uint64_t frame = 0; frame < 20; ++frame) {
    const auto is_wanted = [&](BodyId a, BodyId b) { return (a.index + 3 * b.index + frame / 3) % 4 != 0; };
    const std::size_t candidates = all.step().candidates;
    const WorldStep& found = some.step([&](BodyId a, BodyId b) {
      EXPECT_LT(a.index, b.index);
      return is_wanted(a, b);
    });
    EXPECT_LE(found.candidates, candidates);
    std::vector<std::pair<BodyId, BodyId>> expected;
    for (const auto& [a, b] : pairs_of(all))
      if (is_wanted(a, b)) expected.emplace_back(a, b);
    EXPECT_EQ(pairs_of(some), expected) << frame;
    for (const BodyId id : ids) {
      if (random.below(6) != 0) continue;
      const Pose to = random_place("any", random);
      all.move(id, to);
      some.move(id, to);
    }
  }
}

TEST(WantedPairs, AreNoneOfAWorldThatHasToKnowAll) {
  World world({.space_time = true});
  EXPECT_THROW(world.step([](BodyId, BodyId) { return true; }), Error);
  EXPECT_EQ(world.step().candidates, 0U);
}

}  // namespace
}  // namespace toccata::test
