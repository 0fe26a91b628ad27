#include "toccata/world/world.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <thread>
#include <unordered_set>

#include <gtest/gtest.h>

#include "query/meshes/posed_mesh.hpp"
#include "support/mesh_soups.hpp"
#include "support/simd_levels.hpp"
#include "toccata/core/error.hpp"
#include "toccata/math/pose.hpp"
#include "world/random_bodies.hpp"

namespace toccata {
namespace {

Body ball_at(double x, double radius = 1) { return {Sphere(radius), Pose::translation(x, 0, 0)}; }

using Names = std::vector<std::pair<Index, Index>>;
Names names_of(const std::vector<PairReport>& reports) {
  Names names;
  for (const PairReport& report : reports) names.emplace_back(report.a.index, report.b.index);
  return names;
}

/// What is wrong with a call; empty when it throws no Error.
template <class Call>
std::string complaint_of(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

/// Its pose is composed with a turn frame after frame, as programs do, and not made from an angle each time.
TEST(World, TakesAPoseComposedForTenThousandFrames) {
  const Pose turn{rotation_about({1, 2, 3}, 0.7), {}};
  World world({.distance = true});
  const BodyId turned = world.add({Rounded(Box({1, 1, 1}), 0.25)});
  world.add(ball_at(0, 1.5));
  Pose pose;
  std::size_t told = 0;
  for (int frame = 0; frame < 10000; ++frame) {
    pose = turn * pose;
    world.move(turned, pose);
    told += world.step().begin.size() + world.last_step().persist.size();
  }
  EXPECT_EQ(told, 10000U);
  EXPECT_NE(pose.linear, nearest_rotation(pose.linear)) << "it has drifted";
}

TEST(World, TellsWhatBeginsStaysAndEnds) {
  World world;
  const std::vector<BodyId> ids = world.add(std::array{ball_at(0), ball_at(2), ball_at(5)});
  const WorldStep& step = world.step();
  EXPECT_EQ(names_of(step.begin), (Names{{0, 1}}));  // they touch
  EXPECT_TRUE(step.begin[0].in_contact);
  EXPECT_EQ(step.begin[0].details, nullptr);
  world.move(ids[2], Pose::translation(4, 0, 0));
  world.step();
  EXPECT_EQ(names_of(step.begin), (Names{{1, 2}}));
  EXPECT_EQ(names_of(step.persist), (Names{{0, 1}}));
  world.remove(ids[0]);
  world.step();
  EXPECT_EQ(names_of(step.persist), (Names{{1, 2}}));
  EXPECT_EQ(step.end.size(), 1U);
  EXPECT_EQ(step.end[0].a, ids[0]);
  EXPECT_EQ(names_of({world.pairs().begin(), world.pairs().end()}), (Names{{1, 2}}));
}

TEST(World, TakesShapesAtTheirPlacesAndListsOfBodies) {
  World world;
  const BodyId ball = world.add(Sphere(1), Pose::translation(1, 0, 0));
  const std::vector<BodyId> two =
      world.add({ball_at(0), {Box({1, 1, 1}), Pose::translation(9, 0, 0), BodyType::static_body}});
  ASSERT_EQ(two.size(), 2U);
  EXPECT_EQ(names_of(world.step().begin), (Names{{0, 1}}));
  EXPECT_EQ(world.body(world.add(Box({1, 1, 1}), {}, BodyType::static_body)).type, BodyType::static_body);
  const std::unordered_set<BodyId> set{ball, two[0], two[1], ball};
  EXPECT_EQ(set.size(), 3U);
}

TEST(World, BodiesMayBeRemovedWhileThePairsOfAStepAreGoneThrough) {
  World world({.distance = true});
  for (int i = 0; i < 20; ++i) world.add(ball_at(i));
  const WorldStep& step = world.step();
  const std::size_t count = step.begin.size();
  std::size_t seen = 0;
  for (const PairReport& pair : step.begin) {
    ++seen;
    EXPECT_TRUE(pair.details->distance.has_value());
    if (world.contains(pair.a)) world.remove(pair.a);
    world.add(ball_at(100.0 + static_cast<double>(seen)));
  }
  EXPECT_EQ(seen, count);
  EXPECT_EQ(world.pairs().size(), count);
}

TEST(World, DecidesByTheShapesAndNotTheirBoxes) {
  World world;
  world.add(std::array{ball_at(0), Body{Sphere(1), Pose::translation(1.9, 1.9, 1.9)}});
  EXPECT_TRUE(world.step().begin.empty());
  EXPECT_EQ(world.last_step().candidates, 1U);
}

TEST(World, MarginsAreOfTheExactDistance) {
  World world({.distance = true});
  Body near = ball_at(2.5);
  near.margin = 0.25;
  const std::vector<BodyId> ids = world.add(std::array{ball_at(0), near});
  EXPECT_TRUE(world.step().begin.empty());
  Body other = world.body(ids[0]);
  other.margin = 0.25;
  world.replace(ids[0], other);
  ASSERT_EQ(world.step().begin.size(), 1U);  // exactly as far as both margins together
  EXPECT_FALSE(world.pairs()[0].in_contact);
  EXPECT_LE(world.pairs()[0].details->distance->lower, 0.5);
  EXPECT_GE(world.pairs()[0].details->distance->upper, 0.5);
  world.move(ids[1], Pose::translation(std::nextafter(2.5, 3), 0, 0));
  EXPECT_EQ(world.step().end.size(), 1U);
}

TEST(World, RulesOfAPairComeBeforeMargins) {
  World world;
  const std::vector<BodyId> ids = world.add(std::array{ball_at(0), ball_at(3), ball_at(6)});
  EXPECT_TRUE(world.step().begin.empty());
  world.set_rule({ids[1], ids[0], false, 1.0});
  EXPECT_EQ(names_of(world.step().begin), (Names{{0, 1}}));
  world.set_rule({ids[0], ids[1], true, {}});
  EXPECT_EQ(names_of(world.step().end), (Names{{0, 1}}));
  world.set_rule({ids[0], ids[1], false, {}});
  world.move(ids[1], Pose::translation(1, 0, 0));
  EXPECT_EQ(names_of(world.step().begin), (Names{{0, 1}}));
  world.set_rule({ids[2], ids[0], false, HUGE_VAL});
  EXPECT_EQ(names_of(world.step().begin), (Names{{0, 2}}));
  world.remove(ids[2]);
  EXPECT_EQ(world.step().end.size(), 1U);
  EXPECT_EQ(world.add(ball_at(100)).index, 2U);  // the rule was of another body
  EXPECT_TRUE(world.step().begin.empty());
}

TEST(World, GroupsAndMotionsLeavePairsOut) {
  for (const bool kinematic_pairs : {true, false}) {
    World world({.kinematic_pairs = kinematic_pairs});
    std::vector<Body> bodies(5, ball_at(0));
    bodies[0].type = bodies[1].type = BodyType::static_body;
    bodies[2].type = BodyType::kinematic_body;
    bodies[4].category = 2;
    bodies[4].mask = 2;
    world.add(bodies);
    const Names driven{{0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}, moving{{0, 3}, {1, 3}, {2, 3}};
    EXPECT_EQ(names_of(world.step().begin), kinematic_pairs ? driven : moving);
  }
}

TEST(World, AnIdOfARemovedBodyIsAnError) {
  World world;
  Body arm = ball_at(0);
  arm.name = "arm";
  const BodyId first = world.add(arm);
  world.remove(first);
  world.step();
  const BodyId second = world.add(ball_at(7));
  EXPECT_EQ(second.index, first.index);
  EXPECT_NE(second, first);
  EXPECT_FALSE(world.contains(first));
  EXPECT_EQ(world.body_at(first.index), second);
  const std::string gone = "body 0 (generation 1) was removed: its id names no body any more";
  EXPECT_EQ(complaint_of([&] { world.move(first, {}); }), gone);
  EXPECT_EQ(complaint_of([&] { world.remove(first); }), gone);
  EXPECT_EQ(complaint_of([&] { (void)world.body(first); }), gone);
  EXPECT_EQ(complaint_of([&] { world.set_rule({second, first, true, {}}); }), gone);
  EXPECT_EQ(complaint_of([&] {
              (void)world.box({9, 3});
            }),
            "body 9 (generation 3) is not in this World: its id was not given out by it");
  EXPECT_EQ(world.box(second).lower.x, 6);
  EXPECT_FALSE(world.contains(BodyId{}));
  EXPECT_EQ(complaint_of([&] { (void)world.body(BodyId{}); }),
            "body 0 (generation 0) is not in this World: its id was not given out by it");
}

TEST(World, AnIdOfAnotherWorldIsRefusedAndOneOfACopyIsKnown) {
  World one, other;
  const BodyId first = one.add(ball_at(0));
  const BodyId second = other.add(ball_at(0));
  EXPECT_NE(first, second);
  EXPECT_FALSE(other.contains(first));
  EXPECT_EQ(complaint_of([&] { (void)other.body(first); }),
            "body 0 (generation 1) is of another World: ask the World that gave out its id, or a copy of it");
  EXPECT_EQ(complaint_of([&] { other.remove(first); }),
            "body 0 (generation 1) is of another World: ask the World that gave out its id, or a copy of it");
  const World copy = one;
  EXPECT_TRUE(copy.contains(first));
}

/// Whatever is asked of it, a refused id leaves the World as a copy of before.
TEST(World, AnIdOfARemovedBodyChangesNothing) {
  World world({.distance = true});
  const std::vector<BodyId> ids = world.add(std::array{ball_at(0), ball_at(1), ball_at(9), ball_at(2)});
  world.set_rule({ids[0], ids[3], true, {}});
  world.step();
  world.remove(ids[2]);
  const BodyId gone = ids[2];
  const World before = world;
  const std::array named{ids[0], gone};
  const std::array<std::function<void()>, 6> calls{
      [&] {
        world.move(named, std::array{Pose::translation(50, 0, 0), Pose::translation(60, 0, 0)});
      },
      [&] { world.remove(named); },
      [&] {
        world.replace(named, std::array{ball_at(7), ball_at(8)});
      },
      [&] {
        world.set_rules(std::array{PairRule{ids[0], ids[1], true, {}}, PairRule{ids[1], gone, true, {}}});
      },
      [&] { (void)world.body(gone); },
      [&] { (void)world.box(gone); }};
  for (const auto& call : calls) {
    EXPECT_NE(complaint_of(call).find("was removed"), std::string::npos);
    EXPECT_EQ(world.bodies(), before.bodies());
    EXPECT_EQ(world.revision(), before.revision());
    for (const BodyId id : before.bodies()) {
      EXPECT_EQ(world.body(id).pose, before.body(id).pose);
      EXPECT_EQ(world.box(id), before.box(id));
    }
    World now = world, then = before;
    const WorldStep &found = now.step(), &expected = then.step();
    EXPECT_EQ(names_of(found.persist), (Names{{0, 1}, {1, 3}}));
    EXPECT_EQ(names_of(found.persist), names_of(expected.persist));
    EXPECT_EQ(names_of(found.end), names_of(expected.end));
    EXPECT_EQ(found.begin.size() + expected.begin.size(), 0U);
    EXPECT_EQ(found.asked, expected.asked);
  }
}

class BadInput : public testing::Test {
 protected:
  BadInput() {
    std::vector<Body> bodies{ball_at(0), ball_at(1), ball_at(9)};
    bodies[1].name = "arm";
    ids_ = world_.add(bodies);
    world_.step();
  }

  /// The call throws this, and the World is as it was.
  template <class Call>
  void expect_refused(const Call& call, const std::string& message) {
    const std::uint64_t revision = world_.revision();
    EXPECT_EQ(complaint_of(call), message);
    EXPECT_EQ(world_.revision(), revision);
    EXPECT_EQ(world_.bodies(), ids_);
    for (Index i = 0; i < 3; ++i) {
      EXPECT_EQ(world_.body(ids_[i]).pose, Pose::translation(i == 2 ? 9 : i, 0, 0));
      EXPECT_EQ(world_.body(ids_[i]).margin, 0);
    }
    const WorldStep& step = world_.step();
    EXPECT_EQ(names_of(step.persist), (Names{{0, 1}}));
    EXPECT_TRUE(step.begin.empty() && step.end.empty());
    EXPECT_EQ(step.asked, 0U);
  }

  World world_;
  std::vector<BodyId> ids_;
};

TEST_F(BadInput, OfAddedBodiesChangesNothing) {
  std::vector<Body> bodies(3, ball_at(1));
  bodies[1].margin = -1;
  expect_refused([&] { world_.add(bodies); },
                 "body 1 of the 3 to add: its margin is -1; it has to be a length of 0 or more");
  bodies[1].margin = std::nan("");
  expect_refused([&] { world_.add(bodies); },
                 "body 1 of the 3 to add: its margin is nan; it has to be a length of 0 or more");
  bodies[1].margin = 0;
  bodies[2].name = "leg";
  bodies[2].pose.offset.y = HUGE_VAL;
  const std::string offset = complaint_of([&] { world_.add(bodies); });
  EXPECT_EQ(offset.substr(0, 42), "body 2 of the 3 to add (\"leg\"): the sphere") << offset;
  expect_refused([&] { world_.add(bodies); }, offset);
  bodies[2].pose = {};
  bodies[0].pose.linear[0][0] = 2;
  const std::string deformed = complaint_of([&] { world_.add(bodies); });
  EXPECT_NE(deformed.find("body 0 of the 3 to add: "), std::string::npos) << deformed;
  EXPECT_NE(deformed.find("ellipsoid"), std::string::npos) << deformed;
  expect_refused([&] { world_.add(bodies); }, deformed);
}

TEST_F(BadInput, OfMovedBodiesChangesNothing) {
  const std::vector<Pose> poses{Pose::translation(100, 0, 0), Pose::translation(std::nan(""), 0, 0)};
  const std::string message = complaint_of([&] { world_.move(std::span(ids_).first(2), poses); });
  EXPECT_EQ(message.substr(0, 32), "body 1 (generation 1) (\"arm\"): t") << message;
  expect_refused([&] { world_.move(std::span(ids_).first(2), poses); }, message);
  expect_refused([&] { world_.move(ids_, poses); }, "3 bodies are named and 2 poses given; give one for each");
  const std::vector<BodyId> others{ids_[0], {1, 2}};
  expect_refused([&] { world_.move(others, std::vector<Pose>(2)); },
                 "body 1 (generation 2) is not in this World: its id was not given out by it");
  Body body = world_.body(ids_[1]);
  body.margin = -0.5;
  expect_refused([&] { world_.replace(ids_[1], body); },
                 "body 1 (generation 1) (\"arm\"): its margin is -0.5; it has to be a length of 0 or more");
}

TEST_F(BadInput, OfRemovedBodiesAndRulesChangesNothing) {
  expect_refused(
      [&] {
        world_.remove(std::vector{ids_[2], ids_[1], ids_[1]});
      },
      "body 1 (generation 1) (\"arm\") is to be removed twice");
  expect_refused(
      [&] {
        world_.set_rules(std::array{PairRule{ids_[0], ids_[1], true, {}}, PairRule{ids_[1], ids_[1]}});
      },
      "a rule is given for body 1 (generation 1) (\"arm\") with itself");
  expect_refused(
      [&] {
        world_.set_rule({ids_[0], ids_[1], false, -1.0});
      },
      "the rule for body 0 (generation 1) and body 1 (generation 1) (\"arm\"): its margin is -1; it has to "
      "be a length of 0 or more");
}

TEST(World, AnOpenMeshIsNoSolid) {
  World world;
  Random random(1);
  Body sheet{Model(test::random_soup(random, 3, 1, 0))};
  world.add(sheet);
  sheet.solid = Solid::all;
  const std::string message = complaint_of([&] { world.add(sheet); });
  EXPECT_EQ(message.substr(0, 40), "body 0 of the 1 to add: the mesh is open") << message;
  EXPECT_EQ(world.size(), 1U);
}

TEST(World, WhatDidNotMoveIsNotAskedAgain) {
  World world({.relation = true});
  const std::vector<BodyId> ids = world.add(std::array{ball_at(0), ball_at(1), ball_at(2), ball_at(3)});
  EXPECT_EQ(world.step().asked, 5U);
  const auto details = world.pairs()[0].details;
  EXPECT_EQ(world.step().asked, 0U);
  EXPECT_EQ(world.step().persist.size(), 5U);
  world.move(ids[3], Pose::translation(3.5, 0, 0));
  EXPECT_EQ(world.step().asked, 1U);
  EXPECT_EQ(world.step().candidates, 4U);
  EXPECT_EQ(world.pairs()[0].details, details);  // the very same
  world.move(
      ids, std::vector<Pose>{{}, Pose::translation(1, 0, 0), Pose::translation(2, 0, 0), Pose::translation(3.5, 0, 0)});
  EXPECT_EQ(world.step().asked, 0U);
}

TEST(World, HalfSpacesAndInfiniteMarginsAreBodiesLikeOthers) {
  World world;
  Body ground{HalfSpace({0, 0, 0}, {0, 0, 1})};
  ground.type = BodyType::static_body;
  Body watcher{Point({1e9, 0, 1e9})};
  watcher.margin = HUGE_VAL;
  world.add(std::array{ground, Body{Sphere(1), Pose::translation(5e8, 0, 1)},
                       Body{Sphere(1), Pose::translation(5e8, 9, 1.5)}, watcher});
  const WorldStep& step = world.step();
  EXPECT_EQ(names_of(step.begin), (Names{{0, 1}, {0, 3}, {1, 3}, {2, 3}}));
  EXPECT_TRUE(step.begin[0].in_contact);
  EXPECT_FALSE(step.begin[1].in_contact);
}

TEST(World, MarginsWhoseSumOverflowsReachEverything) {
  World world;
  std::vector<Body> bodies{{Point({-1.7e308, 0, 0})}, {Point({1.7e308, 0, 0})}};
  for (Body& body : bodies) body.margin = 1e308;
  world.add(bodies);
  EXPECT_EQ(world.step().begin.size(), 1U);
}

// A can that is put on a table, pushed over the edge, laid down and lifted.
TEST(World, TellsThePointsOnWhichACanStandsAndLies) {
  World world({.manifold = true});
  Body table{Box({2, 2, 0.5}), Pose::translation(0, 0, -0.5)};
  table.type = BodyType::static_body;
  const BodyId can = world.add(std::array{table, Body{Cylinder(0.5, 1), Pose::translation(0, 0, 1)}})[1];
  const auto points_at = [&](const Pose& pose, double height) {
    world.move(can, pose);
    world.step();
    if (world.pairs().empty()) return 0;
    const Manifold& m = world.pairs()[0].details->manifold.value();
    EXPECT_EQ(m, manifold(Box({2, 2, 0.5}), Cylinder(0.5, 1), {table.pose, pose}));
    EXPECT_NEAR(m.normal.z, 1, 1e-15);
    for (std::size_t i = 0; i < static_cast<std::size_t>(m.count); ++i)
      EXPECT_NEAR(m.points[i].position.z, height, 1e-14);
    return m.count;
  };
  EXPECT_EQ(points_at(Pose::translation(0, 0, 1), 0), 4);
  EXPECT_EQ(points_at(Pose::translation(2.25, 0, 0.875), -0.0625), 4);
  EXPECT_EQ(points_at({rotation_about({1, 0, 0}, 90), {0, 0, 0.5}}, 0), 2);
  EXPECT_EQ(points_at({rotation_about({1, 0, 0}, 180), {0, 1.75, 0.96875}}, -0.015625), 4);
  EXPECT_EQ(points_at(Pose::translation(0, 0, 1.0009765625), 0), 0);
}

TEST(World, BitsAreTheSameAtEverySimdLevel) {
  std::vector<std::vector<PairReport>> found;
  test::at_every_simd_level([&](SimdLevel) {
    Random random(5);
    World world({.distance = true, .manifold = true, .threads = 2});
    for (int i = 0; i < 60; ++i) world.add(test::random_body("any", random));
    world.step();
    found.emplace_back(world.pairs().begin(), world.pairs().end());
  });
  for (const auto& one : found) {
    ASSERT_EQ(names_of(one), names_of(found[0]));
    for (std::size_t i = 0; i < one.size(); ++i) {
      EXPECT_EQ(one[i].details->distance, found[0][i].details->distance);
      EXPECT_EQ(one[i].details->manifold, found[0][i].details->manifold);
    }
  }
}

TEST(World, BoxesOfMeshesAreThoseOfThePosedMeshes) {
  Random random(7);
  const Model closed(test::box_between({-1, 0, 0.5}, {2, 3, 1})), open(test::random_soup(random, 20, 0.5, 8));
  const Model huge(test::box_between({-1e305, 0, 0}, {1e305, 1, 1}));
  World world;
  for (int i = 0; i < 60; ++i)
    for (const Model& model : {closed, open, huge}) {
      Pose pose = Pose::rotation({random.between(-1, 1), random.between(-1, 1), 1}, random.between(-180, 180));
      pose.offset = {random.between(-9, 9), 1e-300, random.between(-1e9, 1e9)};
      if (i % 4 == 3) pose.linear[0].x *= 2;  // no rotation
      const BodyId id = world.add({model, pose});
      EXPECT_EQ(world.boxes()[id.index], PosedMesh(model, pose).box()) << "body " << id.index;
    }
  EXPECT_NE(complaint_of([&] { world.add({.model = open, .solid = Solid::all}); }), "");
}

TEST(World, IsReadByManyThreadsAtOnce) {
  World world;
  Random random(2);
  for (int i = 0; i < 50; ++i) world.add(test::random_body("convex", random));
  world.step();
  std::array<std::size_t, 4> pairs{};
  {
    std::vector<std::jthread> threads;
    for (std::size_t& count : pairs)
      threads.emplace_back([&] {
        for (const BodyId id : world.bodies()) count += contains(world.box(id), world.boxes()[id.index]) ? 1 : 0;
        World copy = world;
        copy.step();
        count += copy.pairs().size();
      });
  }
  for (const std::size_t count : pairs) EXPECT_EQ(count, 50 + world.pairs().size());
}

}  // namespace
}  // namespace toccata
