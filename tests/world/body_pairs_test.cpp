#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/error_message.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/query/overlap.hpp"
#include "toccata/world/world_queries.hpp"
#include "world/random_bodies.hpp"

namespace toccata {
namespace {

using test::message_of;

PairQuery query_of(const Body& a, const Body& b) { return {a.pose, b.pose, a.solid, b.solid}; }

bool in_categories(const Body& a, const Body& b, const BodyPairs& pairs) {
  return ((a.category & pairs.first_categories) != 0 && (b.category & pairs.second_categories) != 0) ||
         ((b.category & pairs.first_categories) != 0 && (a.category & pairs.second_categories) != 0);
}

/// All pairs of a World that are asked about, in the plainest way: of a copy in which the bodies are where they are
/// placed.
std::vector<BodyPair> all_asked(const World& world, const BodyPairs& pairs) {
  const auto is_placed = [&](BodyId id) {
    return std::ranges::any_of(pairs.placed, [&](const PlacedBody& one) { return one.body == id; });
  };
  std::vector<BodyPair> all;
  for (const BodyId a : world.bodies())
    for (const BodyId b : world.bodies())
      if (a < b && world.pair_margin(a, b) && in_categories(world.body(a), world.body(b), pairs) &&
          (pairs.placed.empty() || is_placed(a) || is_placed(b)))
        all.push_back({a, b});
  return all;
}

std::string fault_of(const World& world, const BodyPairs& pairs, double reach) {
  World moved = world;
  for (const PlacedBody& one : pairs.placed) moved.move(one.body, one.pose);
  std::optional<BodyPair> first, first_near;
  std::optional<Distance> least;
  BodyPair nearest;
  for (const BodyPair& pair : all_asked(moved, pairs)) {
    const Body &a = moved.body(pair.a), &b = moved.body(pair.b);
    if (!first && overlap(a.model, b.model, query_of(a, b))) first = pair;
    if (!first_near && within_distance(a.model, b.model, reach, query_of(a, b))) first_near = pair;
    const Distance apart = distance(a.model, b.model, query_of(a, b));
    if (least && !(apart.upper < least->upper)) continue;
    least = apart;
    nearest = pair;
  }
  const WorldQueries queries(world);
  if (queries.any_contact(pairs) != first) return "another contact";
  if (queries.any_within(reach, pairs) != first_near) return "another pair that is near";
  const auto found = queries.least_distance(pairs);
  if (found.has_value() != least.has_value()) return "a distance where there is no pair, or none";
  if (!least) return {};
  if (found->bodies != nearest) return "another nearest pair";
  if (found->upper != least->upper || found->lower > least->lower || found->on_a != least->on_a ||
      found->on_b != least->on_b)
    return "another least distance";
  const auto limited = queries.least_distance(pairs, least->upper);
  if (!limited || limited->bodies != nearest) return "nothing within the least distance";
  if (least->lower > 0 && queries.least_distance(pairs, 0.5 * least->lower)) return "something nearer than the least";
  return {};
}

TEST(BodyPairs, AreAnsweredAsAllPairsOneByOne) {
  for (const std::string family : {"convex", "whole", "any", "far"})
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      Random random(seed);
      World world;
      const std::size_t count = 4 + random.below(20);
      for (std::size_t i = 0; i < count; ++i) {
        Body body = test::random_body(family, random);
        // Some are so far apart that nothing meets.
        if (seed % 3 == 0) body.pose.offset = 4 * body.pose.offset;
        world.add(body);
      }
      const std::vector<BodyId> ids = world.bodies();
      world.set_rule({ids[0], ids[1], true, {}});
      std::vector<PlacedBody> placed;
      for (const BodyId id : ids)
        if (random.below(5) == 0) placed.push_back({id, test::random_place(family, random)});
      for (const BodyPairs& pairs :
           {BodyPairs{}, BodyPairs{1, 6}, BodyPairs{2, 2}, BodyPairs{.placed = placed}, BodyPairs{4, 3, placed}})
        ASSERT_EQ(fault_of(world, pairs, 0.25), "") << family << ", seed " << seed;
    }
}

/// An arm of three links, of which neighbours share a joint, and a post.
struct Robot {
  Robot() {
    const Capsule link({0, 0, 0}, {1, 0, 0}, 0.2);
    for (int i = 0; i < 3; ++i) {
      Body body{link, Pose::translation(i, 0, 0)};
      body.name = "link " + std::to_string(i);
      links.push_back(world.add(body));
    }
    Body pole{Box({0.25, 0.25, 2}), Pose::translation(1.5, 2, 0)};
    pole.type = BodyType::static_body;
    pole.category = 2;
    post = world.add(pole);
    world.set_rule({.a = links[0], .b = links[1], .excluded = true});
    world.set_rule({.a = links[1], .b = links[2], .excluded = true});
  }

  /// Link by link turned about z, in degrees.
  [[nodiscard]] std::vector<PlacedBody> at(double first, double second, double third) const {
    std::vector<PlacedBody> placed;
    Pose pose;
    for (const double turn : {first, second, third}) {
      pose = pose * Pose{rotation_about({0, 0, 1}, turn), {0, 0, 0}};
      placed.push_back({links[placed.size()], pose});
      pose = pose * Pose::translation(1, 0, 0);
    }
    return placed;
  }

