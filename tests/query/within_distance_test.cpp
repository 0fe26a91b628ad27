#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "oracle/meshes.hpp"
#include "support/closeness.hpp"
#include "support/mesh_soups.hpp"
#include "support/simd_levels.hpp"
#include "toccata/methods.hpp"
#include "toccata/toccata.hpp"

namespace toccata {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

double below(double x) { return std::nextafter(x, 0.0); }

TEST(WithinDistance, IsThatOfTheOracle) {
  for (const std::string& family : test::pose_families())
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      Random random(seed);
      PairQuery query = test::random_poses(family, random);
      query.pose_b.offset = query.pose_b.offset + std::exp2(random.between(-12, 4)) * Vec3{1, 0.5, 1};
      query.solid_a = query.solid_b = Solid::none;
      const double grid = seed % 2 == 0 ? 8 : 0;
      const Model a(test::random_soup(random, 5, 0.3, grid)), b(test::random_soup(random, 5, 0.3, grid));
      EXPECT_EQ(test::fault_of_closeness(a, b, query), "") << family << ", seed " << seed;
    }
}

/// Two triangles whose nearest points are (0, 0, 0) and (3, 4, 0), away from each other otherwise.
TEST(WithinDistance, AToleranceThatIsTheDistanceCountsAndTheDoubleBelowDoesNot) {
  for (const double scale : {1.0, 0x1p-300, 0x1p-30, 0x1p40, 0x1p300}) {
    SCOPED_TRACE(scale);
    const auto model = [&](const Vec3& p, const Vec3& q, const Vec3& r) {
      return Model(TriangleMesh({scale * p, scale * q, scale * r}, {{0, 1, 2}}));
    };
    const Model a = model({0, 0, 0}, {-1, 0, 1}, {0, -1, -1}), b = model({3, 4, 0}, {4, 4, 1}, {3, 5, -2});
    EXPECT_TRUE(within_distance(a, b, 5 * scale));
    EXPECT_FALSE(within_distance(a, b, below(5 * scale)));
    EXPECT_EQ(distance_within(a, b, 5 * scale), distance(a, b));
    EXPECT_EQ(distance_within(a, b, below(5 * scale)), std::nullopt);
    const Model ball(Sphere(2 * scale));
    const PairQuery moved{.pose_b = Pose::translation(-3 * scale, -4 * scale, 0)};
    EXPECT_TRUE(within_distance(a, Model(Point{}), 5 * scale, {.pose_b = Pose::translation(3 * scale, 4 * scale, 0)}));
    EXPECT_TRUE(within_distance(b, ball, 8 * scale, moved));
    EXPECT_FALSE(within_distance(b, ball, below(8 * scale), moved));
    EXPECT_FALSE(distance_within(ball, b, below(8 * scale), {.pose_a = moved.pose_b}));
  }
}

TEST(WithinDistance, OfRoundShapesAndHalfSpacesIsExact) {
  const Pose off = Pose::translation(3, 4, 0);
  EXPECT_TRUE(within_distance(Sphere(1), Sphere(1), 3, {.pose_b = off}));
  EXPECT_FALSE(within_distance(Sphere(1), Sphere(1), below(3), {.pose_b = off}));
  // The doubles 0.1 and 0.2 add up to a little less than what leaves the double 0.7 of 1.
  const PairQuery beside{.pose_b = Pose::translation(1, 0, 0)};
  EXPECT_TRUE(within_distance(Sphere(0.1), Sphere(0.2), std::nextafter(0.7, 1), beside));
  EXPECT_FALSE(within_distance(Sphere(0.1), Sphere(0.2), 0.7, beside));
  const HalfSpace floor{{0, 0, 0}, {0, 3, 4}};
  const Model tip(TriangleMesh({{0, 3, 4}, {1, 4, 4}, {0, 4, 5}}, {{0, 1, 2}}));
  for (const Model& shape : {Model(Point{}), tip}) {
    const PairQuery query{.pose_a = kind_of(shape.shape()) == ShapeKind::mesh ? Pose{} : Pose::translation(0, 3, 4)};
    EXPECT_TRUE(within_distance(shape, floor, 5, query));
    EXPECT_FALSE(within_distance(shape, floor, below(5), query));
    EXPECT_EQ(distance_within(shape, floor, 5, query), distance(shape, floor, query));
    EXPECT_FALSE(distance_within(shape, floor, below(5), query));
  }
}

TEST(WithinDistance, AToleranceOfZeroIsOverlap) {
  const Model a(test::box_between({0, 0, 0}, {1, 1, 1})), b(test::box_between({1, 0, 0}, {2, 1, 1}));
  EXPECT_TRUE(within_distance(a, b, 0));
  EXPECT_TRUE(within_distance(a, b, -0.0));
  EXPECT_EQ(distance_within(a, b, 0)->upper, 0);
  const PairQuery apart{.pose_b = Pose::translation(0x1p-52, 0, 0)};
  EXPECT_FALSE(within_distance(a, b, 0, apart));
  EXPECT_FALSE(within_distance(a, b, 5e-324, apart));
  EXPECT_TRUE(within_distance(a, b, 0x1p-52, apart));
}

