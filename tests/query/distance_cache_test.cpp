#include "toccata/query/distance_cache.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "query/distance/relative_motion.hpp"
#include "support/coherence.hpp"
#include "support/mesh_soups.hpp"
#include "support/simd_levels.hpp"
#include "toccata/methods.hpp"
#include "toccata/toccata.hpp"

namespace toccata {
namespace {

TEST(DistanceCache, ChangesNoBitHoweverTheMeshesMove) {
  for (const std::string& family : test::motion_families())
    for (std::uint64_t seed = 0; seed < 4; ++seed)
      EXPECT_EQ(test::fault_of_coherence(family, seed, 25), "") << family << ", seed " << seed;
}

TEST(DistanceCache, ChangesNoBitOverAThousandSteps) {
  EXPECT_EQ(test::fault_of_coherence("1e-4", 4, 1000), "");
  EXPECT_EQ(test::fault_of_coherence("1 %", 5, 300), "");
}

// Numbers move within their interval at most, whatever was kept: after little steps, jumps, contact, another shape.
TEST(DistanceCache, KeepsTheDirectionBetweenQuadricShapes) {
  const Model egg(Ellipsoid({1, 2, 3})), can(Cylinder(0.5, 1)), box(Box({1, 1, 1})), hat(Cone(1, 1));
  for (const auto& [a, b] : {std::pair{egg, can}, std::pair{can, egg}, std::pair{box, hat}, std::pair{hat, box}}) {
    DistanceCache cache;
    Random random(3);
    for (int step = 0; step < 60; ++step) {
      PairQuery query{.pose_b = {rotation_about({1, 2, 2}, 2.0 * step), {4 + 0.05 * step, 1, 0.5}}};
      if (step % 20 == 12) query.pose_b.offset = {0.1 * random.unit(), 0, 0};
      if (step % 20 == 13) query.pose_b.offset = {-3 - random.unit(), 5, -1};
      const Distance found = distance(a, b, query, cache), alone = distance(a, b, query);
      EXPECT_EQ(found.status, alone.status) << step;
      EXPECT_LE(found.lower, alone.upper) << step;
      EXPECT_LE(alone.lower, found.upper) << step;
      EXPECT_LE(found.upper - found.lower, 1e-12 * found.upper) << step;
    }
    EXPECT_EQ(cache.counts().questions, 60U);
    EXPECT_LT(cache.counts().searches, 10U);
    EXPECT_LE(distance(box, egg, {.pose_b = Pose::translation(0, 4, 0)}, cache).lower, 1);
  }
}

/// A ball that goes round a ring, a little at a time.
PairQuery on_the_way(int step) { return {.pose_b = {rotation_about({0, 0, 1}, 0.05 * step), {1e-4 * step, 2, 0.3}}}; }

TEST(DistanceCache, LooksAtLittleWhenTheMotionIsSmallAndTheSameAtEverySimdLevel) {
  const Model ring(torus_mesh({.radius = 3, .tube_radius = 0.5})), ball(icosphere_mesh(0.5, 4));
  Workspace workspace;
  static_cast<void>(distance(ring, ball, on_the_way(0), workspace));
  const WalkCounts full = workspace.counts();
  DistanceCache first;
  std::vector<WalkCounts> counts;
  for (int step = 0; step < 20; ++step) {
    EXPECT_EQ(distance(ring, ball, on_the_way(step), first), distance(ring, ball, on_the_way(step)));
    counts.push_back(first.counts().last);
    if (step > 0) {
      EXPECT_LT(5 * counts.back().volume_tests, full.volume_tests) << step;
    }
  }
  EXPECT_EQ(first.counts().searches, 1U);
  EXPECT_EQ(first.counts().questions, 20U);
  test::at_every_simd_level([&](SimdLevel level) {
    DistanceCache cache;
    for (int step = 0; step < 20; ++step) {
      static_cast<void>(distance(ring, ball, on_the_way(step), cache));
      EXPECT_EQ(cache.counts().last, counts[static_cast<std::size_t>(step)]) << name_of(level) << ", step " << step;
    }
  });
}

TEST(DistanceCache, LooksAtAFewthOfTheBoxesWhenTheMeshesMoveByAHundredthOfTheirSize) {
  const Model ring(torus_mesh({.radius = 3, .tube_radius = 0.5, .around = 128, .sides = 48}));
  const Model ball(icosphere_mesh(1.5, 5));
  Workspace workspace;
  DistanceCache cache;
  std::size_t alone = 0, kept = 0;
  for (int step = 0; step < 40; ++step) {
    const PairQuery query{.pose_b = {rotation_about({1, 2, 3}, 0.6 * step), {0.02 * step, 0.03 * step, 2.5}}};
    EXPECT_EQ(distance(ring, ball, query, cache), distance(ring, ball, query, workspace));
    if (step == 0) continue;
    alone += workspace.counts().volume_tests;
    kept += cache.counts().last.volume_tests;
  }
  EXPECT_LT(3 * kept, alone);
  EXPECT_EQ(cache.counts().searches, 1U);
}

TEST(DistanceCache, OfPosesThatShearAsksAnewAndIsThereAgainAfterwards) {
  const Model a(icosphere_mesh(1, 3)), b(icosphere_mesh(1, 3));
  DistanceCache cache;
  for (int step = 0; step < 30; ++step) {
    PairQuery query{.pose_b = Pose::translation(1e-4 * step, 0, 2.5)};
    if (step >= 10 && step < 20) query.pose_b.linear[0][1] = 0.25;
    EXPECT_EQ(distance(a, b, query, cache), distance(a, b, query)) << step;
  }
  EXPECT_EQ(cache.counts().searches, 13U);  // the first, ten, and two on the way back
}

TEST(DistanceCache, KnowsWhatStaysWithinASolidWithoutLooking) {
  const Model outer(icosphere_mesh(2, 3)), inner(icosphere_mesh(0.5, 2));
  DistanceCache cache;
  for (int step = 0; step < 400; ++step) {
    const PairQuery query{.pose_b = Pose::translation(0.01 * step, 0, 0)};
    ASSERT_EQ(distance(outer, inner, query, cache), distance(outer, inner, query)) << step;
    if (step == 50) {
      EXPECT_EQ(cache.counts().searches, 1U);
      EXPECT_EQ(cache.counts().last, WalkCounts{});
    }
    const PairQuery surfaces{.pose_b = query.pose_b, .solid_a = Solid::none};
    if (step % 50 == 0) {
      ASSERT_EQ(distance(outer, inner, surfaces, cache), distance(outer, inner, surfaces)) << step;
    }
  }
}

TEST(DistanceCache, OfOtherModelsIsRefused) {
  const Model a(icosphere_mesh(1, 1)), b(icosphere_mesh(1, 2)), same_mesh_again(icosphere_mesh(1, 1));
  const PairQuery query{.pose_b = Pose::translation(5, 0, 0)};
  DistanceCache cache;
  const Distance d = distance(a, b, query, cache);
  EXPECT_THROW(static_cast<void>(distance(b, a, query, cache)), Error);
  EXPECT_THROW(static_cast<void>(distance(same_mesh_again, b, query, cache)), Error);
  EXPECT_THROW(static_cast<void>(distance(a, Model(Sphere(1)), query, cache)), Error);
  const std::vector<Model> copies(2, a);
  EXPECT_EQ(distance(copies[1], b, query, cache), d);
  cache.clear();
  EXPECT_EQ(distance(b, a, query, cache), distance(b, a, query));
  EXPECT_THROW(static_cast<void>(distance(a, b, query, cache)), Error);
}

TEST(DistanceCache, OfOtherShapesAsksAnew) {
  const Model mesh(icosphere_mesh(1, 2));
  const HeightField field(3, 3, 1, 1, std::vector<double>{0, 0, 0, 0, 1, 0, 0, 0, 0});
  const std::vector<CompoundPart> balls{{Sphere{1}, {}}, {Sphere{1}, Pose::translation(0, 0, 5)}};
  const Model land(field), parts{Compound(balls)};
  DistanceCache of_ball, of_land, of_parts;
  for (int step = 0; step < 10; ++step) {
    const PairQuery query{.pose_b = Pose::translation(0, 1e-4 * step, 4)};
    EXPECT_EQ(distance(mesh, Sphere(1), query, of_ball), distance(mesh, Sphere(1), query));
    EXPECT_EQ(distance(mesh, land, query, of_land), distance(mesh, land, query));
    EXPECT_EQ(distance(mesh, parts, query, of_parts), distance(mesh, parts, query));
  }
  EXPECT_EQ(of_land.counts().searches, 1U);
  EXPECT_EQ(of_ball.counts().searches, 10U);
}

TEST(RelativeMotion, IsNotLessThanWhatAnyTwoVerticesDo) {
  Random random(1);
  for (const std::string& family : test::pose_families())
    for (int i = 0; i < 20; ++i) {
      const Model a(test::random_soup(random, 4, 0.5, 0)), b(test::random_soup(random, 4, 0.5, 0));
      const PairQuery before = test::random_poses(family, random);
      PairQuery after = i % 4 == 0 ? test::random_poses(family, random) : before;
      after.pose_b.offset = after.pose_b.offset + std::exp2(random.between(-40, 2)) * Vec3{1, -1, 0.5};
      const double bound = relative_motion(a, b, before.pose_a, before.pose_b, after.pose_a, after.pose_b);
      for (const Vec3& p : a.mesh().vertices())
        for (const Vec3& q : b.mesh().vertices()) {
          const double d0 = distance(Point{}, Point{},
                                     {.pose_a = Pose{Mat3{}, transform(before.pose_a, p)},
                                      .pose_b = Pose{Mat3{}, transform(before.pose_b, q)}})
                                .upper;
          const double d1 = distance(Point{}, Point{},
                                     {.pose_a = Pose{Mat3{}, transform(after.pose_a, p)},
                                      .pose_b = Pose{Mat3{}, transform(after.pose_b, q)}})
                                .upper;
          EXPECT_LE(std::abs(d1 - d0), bound) << family;
        }
    }
}

TEST(RelativeMotion, OfTwoThatMoveTogetherIsOnlyRounding) {
  const Model a(icosphere_mesh(1, 2)), b(icosphere_mesh(1, 2));
  const Pose before_b = Pose::translation(3, 0, 0), turn{rotation_about({1, 2, 3}, 77), {4, 5, 6}};
  EXPECT_LT(relative_motion(a, b, {}, before_b, turn, turn * before_b), 1e-9);
  EXPECT_GT(relative_motion(a, b, {}, before_b, turn, before_b), 1);
}

TEST(DistanceCache, ManyPairsEachWithItsOwnAreTheSameOnAnyThreads) {
  const Model ring(torus_mesh({.radius = 3, .tube_radius = 0.5})), ball(icosphere_mesh(0.5, 2));
  constexpr std::size_t count = 12;
  std::vector<DistanceCache> one(count), many(count);
  for (int step = 0; step < 6; ++step) {
    std::vector<ModelPair> pairs;
    for (std::size_t i = 0; i < count; ++i)
      pairs.push_back({i % 4 == 3 ? Model(Sphere(0.5)) : ball, ring, on_the_way(step + static_cast<int>(i))});
    const std::vector<Distance> plain = distance_each(pairs);
    EXPECT_EQ(distance_each(pairs, one, {.threads = 1}), plain) << step;
    EXPECT_EQ(distance_each(pairs, many, {.threads = 3}), plain) << step;
  }
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_EQ(one[i].counts().searches, many[i].counts().searches) << i;
    EXPECT_EQ(one[i].counts().searches, i % 4 == 3 ? 6U : 1U) << i;
  }
}

TEST(DistanceCache, ManyPairsNeedAsManyCachesAndNameTheWrongOne) {
  const Model ball(icosphere_mesh(0.5, 1)), other(icosphere_mesh(0.25, 1));
  std::vector<DistanceCache> caches(2);
  const std::vector<ModelPair> pairs{{ball, ball, {.pose_b = Pose::translation(2, 0, 0)}},
                                     {ball, other, {.pose_b = Pose::translation(2, 0, 0)}}};
  EXPECT_THROW(static_cast<void>(distance_each(pairs, std::span(caches).first(1))), Error);
  static_cast<void>(distance_each(pairs, caches));
  const std::vector<ModelPair> exchanged{pairs[0], pairs[0]};
  try {
    static_cast<void>(distance_each(exchanged, caches));
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()).rfind("pair 1: the distance cache", 0), 0U) << error.what();
  }
}

}  // namespace
}  // namespace toccata