  World world;
  std::vector<BodyId> links;
  BodyId post;
};

TEST(BodyPairs, AnyOverlapLooksAtAllWhateverTheyAre) {
  bool has_met = false, has_not = false;
  for (int round = 0; round < 60; ++round) {
    Random random(static_cast<std::uint64_t>(round) + 1);
    World world;
    for (int i = 0; i < 12; ++i) {
      const Vec3 at = test::vector_in(random, 0, 9);
      Body body{i % 2 == 0 ? Model(Sphere(0.7)) : Model(Box({0.5, 0.6, 0.7})), Pose::translation(at.x, at.y, at.z)};
      body.type = BodyType::static_body;  // two such never make a pair
      body.category = 0;
      body.margin = 9;
      world.add(body);
    }
    world.remove(world.bodies()[3]);
    bool expected = false;
    const std::vector<BodyId> ids = world.bodies();
    for (std::size_t i = 0; i < ids.size(); ++i)
      for (std::size_t j = i + 1; j < ids.size(); ++j) {
        const Body &a = world.body(ids[i]), &b = world.body(ids[j]);
        expected = expected || overlap(a.model, b.model, query_of(a, b));
      }
    EXPECT_EQ(any_overlap(world), expected) << round;
    EXPECT_EQ(WorldQueries(world).any_overlap(), expected) << round;
    (expected ? has_met : has_not) = true;
  }
  EXPECT_TRUE(has_met && has_not);
  EXPECT_FALSE(any_overlap(World()));
}

TEST(BodyPairs, TellWhetherARobotCouldBeSomewhere) {
  const Robot robot;
  const WorldQueries queries(robot.world);
  EXPECT_FALSE(queries.any_contact());
  const auto free = robot.at(90, 0, 0), hits = robot.at(0, 80, -20), folded = robot.at(0, 170, 170);
  EXPECT_FALSE(queries.any_contact({.placed = free}));
  EXPECT_EQ(queries.any_contact({.placed = hits}), (BodyPair{robot.links[2], robot.post}));
  EXPECT_EQ(queries.any_contact({.placed = folded}), (BodyPair{robot.links[0], robot.links[2]}));
  EXPECT_FALSE(queries.any_contact({1, 2, folded}));
  const auto least = queries.least_distance({1, 2, free});
  ASSERT_TRUE(least);
  EXPECT_EQ(least->bodies, (BodyPair{robot.links[1], robot.post}));
  EXPECT_NEAR(least->upper, 1.25 - 0.2, 1e-12);
  EXPECT_FALSE(queries.least_distance({1, 2, free}, 1));
  const std::array many{BodyPairs{.placed = free}, BodyPairs{.placed = hits}, BodyPairs{.placed = folded}};
  for (const int threads : {1, 3}) {
    const auto contacts = queries.any_contact_each(many, {.threads = threads});
    const auto distances = queries.least_distance_each(many, HUGE_VAL, {.threads = threads});
    for (std::size_t i = 0; i < many.size(); ++i) {
      EXPECT_EQ(contacts[i], queries.any_contact(many[i]));
      EXPECT_EQ(distances[i], queries.least_distance(many[i]));
    }
  }
}

TEST(BodyPairs, OfBadInputAreRefusedByName) {
  const Robot robot;
  const WorldQueries queries(robot.world);
  const std::vector<PlacedBody> twice{{robot.links[1], {}}, {robot.links[1], {}}}, unknown{{BodyId{9, 1, 1}, {}}};
  EXPECT_EQ(message_of([&] { (void)queries.any_contact({.placed = twice}); }),
            "body 1 (generation 1) (\"link 1\") is placed twice");
  EXPECT_NE(message_of([&] { (void)queries.any_contact({.placed = unknown}); }).find("body 9"), std::string::npos);
  const std::vector<PlacedBody> nowhere{{robot.links[1], Pose::translation(HUGE_VAL, 0, 0)}};
  EXPECT_EQ(message_of([&] { (void)queries.least_distance({.placed = nowhere}); }).substr(0, 32),
            "body 1 (generation 1) (\"link 1\")");
  EXPECT_EQ(message_of([&] { (void)queries.any_within(-1); }),
            "the greatest distance is -1; it has to be a length of 0 or more");
  EXPECT_EQ(message_of([&] { (void)queries.least_distance({}, -1); }),
            "the greatest distance is -1; it has to be a length of 0 or more");
  EXPECT_EQ(message_of([&] { (void)robot.world.pair_margin(robot.post, robot.post); }),
            "body 3 (generation 1) is asked about with itself");
  const std::array many{BodyPairs{}, BodyPairs{.placed = twice}};
  EXPECT_EQ(message_of([&] { (void)queries.any_contact_each(many); }),
            "pairs 1: body 1 (generation 1) (\"link 1\") is placed twice");
  World changed = robot.world;
  const WorldQueries old(changed);
  changed.move(robot.post, {});
  EXPECT_NE(message_of([&] { (void)old.any_contact(); }).find("update"), std::string::npos);
}

TEST(BodyPairs, KnowHowNearBodiesHaveToBe) {
  World world;
  Body body{Sphere(1)};
  body.margin = 0.25;
  const BodyId a = world.add(body), b = world.add(body), c = world.add(body);
  body.mask = 2;
  const BodyId nobody = world.add(body);
  world.set_rule({a, c, false, 3.0});
  EXPECT_EQ(world.pair_margin(a, b), 0.5);
  EXPECT_EQ(world.pair_margin(c, a), 3.0);
  EXPECT_EQ(world.pair_margin(a, nobody), std::nullopt);
  world.set_rule({b, a, true, {}});
  EXPECT_EQ(world.pair_margin(a, b), std::nullopt);
}

}  // namespace
}  // namespace toccata
