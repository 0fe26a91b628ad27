#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "support/error_message.hpp"
#include "toccata/motion/rigid_motion.hpp"
#include "toccata/toccata.hpp"

namespace toccata {
namespace {

const Pose far_left = Pose::translation(-10, 0, 0);

/// The first contact of the only pair that a step tells, where there is one.
std::optional<ShapeHit> only_first_contact(const WorldStep& step) {
  if (step.begin.size() + step.persist.size() != 1) return std::nullopt;
  const PairReport& pair = step.begin.empty() ? step.persist[0] : step.begin[0];
  return pair.details ? pair.details->first_contact : std::nullopt;
}

TEST(MoveAlong, ABulletDoesNotTunnelThroughAWall) {
  World world;
  const BodyId wall = world.add(Box({0.01, 5, 5}), Pose{}, BodyType::static_body);
  const BodyId bullet = world.add(Sphere(0.1), far_left);
  EXPECT_TRUE(world.step().begin.empty());
  world.move_along(bullet, RigidMotion::straight(far_left, {20, 0, 0}));
  EXPECT_EQ(world.body(bullet).pose, Pose::translation(10, 0, 0));
  const WorldStep& step = world.step();
  const auto hit = only_first_contact(step);
  ASSERT_TRUE(hit);
  EXPECT_FALSE(step.begin[0].in_contact);
  EXPECT_EQ(step.begin[0].a, wall);
  EXPECT_NEAR(hit->upper, (10 - 0.11) / 20, 1e-12);
  // It has passed: at the next step the pair is gone.
  const WorldStep& next = world.step();
  EXPECT_TRUE(next.begin.empty());
  EXPECT_TRUE(next.persist.empty());
  EXPECT_EQ(next.end.size(), 1U);
  EXPECT_TRUE(world.step().end.empty());
}

TEST(MoveAlong, ABodyThatIsMovedOnlyMeetsNothingOnTheWay) {
  World world;
  world.add(Box({0.01, 5, 5}), Pose{}, BodyType::static_body);
  const BodyId bullet = world.add(Sphere(0.1), far_left);
  world.move_along(bullet, RigidMotion::straight(far_left, {20, 0, 0}));
  world.move(bullet, Pose::translation(10, 0, 0));
  EXPECT_TRUE(world.step().begin.empty());
}

TEST(MoveAlong, TwoThatBothMoveMeetWhereTheyCross) {
  World world;
  const BodyId a = world.add(Sphere(0.5), far_left), b = world.add(Sphere(0.5), Pose::translation(10, 0, 0));
  world.move_along(std::vector{a, b}, std::vector{RigidMotion::straight(far_left, {20, 0, 0}),
                                                  RigidMotion::straight(Pose::translation(10, 0, 0), {-20, 0, 0})});
  const auto hit = only_first_contact(world.step());
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->upper, 19.0 / 40, 1e-12);
}

TEST(MoveAlong, ARodThatSpinsIsSeenWhereItsEndsDoNotGo) {
  World world;
  const BodyId rod = world.add(Capsule({-2, 0, 0}, {2, 0, 0}, 0.05), Pose{});
  world.add(Sphere(0.1, {0, 1.9, 0}), Pose{}, BodyType::static_body);
  world.step();
  world.move_along(rod, RigidMotion(Pose{}, {.turns = 0.5}));  // half a turn: it lies as before
  const auto hit = only_first_contact(world.step());
  ASSERT_TRUE(hit);
  EXPECT_GT(hit->lower, 0.4);
  EXPECT_LT(hit->upper, 0.5);
}

TEST(MoveAlong, WhatIsInContactAtTheEndIsToldBothWays) {
  World world;
  world.add(Box({1, 1, 1}), Pose{}, BodyType::static_body);
  const BodyId ball = world.add(Sphere(1), far_left);
  world.move_along(ball, RigidMotion::straight(far_left, {9, 0, 0}));
  const WorldStep& step = world.step();
  ASSERT_EQ(step.begin.size(), 1U);
  EXPECT_TRUE(step.begin[0].in_contact);
  EXPECT_NEAR(step.begin[0].details->first_contact->upper, 8.0 / 9, 1e-12);
}

TEST(MoveAlong, ATurnWithinTheLastDoublesOfTheTimeIsSeen) {
  World world;
  const BodyId ball = world.add(Sphere(0.1, {10, 0, 0}), Pose{});
  world.add(Sphere(0.1, {0, 10, 0}), Pose{}, BodyType::static_body);
  for (const double last : {1e-3, 1e-12, 0x1p-53}) {
    const std::vector<MotionKey> keys{{0, Pose{}}, {1 - last, Pose{}}, {1, Pose::rotation({0, 0, 1}, 170)}};
    world.move_along(ball, RigidMotion::through(keys));
    const auto hit = only_first_contact(world.step());
    ASSERT_TRUE(hit) << last;
    EXPECT_GE(hit->lower, 1 - last);
  }
}

TEST(MoveAlong, AFunctionThatIsFasterThanItsBoundIsAnError) {
  World world;
  const BodyId ball = world.add(Sphere(0.1), Pose{});
  const auto fast = [](double time) { return Pose::translation(10 * time, 0, 0); };
  EXPECT_THROW(world.move_along(ball, RigidMotion::of(fast, {.speed = 1})), Error);
  EXPECT_THROW((void)sweep(Sphere(0.1), RigidMotion::of(fast, {.speed = 1}), Sphere(1, {90, 0, 0}), Pose{}), Error);
  EXPECT_NO_THROW(world.move_along(ball, RigidMotion::of(fast, {.speed = 10})));
}

TEST(MoveAlong, WhatHasPassedIsToldAsItIsNow) {
  World world({.relation = true, .distance = true});
  world.add(Box({0.01, 5, 5}), Pose{}, BodyType::static_body);
  const BodyId bullet = world.add(Sphere(0.1), far_left);
  world.move_along(bullet, RigidMotion::straight(far_left, {20, 0, 0}));
  const WorldStep& step = world.step();
  ASSERT_EQ(step.begin.size(), 1U);
  EXPECT_EQ(step.begin[0].details->relation->kind, RelationKind::apart);
  EXPECT_NEAR(step.begin[0].details->distance->upper, 9.89, 1e-9);
}

TEST(MoveAlong, ErrorsChangeNothing) {
  World world;
  const BodyId ball = world.add(Sphere(1), far_left);
  EXPECT_THROW(world.move_along(std::vector{ball}, std::vector<RigidMotion>{}), Error);
  EXPECT_THROW(world.move_along(BodyId{}, RigidMotion(far_left)), Error);
  const auto lost = RigidMotion::of([](double time) { return Pose::translation(1 / (1 - time), 0, 0); }, {.speed = 1});
  const std::string message = test::message_of([&] { world.move_along(ball, lost); });
  EXPECT_TRUE(message.starts_with("body 0")) << message;
  EXPECT_EQ(world.body(ball).pose, far_left);
}

struct Crowd {
  std::vector<Body> bodies;
  std::vector<RigidMotion> motions;
};

/// Balls, boxes and rods at random places, each with a way of its own.
Crowd crowd_on_the_way(unsigned seed, std::size_t count) {
  std::mt19937 random(seed);
  const auto between = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
  };
  const auto vector = [&](double size) {
    return Vec3{between(-size, size), between(-size, size), between(-size, size)};
  };
  Crowd crowd;
  for (std::size_t i = 0; i < count; ++i) {
    const Pose start{rotation_about({1, 0.5, between(-1, 1)}, between(0, 360)), vector(3)};
    const Model shape = i % 3 == 0   ? Model(Sphere(0.3))
                        : i % 3 == 1 ? Model(Box({0.3, 0.2, 0.4}))
                                     : Model(Capsule({-1, 0, 0}, {1, 0, 0}, 0.05));
    crowd.bodies.push_back({.model = shape, .pose = start});
    crowd.motions.push_back(RigidMotion(start, {start.offset, {between(-1, 1), 1, 0.3}, between(-1, 1), vector(5)}));
  }
  return crowd;
}

