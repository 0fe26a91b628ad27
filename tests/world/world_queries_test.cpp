#include "toccata/world/world_queries.hpp"

#include <gtest/gtest.h>

#include <string>
#include <thread>

#include "support/error_message.hpp"
#include "world/world_queries_checks.hpp"

namespace toccata {
namespace {

using test::message_of;

TEST(WorldQueries, AnswerAsEveryBodyByItselfThroughALife) {
  for (const std::string& family : test::crowd_families())
    for (const bool convex : {true, false}) {
      Random random(23);
      test::QuestionedWorld world(family, convex);
      for (int frame = 0; frame < 12; ++frame) {
        world.live(random);
        ASSERT_EQ(world.fault(random), "") << family << ", frame " << frame;
      }
      EXPECT_GT(world.world().size(), 5U);
    }
}

TEST(WorldQueries, AnswerAsEveryBodyByItselfAmongThousands) {
  for (const std::string family : {"near", "lattice", "far"})
    for (const bool convex : {true, false}) {
      Random random(41);
      test::QuestionedWorld world(family, convex, 15);
      world.add(3000, random);
      for (int frame = 0; frame < 3; ++frame) {
        world.live(random);
        for (int question = 0; question < 2; ++question)
          ASSERT_EQ(world.fault(random), "") << family << ", frame " << frame << ", question " << question;
      }
      EXPECT_GT(world.world().size(), 1500U);
    }
}

/// Three balls in a row, of which the one in the middle is in another category.
World row_of_balls() {
  World world;
  for (const double x : {0.0, 3.0, 6.0}) {
    Body ball{Sphere(1), Pose::translation(x, 0, 0)};
    ball.category = x == 3 ? 2 : 1;
    ball.mask = x == 0 ? 4 : ~std::uint64_t{0};
    ball.name = "ball at " + std::to_string(static_cast<int>(x));
    world.add(ball);
  }
  return world;
}

TEST(WorldQueries, BatchesAnswerAsSingleQuestions) {
  const World world = row_of_balls();
  const WorldQueries queries(world);
  const std::vector<Ray> rays{{{-5, 0, 0}, {20, 0, 0}}, {{3, 0, 5}, {0, 0, -20}}, {{3, 0, 5}, {0, 0, 1}}};
  std::vector<SceneInstance> shapes;
  std::vector<MovingShape> moving;
  for (const Ray& ray : rays) {
    shapes.push_back({Model(Point(ray.origin)), {}});
    moving.push_back({shapes.back(), ray.motion});
  }
  const BatchOptions options{.threads = 2};
  const auto hits = queries.cast_ray_each(rays, {}, options);
  const auto casts = queries.cast_shape_each(moving, {}, options);
  const auto nearest = queries.nearest_each(shapes, 4.5, {}, options);
  const auto within = queries.within_each(shapes, 4.5, {}, options);
  const auto met = queries.overlapping_each(shapes, {}, options);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    EXPECT_EQ(hits[i], queries.cast_ray(rays[i]));
    EXPECT_EQ(casts[i], queries.cast_shape(moving[i]));
    EXPECT_EQ(nearest[i], queries.nearest(shapes[i], 4.5));
    EXPECT_EQ(within[i], queries.within(shapes[i], 4.5));
    EXPECT_EQ(met[i], queries.overlapping(shapes[i]));
  }
}

TEST(WorldQueries, FiltersSayWhoIsAsked) {
  const World world = row_of_balls();
  const WorldQueries queries(world);
  const Ray ray{{-5, 0, 0}, {20, 0, 0}};
  const auto first = [&](const BodyFilter& filter) { return queries.cast_ray(ray, filter)->body.index; };
  EXPECT_EQ(first({}), 0U);
  EXPECT_EQ(first({.mask = 2}), 1U);
  EXPECT_EQ(first({.category = 1}), 1U);  // the first has a mask without that category
  EXPECT_EQ(first({.category = 4}), 0U);
  EXPECT_EQ(first({.accepts = [](BodyId id) { return id.index > 1; }}), 2U);
  EXPECT_EQ(queries.cast_ray(ray, {.mask = 8}), std::nullopt);
  EXPECT_EQ(queries.cast_ray_through(ray).size(), 3U);
}

TEST(WorldQueries, AreAskedFromTwoThreadsAtOnce) {
  const World world = row_of_balls();
  const WorldQueries queries(world);
  const SceneInstance point{Model(Point({1.5, 0, 0})), {}};
  std::vector<std::optional<BodyAnswer<Distance>>> found(2);
  {
    std::vector<std::jthread> threads;
    for (auto& answer : found)
      threads.emplace_back([&] {
        for (int i = 0; i < 100; ++i) answer = queries.nearest(point);
      });
  }
  EXPECT_EQ(found[0]->body.index, 0U);
  EXPECT_EQ(found[0], found[1]);
}

TEST(WorldQueries, AreNotAskedAboutBodiesThatHaveChanged) {
  World world = row_of_balls();
  WorldQueries queries(world);
  const Ray ray{{-5, 0, 0}, {20, 0, 0}};
  world.step();
  EXPECT_EQ(queries.cast_ray(ray)->body.index, 0U);
  world.remove(*world.body_at(0));
  EXPECT_NE(message_of([&] { static_cast<void>(queries.cast_ray(ray)); }).find("call update()"), std::string::npos);
  queries.update();
  EXPECT_EQ(queries.cast_ray(ray)->body.index, 1U);
}

TEST(WorldQueries, AreNotAskedAboutASnapshotThatHasTakenThePlaceOfTheirWorld) {
  World world = row_of_balls();
  const World snapshot = world;
  world.add(Body{Sphere(1), Pose::translation(9, 0, 0)});
  WorldQueries queries(world);
  world = snapshot;
  world.add(Body{Sphere(1), Pose::translation(-9, 0, 0)});  // as many changes as the other had
  const SceneInstance there{Model(Point({-9, 0, 0})), {}};
  EXPECT_NE(message_of([&] { static_cast<void>(queries.overlapping(there)); }).find("call update()"),
            std::string::npos);
  queries.update();
  EXPECT_EQ(queries.overlapping(there).size(), 1U);
}

TEST(WorldQueries, ErrorsNameTheBody) {
  World world = row_of_balls();
  const Model ground(HalfSpace({0, 0, -9}, {0, 0, 1}));
  Body rock{ground};
  rock.name = "rock";
  world.add(rock);
  const WorldQueries queries(world);
  const MovingShape moving{{ground, Pose::translation(0, 0, -20)}, {0, 0, 5}};
  EXPECT_NE(message_of([&] { static_cast<void>(queries.cast_shape(moving)); }).find("body 3 (generation 1) (\"rock\")"),
            std::string::npos);
}

}  // namespace
}  // namespace toccata
