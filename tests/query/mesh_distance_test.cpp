#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "oracle/meshes.hpp"
#include "support/mesh_distances.hpp"
#include "support/mesh_pairs.hpp"
#include "support/mesh_soups.hpp"
#include "support/simd_levels.hpp"
#include "toccata/methods.hpp"
#include "toccata/toccata.hpp"

namespace toccata {
namespace {

/// B moved off, now and then far.
PairQuery apart(PairQuery query, Random& random) {
  const double way = std::exp2(random.between(-12, 6));
  query.pose_b.offset = query.pose_b.offset + way * Vec3{random.between(-1, 1), random.between(-1, 1), 1};
  return query;
}

void expect_same_at_every_simd_level(const Model& a, const Model& b, const PairQuery& query) {
  const Distance truth = distance(a, b, query);
  EXPECT_GT(truth.upper, 0);
  Workspace first;
  static_cast<void>(distance(a, b, query, first));
  test::at_every_simd_level([&](SimdLevel level) {
    Workspace workspace;
    EXPECT_EQ(distance(a, b, query, workspace), truth) << name_of(level);
    EXPECT_EQ(workspace.counts(), first.counts()) << name_of(level);
    EXPECT_EQ(distance(a, b, query, workspace), truth) << "warm, " << name_of(level);
  });
}

TEST(MeshDistance, IsThatOfTheOracle) {
  for (const std::string& family : test::pose_families())
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      SCOPED_TRACE(family + ", seed " + std::to_string(seed));
      Random random(seed);
      PairQuery query = test::random_poses(family, random);
      if (seed > 0) query = apart(query, random);
      query.solid_a = query.solid_b = Solid::none;
      const double grid = seed % 2 == 0 ? 8 : 0;
      const Model a(test::random_soup(random, 6, 0.3, grid)), b(test::random_soup(random, 6, 0.3, grid));
      const Distance d = distance(a, b, query);
      const oracle::Rational squared = oracle::squared_distance(oracle::surface_set(a.mesh(), query.pose_a),
                                                                oracle::surface_set(b.mesh(), query.pose_b));
      const oracle::Rational lower(d.lower), upper(d.upper);
      EXPECT_LE(lower * lower, squared);
      EXPECT_GE(upper * upper, squared);
    }
}

TEST(MeshDistance, IsTheLeastOfAllPairs) {
  for (const std::string& family : test::pose_families())
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      Random random(seed);
      PairQuery query = test::random_poses(family, random);
      if (seed % 3 > 0) query = apart(query, random);
      const double grid = seed % 2 == 0 ? 8 : 0;
      const Model a(test::random_soup(random, 20, 0.2, grid)), b(test::random_soup(random, 40, 0.1, grid));
      EXPECT_EQ(test::fault_of_surface_distance(a, b, query), "") << family << ", seed " << seed;
    }
}

TEST(MeshDistance, WhereManyPairsAreEquallyNearIsTheLeastOfAllPairs) {
  for (const double gap : {1e-2, 1e-6, 1e-9}) {
    const Model helix(helix_mesh({.pitch = 2 * (2 + gap), .turns = 1, .steps_per_turn = 12}));
    const PairQuery query{.pose_b = Pose::translation(0, 0, 2 + gap)};
    EXPECT_EQ(test::fault_of_surface_distance(helix, helix, query), "") << "gap " << gap;
  }
}

TEST(MeshDistance, IsTheSameAtEverySimdLevelWithTheSameCounts) {
  const Model ball(icosphere_mesh(1, 4)), ring(torus_mesh({.radius = 3, .tube_radius = 0.5}));
  expect_same_at_every_simd_level(ball, ring, {.pose_b = {rotation_about({1, 2, 3}, 40), {0.1, 0.2, 0.3}}});
  const Model helix(helix_mesh({.pitch = 4.0002, .sides = 16}));
  expect_same_at_every_simd_level(helix, helix, {.pose_b = Pose::translation(0, 0, 2.0001)});
  const Model shell(noise_sphere_mesh({1, 0.3, 4, 3})), inner(noise_sphere_mesh({0.999, 0.3, 4, 3}));
  expect_same_at_every_simd_level(shell, inner, {.solid_a = Solid::none, .solid_b = Solid::none});
}

