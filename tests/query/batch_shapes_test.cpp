// Every question of the batch forms answers as the single question does, for poses and for pairs.
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "support/convex_cases.hpp"
#include "toccata/core/error.hpp"
#include "toccata/query/batch.hpp"
#include "toccata/query/overlap.hpp"

namespace toccata {
namespace {

constexpr std::uint64_t seed = 20261121;

Model model_of(const test::ConvexShape& shape) {
  return std::visit([](const auto& given) { return Model(given); }, shape);
}

/// Pairs of convex shapes of all kinds, in every regime; where `solid`, of those that have an interior.
std::vector<ModelPair> some_pairs(bool solid) {
  Random random(seed);
  std::vector<ModelPair> pairs;
  for (const std::string& kind : test::convex_kinds())
    for (std::uint64_t number = 0; number < 15; ++number) {
      const test::ConvexCase found = test::numbered_case(kind, number, random);
      if (!solid || (test::is_solid(found.a) && test::is_solid(found.b)))
        pairs.push_back({model_of(found.a.shape), model_of(found.b.shape), {found.a.pose, found.b.pose}});
    }
  return pairs;
}

/// A hull and a capsule that passes it, step by step.
struct Passage {
  Model a, b;
  std::vector<PairQuery> queries;
};

Passage some_passage() {
  Random random(seed);
  Passage passage{model_of(test::random_convex("hull", random)), Capsule({-0.25, 0, 0}, {0.25, 0, 0}, 0.125), {}};
  for (int step = -60; step < 60; ++step)
    passage.queries.push_back({.pose_b = Pose::translation(step * 0.03125, 0.5, 0)});
  return passage;
}

/// The batch forms `each` of the question `single`, on one thread and on more.
template <class Each, class Single>
void expect_as_single(const Each& each, const Single& single, bool solid) {
  const std::vector<ModelPair> pairs = some_pairs(solid);
  const Passage passage = some_passage();
  for (const int threads : {1, 2, 4}) {
    SCOPED_TRACE("seed " + std::to_string(seed) + ", threads " + std::to_string(threads));
    const BatchOptions options{.threads = threads};
    const auto of_pairs = each(pairs, options);
    ASSERT_EQ(of_pairs.size(), pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i)
      ASSERT_EQ(of_pairs[i], single(pairs[i].a, pairs[i].b, pairs[i].query)) << "pair " << i;
    const auto of_poses = each(Batch<PairQuery>(passage.a, passage.b, passage.queries), options);
    ASSERT_EQ(of_poses.size(), passage.queries.size());
    for (std::size_t i = 0; i < of_poses.size(); ++i)
      ASSERT_EQ(of_poses[i], single(passage.a, passage.b, passage.queries[i])) << "query " << i;
  }
  EXPECT_TRUE(each(std::vector<ModelPair>{}, BatchOptions{}).empty());
  EXPECT_TRUE(each(Batch<PairQuery>(passage.a, passage.b, {}), BatchOptions{}).empty());
}

#define TOCCATA_BOTH_FORMS(question) [](const auto&... given) { return question(given...); }

TEST(BatchOfShapes, Overlap) { expect_as_single(TOCCATA_BOTH_FORMS(overlap_each), TOCCATA_BOTH_FORMS(overlap), false); }

TEST(BatchOfShapes, Relation) {
  expect_as_single(TOCCATA_BOTH_FORMS(relation_each), TOCCATA_BOTH_FORMS(relation), false);
}

TEST(BatchOfShapes, Distance) {
  expect_as_single(TOCCATA_BOTH_FORMS(distance_each), TOCCATA_BOTH_FORMS(distance), false);
}

TEST(BatchOfShapes, Penetration) {
  expect_as_single(TOCCATA_BOTH_FORMS(penetration_each), TOCCATA_BOTH_FORMS(penetration), true);
}

TEST(BatchOfShapes, Manifold) {
  expect_as_single(TOCCATA_BOTH_FORMS(manifold_each), TOCCATA_BOTH_FORMS(manifold), false);
}

TEST(BatchOfShapes, ContactCounts) {
  const auto single = [](const Model& a, const Model& b, const PairQuery& query) {
    const std::size_t count = contacts(a, b, query).size();
    return ContactCount{count, count};
  };
  expect_as_single(TOCCATA_BOTH_FORMS(count_contacts_each), single, false);
}

#undef TOCCATA_BOTH_FORMS

TEST(BatchOfShapes, WhatIsKeptSavesSearchesAndChangesNoAnswer) {
  Random random(seed);
  std::vector<ModelPair> pairs;
  for (int i = 0; i < 40; ++i)
    pairs.push_back({model_of(test::random_convex("hull", random)), model_of(test::random_convex("hull", random))});
  for (const int threads : {1, 3}) {
    std::vector<SimplexCache> kept(pairs.size());
    std::uint64_t first_step = 0, later_steps = 0;
    for (int step = 0; step < 8; ++step) {
      for (ModelPair& pair : pairs) pair.query.pose_b = Pose::translation(2.5 + 0.001 * step, 0.25, 0);
      for (SimplexCache& one : kept) one.counts = {};
      EXPECT_EQ(distance_each(pairs, {.threads = threads, .warm_start = kept}),
                distance_each(pairs, {.threads = threads}));
      for (const SimplexCache& one : kept) (step == 0 ? first_step : later_steps) += one.counts.support_points;
    }
    EXPECT_LT(later_steps, 7 * first_step / 2);
  }
  std::vector<SimplexCache> too_few(3);
  EXPECT_THROW((void)distance_each(pairs, {.warm_start = too_few}), Error);
}

TEST(BatchOfShapes, Casts) {
  const Passage passage = some_passage();
  std::vector<CastQuery> moves;
  std::vector<CastPair> moving;
  std::vector<RayQuery> rays;
  std::vector<RayPair> shot;
  for (const PairQuery& query : passage.queries) {
    moves.push_back({{0, 1, 0.25}, query});
    moving.push_back({passage.b, passage.a, moves.back()});
    rays.push_back({query.pose_b.offset, {0.5, -2, 0.125}, query.pose_a});
    shot.push_back({rays.back(), passage.a});
  }
  for (const int threads : {1, 2, 4}) {
    const BatchOptions options{.threads = threads};
    const auto by_pose = cast_shape_each({passage.a, passage.b, moves}, options);
    const auto by_pair = cast_shape_each(moving, options);
    const auto rays_by_pose = cast_ray_each(rays, passage.a, options);
    EXPECT_EQ(cast_ray_each(shot, options), rays_by_pose);
    int hits = 0;
    for (std::size_t i = 0; i < moves.size(); ++i) {
      ASSERT_EQ(by_pose[i], cast_shape(passage.a, moves[i].motion, passage.b, moves[i].poses)) << "query " << i;
      ASSERT_EQ(by_pair[i], cast_shape(passage.b, moves[i].motion, passage.a, moves[i].poses)) << "pair " << i;
      ASSERT_EQ(rays_by_pose[i], cast_ray(rays[i].origin, rays[i].motion, passage.a)) << "ray " << i;
      hits += rays_by_pose[i].has_value() ? 1 : 0;
    }
    EXPECT_GT(hits, 0);
  }
  EXPECT_TRUE(cast_shape_each(std::vector<CastPair>{}).empty());
  EXPECT_TRUE(cast_ray_each(std::vector<RayPair>{}).empty());
}

/// What `ask` throws.
template <class Ask>
std::string error_of(const Ask& ask) {
  try {
    ask();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(BatchOfShapes, AnErrorNamesTheLeastOfThePairsOrQueriesThatAreWrong) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<ModelPair> pairs(900, {Sphere(1), Box({1, 1, 1})});
  pairs[457].query.pose_b.offset.x = nan;
  pairs[458].query.pose_a.linear = Mat3{{{{2, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
  pairs[899].a = Point{};
  std::vector<CastQuery> casts(900, {{0, 0, 1}});
  casts[457].motion.z = nan;
  std::vector<RayQuery> rays(900, {{0, 0, -5}, {0, 0, 1}});
  rays[457].motion.z = 0;
  for (const int threads : {1, 2, 4}) {
    const BatchOptions options{.threads = threads};
    EXPECT_TRUE(error_of([&] { (void)penetration_each(pairs, options); }).starts_with("pair 457: model b"));
    EXPECT_TRUE(error_of([&] { (void)distance_each(pairs, options); }).starts_with("pair 457: model b"));
    EXPECT_TRUE(error_of([&] {
                  (void)cast_shape_each({Sphere(1), Box({1, 1, 1}), casts}, options);
                }).starts_with("query 457: "));
    EXPECT_TRUE(error_of([&] { (void)cast_ray_each(rays, Sphere(1), options); }).starts_with("query 457: "));
  }
  const Model ground(HalfSpace({0, 0, 0}, {0, 0, 1}));
  EXPECT_NE(error_of([&] {
              (void)cast_shape_each({ground, ground, std::vector<CastQuery>(3)});
            }).find("query 0: cast"),
            std::string::npos);
}

}  // namespace
}  // namespace toccata