TEST(MoveAlong, EveryPairThatMeetsOnTheWayIsToldAndNoOther) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const Crowd crowd = crowd_on_the_way(seed, 40);
    World world;
    const std::vector<BodyId> ids = world.add(crowd.bodies);
    world.move_along(ids, crowd.motions);
    world.step();
    std::size_t met = 0;
    for (std::size_t a = 0; a < ids.size(); ++a)
      for (std::size_t b = a + 1; b < ids.size(); ++b) {
        const std::optional<ShapeHit> hit =
            sweep(crowd.bodies[a].model, crowd.motions[a], crowd.bodies[b].model, crowd.motions[b]);
        const auto told = std::find_if(world.pairs().begin(), world.pairs().end(),
                                       [&](const PairReport& pair) { return pair.a == ids[a] && pair.b == ids[b]; });
        ASSERT_EQ(told != world.pairs().end(), hit.has_value()) << seed << ": " << a << ", " << b;
        if (!hit) continue;
        ++met;
        EXPECT_EQ(*told->details->first_contact, hit);
      }
    EXPECT_GT(met, 5U);
  }
}

TEST(MoveAlong, ThreadsAndCopiesGiveTheSame) {
  const Crowd crowd = crowd_on_the_way(7, 40);
  World one({.threads = 1}), several({.threads = 3});
  one.move_along(one.add(crowd.bodies), crowd.motions);
  several.move_along(several.add(crowd.bodies), crowd.motions);
  World copy = one;
  for (World* world : {&one, &several, &copy}) world->step();
  ASSERT_EQ(one.pairs().size(), several.pairs().size());
  for (std::size_t i = 0; i < one.pairs().size(); ++i) {
    EXPECT_EQ(one.pairs()[i].details->first_contact, several.pairs()[i].details->first_contact);
    EXPECT_EQ(one.pairs()[i].details->first_contact, copy.pairs()[i].details->first_contact);
  }
}

}  // namespace
}  // namespace toccata