TEST(MeshDistance, OfSolidsIsZeroWhereOneContainsTheOther) {
  const Model outer(icosphere_mesh(2, 3)), inner(icosphere_mesh(0.5, 2));
  EXPECT_EQ(distance(outer, inner).upper, 0);
  EXPECT_EQ(distance(inner, outer).upper, 0);
  const Distance within = distance(outer, inner, {.solid_a = Solid::none, .solid_b = Solid::none});
  EXPECT_GT(within.lower, 1.3);
  EXPECT_LT(within.upper, 1.5);
}

TEST(MeshDistance, OfBoxesIsThatOfTheBoxes) {
  const Model a(test::box_between({0, 0, 0}, {1, 1, 1})), b(test::box_between({3, 0, 0}, {4, 1, 1}));
  const Distance d = distance(a, b);
  EXPECT_EQ(d.upper, 2);
  EXPECT_EQ(d.on_a.x, 1);
  EXPECT_EQ(d.on_b.x, 3);
  EXPECT_EQ(distance(a, a).upper, 0);
}

TEST(MeshDistance, WhereLongerNumbersDoNotSettleItExactArithmeticDoes) {
  // Far from the origin, a vertex over the very edge of a face.
  const auto one = [](const Vec3& p, const Vec3& q, const Vec3& r) {
    return Model(TriangleMesh({p, q, r}, {{0, 1, 2}}));
  };
  const Model a = one({-960981.18438838539, -1000000.5246471612, 999999.78768115293},
                      {-960981.2685020708, -1000000.627350377, 999999.90441562689},
                      {-960981.30006379378, -1000000.5710153036, 999999.79738657875});
  const TriangleMesh both({{-960981.92413220485, -1000000.6369585152, 999999.44054564915},
                           {-960981.51596873498, -1000000.781804279, 999999.88967712794},
                           {-960981.4813586903, -1000000.8791354134, 999999.54851323622},
                           {-960981.51287058636, -999999.89707490616, 999999.85636150825},
                           {-960981.47169701569, -999999.7113207588, 999999.49097541906},
                           {-960981.70366967644, -999999.68017247063, 999999.44758622488}},
                          {{3, 4, 5}, {0, 1, 2}});
  EXPECT_EQ(test::fault_of_surface_distance(a, Model(both), {}), "");
  EXPECT_LT(distance(a, Model(both)).upper, 0.3);
}

TEST(MeshDistance, OfNestedShellsAndHelicesIsRightAtEveryGap) {
  const TriangleMesh shell = generate_mesh("noise-sphere", {{"subdivisions", 1}});
  const TriangleMesh helix = generate_mesh("helix", {{"turns", 1}, {"steps-per-turn", 12}, {"sides", 4}});
  for (const double gap : {1e-2, 1e-5, 1e-8, 1e-12}) {
    SCOPED_TRACE(gap);
    const Model outer(shell), inner(scaled_mesh(shell, 1 - gap));
    EXPECT_EQ(test::fault_of_surface_distance(outer, inner, {}), "");
    EXPECT_EQ(distance(outer, inner).upper, 0);
    const Model coil(helix);
    const PairQuery lifted{.pose_b = Pose::translation(0, 0, 2 + gap)};
    EXPECT_EQ(test::fault_of_surface_distance(coil, coil, lifted), "");
  }
}

/// Expects the distance of a mesh and another shape to be the least over the triangles.
void expect_least_of_triangles(const Model& mesh, const Model& shape, const PairQuery& query) {
  const Distance found = distance(mesh, shape, query);
  double lower = std::numeric_limits<double>::infinity(), upper = lower;
  for (Index i = 0; i < mesh.element_count(); ++i) {
    const Distance d = distance(world_triangle(mesh, query.pose_a, i), shape, {.pose_b = query.pose_b});
    lower = std::min(lower, d.lower);
    upper = std::min(upper, d.upper);
  }
  EXPECT_LE(found.lower, upper);
  EXPECT_LE(lower, found.upper);
  EXPECT_LE(found.upper, upper);
  EXPECT_LE(found.upper - found.lower, 1e-12 * found.upper);
  const Distance other = distance(shape, mesh, test::exchanged(query));
  EXPECT_EQ(flipped(other), found);
}

