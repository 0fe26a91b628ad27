#include "toccata/query/scene_index.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "query/scene_index_checks.hpp"
#include "support/error_message.hpp"

namespace toccata {
namespace {

using test::message_of;

TEST(SceneIndex, AnswersAsEveryObjectByItself) {
  for (const std::string& family : test::crowd_families())
    for (const bool convex : {true, false}) {
      Random random(17);
      const test::QuestionedCrowd crowd(family, 30, convex, random);
      for (int i = 0; i < 15; ++i)
        ASSERT_EQ(test::crowd_fault(crowd, convex, random), "") << family << ", question " << i;
    }
}

TEST(SceneIndex, BatchesAnswerAsSingleQuestions) {
  Random random(18);
  const test::QuestionedCrowd crowd("near", 40, true, random);
  std::vector<Ray> rays;
  std::vector<SceneInstance> shapes;
  std::vector<MovingShape> moving;
  for (int i = 0; i < 60; ++i) {
    shapes.push_back(test::posed_in_crowd("near", test::convex_in_crowd(random), 6, random));
    rays.push_back({shapes.back().pose.offset, test::way_in_crowd("near", 9, random)});
    moving.push_back({shapes.back(), rays.back().motion});
  }
  const SceneIndex& index = crowd.index;
  for (const int threads : {1, 3}) {
    const BatchOptions options{.threads = threads};
    const auto hits = index.cast_ray_each(rays, {}, options);
    const auto casts = index.cast_shape_each(moving, {}, options);
    const auto met = index.overlapping_each(shapes, {}, options);
    const auto nearest = index.nearest_each(shapes, HUGE_VAL, {}, options);
    const auto within = index.within_each(shapes, 0.5, {}, options);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      ASSERT_EQ(hits[i], index.cast_ray(rays[i]));
      ASSERT_EQ(casts[i], index.cast_shape(moving[i]));
      ASSERT_EQ(met[i], index.overlapping(shapes[i]));
      ASSERT_EQ(nearest[i], index.nearest(shapes[i]));
      ASSERT_EQ(within[i], index.within(shapes[i], 0.5));
    }
  }
}

TEST(SceneIndex, IsAskedFromTwoThreadsAtOnce) {
  Random random(19);
  const test::QuestionedCrowd crowd("near", 30, false, random);
  const SceneInstance shape = test::posed_in_crowd("near", test::convex_in_crowd(random), 4, random);
  const std::vector<Index> expected = crowd.index.within(shape, 2);
  std::vector<std::vector<Index>> found(2);
  {
    std::vector<std::jthread> threads;
    for (std::vector<Index>& answer : found)
      threads.emplace_back([&] {
        for (int i = 0; i < 50; ++i) answer = crowd.index.within(shape, 2);
      });
  }
  EXPECT_EQ(found[0], expected);
  EXPECT_EQ(found[1], expected);
}

TEST(SceneIndex, OfEquallyNearOnesTheFirstIsNamed) {
  const Model ball(Sphere(1));
  const std::vector<SceneInstance> objects{{ball, Pose::translation(5, 0, 0)},
                                           {ball, Pose::translation(3, 0, 0)},
                                           {ball, Pose::translation(-3, 0, 0)},
                                           {ball, Pose::translation(0, 3, 0)}};
  const SceneIndex index(objects);
  EXPECT_EQ(index.nearest({Model(Point{})})->object, 1U);
  EXPECT_EQ(index.nearest({Model(Point{})}, 2, [](Index i) { return i != 1; })->object, 2U);
  EXPECT_EQ(index.within({Model(Point{})}, 2), (std::vector<Index>{1, 2, 3}));
  EXPECT_EQ(index.nearest({Model(Point{})}, std::nextafter(2, 0)), std::nullopt);
  EXPECT_EQ(index.nearest({Model(Sphere(9))})->object, 0U);
  EXPECT_EQ(index.cast_ray({{-9, 0, 0}, {20, 0, 0}})->object, 2U);
  EXPECT_EQ(index.cast_ray_through({{-9, 0, 0}, {20, 0, 0}}).size(), 3U);
  EXPECT_EQ(index.cast_ray({{-9, 2, 0}, {20, 0, 0}})->object, 3U);
  EXPECT_EQ(index.cast_ray({{-9, 0, 0}, {4.5, 0, 0}}), std::nullopt);
  EXPECT_EQ(index.cast_shape({{Model(Sphere(1)), Pose::translation(-9, 2, 0)}, {20, 0, 0}})->object, 2U);
}

TEST(SceneIndex, NothingIsFoundWhereNothingIs) {
  const SceneIndex none;
  EXPECT_EQ(none.cast_ray({{}, {1, 0, 0}}), std::nullopt);
  EXPECT_EQ(none.nearest({Model(Point{})}), std::nullopt);
  EXPECT_TRUE(none.overlapping({Model(HalfSpace({0, 0, 0}, {0, 0, 1}))}).empty());
  EXPECT_TRUE(none.within({Model(Point{})}, HUGE_VAL).empty());
}

TEST(SceneIndex, BadInputIsRefusedByName) {
  const Model cube(test::box_between({0, 0, 0}, {1, 1, 1}));
  const Model ball(Sphere(1));
  Pose lost;
  lost.offset.x = NAN;
  const std::vector<SceneInstance> bad{{ball, {}, Solid::automatic, "room"}, {ball, lost, Solid::automatic, "chest"}};
  EXPECT_NE(message_of([&] { static_cast<void>(SceneIndex(bad)); }).find("object \"chest\""), std::string::npos);
  const std::vector<SceneInstance> objects{{cube, Pose::translation(5, 0, 0), Solid::automatic, "chest"}, {ball, {}}};
  const SceneIndex index(objects);
  const auto message = [&](const auto& ask) { return message_of([&] { static_cast<void>(ask()); }); };
  const std::vector<Ray> rays{{{}, {1, 0, 0}}, {{}, {}}};
  EXPECT_EQ(message([&] { return index.cast_ray_each(rays); }),
            "ray 1: a ray: its motion is zero; ask whether the point overlaps");
  EXPECT_EQ(message([&] { return index.nearest({ball}, -1); }),
            "the greatest distance is -1; it has to be a length of 0 or more");
  EXPECT_EQ(message([&] { return index.within({ball}, NAN); }),
            "the greatest distance is nan; it has to be a length of 0 or more");
  EXPECT_NE(message([&] { return index.overlapping({ball, lost}); }).find("the shape"), std::string::npos);
  // It could be met, but is not answered for.
  const Model ground(HalfSpace({0, 0, 0}, {0, 0, 1}));
  const std::vector<SceneInstance> grounds{{ball, {}}, {ground, {}, Solid::automatic, "lawn"}};
  EXPECT_NE(message([&] {
              return SceneIndex(grounds).cast_shape({{ground, Pose::translation(0, 0, -9)}, {0, 0, 1}});
            }).find("object \"lawn\""),
            std::string::npos);
}

}  // namespace
}  // namespace toccata