TEST(WithinDistance, WhatLiesWithinASolidIsAtDistanceZero) {
  const Model outer(icosphere_mesh(2, 3)), inner(icosphere_mesh(0.5, 2));
  EXPECT_TRUE(within_distance(outer, inner, 0));
  EXPECT_TRUE(within_distance(inner, outer, 0));
  EXPECT_TRUE(within_distance(outer, Sphere(0.5), 0));
  EXPECT_EQ(distance_within(outer, inner, 0), distance(outer, inner));
  const PairQuery surfaces{.solid_a = Solid::none, .solid_b = Solid::none};
  EXPECT_FALSE(within_distance(outer, inner, 1.2, surfaces));
  EXPECT_TRUE(within_distance(outer, inner, 1.6, surfaces));
}

TEST(WithinDistance, OfACompoundIsThatOfItsParts) {
  const std::vector<CompoundPart> parts{{Sphere{1}, Pose::translation(9, 9, 9)},
                                        {Sphere{1}, Pose::translation(0, 0, 5)}};
  const Model compound{Compound(parts)};
  const Model mesh(test::box_between({-1, -1, 0}, {1, 1, 1}));
  EXPECT_TRUE(within_distance(mesh, compound, 3));
  EXPECT_FALSE(within_distance(mesh, compound, below(3)));
  EXPECT_EQ(distance_within(mesh, compound, 3), distance(mesh, compound));
  EXPECT_EQ(distance_within(mesh, compound, 3)->element_b, 1U);
}

TEST(WithinDistance, LooksAtLessThanTheDistanceAndTheSameAtEverySimdLevel) {
  const Model ball(icosphere_mesh(1, 4)), ring(torus_mesh({.radius = 3, .tube_radius = 0.5}));
  const PairQuery query{.pose_b = {rotation_about({1, 2, 3}, 40), {0.1, 0.2, 0.3}}};
  Workspace workspace;
  const double truth = distance(ball, ring, query, workspace).upper;
  const WalkCounts full = workspace.counts();
  for (const double share : {0.25, 0.5, 2.0, 4.0}) {
    SCOPED_TRACE(share);
    Workspace cold;
    EXPECT_EQ(within_distance(ball, ring, share * truth, query, cold), share >= 1);
    const WalkCounts counts = cold.counts();
    EXPECT_LT(4 * counts.volume_tests, full.volume_tests);
    test::at_every_simd_level([&](SimdLevel level) {
      Workspace fresh;
      EXPECT_EQ(within_distance(ball, ring, share * truth, query, fresh), share >= 1) << name_of(level);
      EXPECT_EQ(fresh.counts(), counts) << name_of(level);
    });
  }
}

TEST(WithinDistance, AskedForManyIsTheSame) {
  const Model a(icosphere_mesh(1, 2)), b(torus_mesh({.radius = 1, .tube_radius = 0.3}));
  std::vector<PairQuery> queries;
  std::vector<ModelPair> pairs;
  for (int i = 0; i < 20; ++i) {
    queries.push_back({.pose_b = Pose::translation(0, 0, 0.2 * i)});
    pairs.push_back({a, b, queries.back()});
  }
  const std::vector<std::uint8_t> close = within_distance_each({a, b, queries}, 0.5, {.threads = 2});
  const auto near = distance_within_each({a, b, queries}, 0.5, {.threads = 2});
  EXPECT_EQ(within_distance_each(pairs, 0.5), close);
  EXPECT_EQ(distance_within_each(pairs, 0.5), near);
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const Distance truth = distance(a, b, queries[i]);
    EXPECT_EQ(close[i], truth.upper <= 0.5);
    EXPECT_EQ(near[i], close[i] ? std::optional(truth) : std::nullopt);
  }
}

TEST(WithinDistance, RefusesWhatIsNoLength) {
  const Sphere ball(1);
  const PairQuery far{.pose_b = Pose::translation(1e300, 0, 0)};
  EXPECT_TRUE(within_distance(ball, ball, unlimited, far));
  EXPECT_EQ(distance_within(ball, ball, unlimited, far), distance(ball, ball, far));
  for (const double wrong : {-1.0, -5e-324, -unlimited, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(static_cast<void>(within_distance(ball, ball, wrong)), Error);
    EXPECT_THROW(static_cast<void>(distance_within(ball, ball, wrong)), Error);
  }
  try {
    static_cast<void>(within_distance_each({ball, ball, std::vector<PairQuery>(3)}, -2));
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "query 0: the greatest distance is -2; it has to be a length of 0 or more");
  }
}

}  // namespace
}  // namespace toccata