TEST(MeshDistance, ToOtherShapesIsTheLeastOfItsTriangles) {
  Random random(1);
  const Model mesh(test::random_soup(random, 60, 0.2, 0));
  const std::vector<Model> shapes{Model(Sphere(0.3)), Model(Capsule({0, 0, -0.5}, {0, 0, 0.5}, 0.2)),
                                  Model(Box{{0.3, 0.2, 0.1}}), Model(Point{{0, 0, 0}}),
                                  Model(HalfSpace{{0, 0, 0}, {0.6, 0, 0.8}})};
  for (const Model& shape : shapes)
    for (int i = 0; i < 6; ++i) {
      SCOPED_TRACE(std::string(name_of(shape.shape())) + ", pose " + std::to_string(i));
      const Vec3 from{random.between(-3, 3), random.between(-3, 3), random.between(-3, 3)};
      expect_least_of_triangles(mesh, shape, {.pose_b = {test::random_rotation(random), from}, .solid_a = Solid::none});
    }
}

/// Whoever asks about these two that meet is told of the same elements, which do.
void expect_one_contact(const Model& a, const Model& b, const PairQuery& query) {
  const Distance truth = distance(a, b, query);
  EXPECT_EQ(truth.upper, 0);
  const auto all = contacts(a, b, query);
  EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const Contact& contact) {
    return contact.element_a == truth.element_a && contact.element_b == truth.element_b;
  }));
  DistanceCache cache;
  PairQuery before = query;
  before.pose_b.offset = before.pose_b.offset + Vec3{0, 0, 5};
  static_cast<void>(distance(a, b, before, cache));
  test::at_every_simd_level([&](SimdLevel level) {
    Workspace workspace;
    static_cast<void>(distance(a, b, before, workspace));
    EXPECT_EQ(distance(a, b, query, workspace), truth) << "warm, " << name_of(level);
    EXPECT_EQ(distance_within(a, b, 0.125, query, workspace), truth) << name_of(level);
    if (a.has_mesh() && b.has_mesh()) {
      EXPECT_EQ(distance(a, b, query, cache), truth) << "after others, " << name_of(level);
    }
  });
}

TEST(MeshDistance, OfMeshesThatMeetNamesTheSameTwoElementsWhoeverAsks) {
  int met = 0;
  for (const std::string& family : test::pose_families())
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      SCOPED_TRACE(family + ", seed " + std::to_string(seed));
      Random random(seed);
      PairQuery query = test::random_poses(family, random);
      query.solid_a = query.solid_b = Solid::none;
      const double grid = seed % 2 == 0 ? 8 : 0;
      const Model a(test::random_soup(random, 40, 0.6, grid)), b(test::random_soup(random, 40, 0.6, grid));
      if (!overlap(a, b, query)) continue;
      ++met;
      expect_one_contact(a, b, query);
    }
  EXPECT_GT(met, 10);
  expect_one_contact(Model(icosphere_mesh(1, 3)), Box{{0.5, 0.5, 0.5}}, {.pose_b = Pose::translation(0.9, 0.1, 0)});
  expect_one_contact(Model(icosphere_mesh(1, 3)), HalfSpace({0, 0, -0.9}, {0, 0, 1}), {});
}

TEST(MeshDistance, OfMeshesThatMeetLooksAtNoMoreThanOverlap) {
  const Model ball(icosphere_mesh(1, 4));
  for (const double x : {0.25, 1.0, 1.75}) {
    const PairQuery query{.pose_b = {rotation_about({1, 2, 3}, 20), {x, 0, 0}}};
    Workspace of_overlap, of_distance;
    EXPECT_TRUE(overlap(ball, ball, query, of_overlap));
    EXPECT_EQ(distance(ball, ball, query, of_distance).upper, 0);
    EXPECT_LE(of_distance.counts().volume_tests, of_overlap.counts().volume_tests);
  }
}

TEST(MeshDistance, OfAFieldAndACompound) {
  const std::vector<double> heights{0, 0, 0, 0, 1, 0, 0, 0, 0};
  const Model field(HeightField(3, 3, 1, 1, heights));
  const Distance above = distance(field, Sphere{0.25}, {.pose_b = Pose::translation(1, 1, 2)});
  EXPECT_LE(above.lower, 0.75);
  EXPECT_GE(above.upper, 0.75);
  const std::vector<CompoundPart> parts{{Sphere{0.25}, Pose::translation(9, 9, 9)},
                                        {Sphere{0.25}, Pose::translation(1, 1, 2)}};
  const Distance of_parts = distance(field, Model(Compound(parts)));
  EXPECT_EQ(of_parts.element_b, 1U);
  EXPECT_EQ(of_parts.upper, above.upper);
}

}  // namespace
}  // namespace toccata
