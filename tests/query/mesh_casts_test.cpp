#include <gtest/gtest.h>

#include "query/mesh_casts_checks.hpp"
#include "support/simd_levels.hpp"
#include "toccata/core/error.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/query/signed_distance.hpp"

namespace toccata {
namespace {

TEST(MeshCasts, AreTheFirstOfAllPairsAtEverySimdLevel) {
  std::vector<std::optional<ShapeHit>> of_first_level;
  test::at_every_simd_level([&](SimdLevel level) {
    std::uint64_t seed = 0;
    std::vector<std::optional<ShapeHit>> found;
    for (const std::string& family : test::mesh_cast_families())
      for (int i = 0; i < 12; ++i) {
        Random random(++seed);
        const test::MeshCastCase c = test::mesh_cast_case(family, random);
        ASSERT_EQ(test::mesh_cast_fault(c.a, c.motion, c.b, c.query), "")
            << family << ", seed " << seed << ", " << name_of(level);
        ASSERT_EQ(test::mesh_cast_fault(c.b, -c.motion, c.a, test::exchanged(c.query)), "")
            << family << ", seed " << seed << ", " << name_of(level) << ", the mesh moves";
        found.push_back(cast_shape(c.a, c.motion, c.b, c.query));
      }
    if (of_first_level.empty()) of_first_level = found;
    EXPECT_EQ(found, of_first_level) << name_of(level);
  });
}

TEST(MeshCasts, OfTheMeshOfAHullAreThoseOfTheHull) {
  constexpr std::uint64_t seed = 20261122;
  Random random(seed);
  for (const std::string kind : {"triangle", "box", "hull"})
    for (std::uint64_t number = 0; number < 70; ++number) {
      const test::ConvexCase pair = test::numbered_case(kind, number, random);
      const Vec3 motion = test::random_motion(pair, random);
      ASSERT_EQ(test::hull_cast_fault(pair, motion), "") << "seed " << seed << ", " << kind << ", case " << number;
    }
}

const Model torus(generate_mesh("torus-knot"));

TEST(MeshCasts, OfManyTrianglesAreTheFirstOfAll) {
  Random random(7);
  for (int i = 0; i < 12; ++i) {
    const PairQuery query{{test::random_rotation(random), test::vector_within(random, 6)},
                          {test::random_rotation(random), test::vector_within(random, 0.5)}};
    const Vec3 motion = 1.5 * (query.pose_b.offset - query.pose_a.offset);
    for (const Model& moving : {Model(Sphere(0.3)), Model(Box({0.5, 0.2, 0.1}))})
      ASSERT_EQ(test::mesh_cast_fault(moving, motion, torus, query), "") << i;
  }
}

TEST(MeshCasts, OfTwoMeshesAreTheFirstOfAllPairs) {
  const Model ball(generate_mesh("icosphere", {{"subdivisions", 1}})), other(generate_mesh("icosphere"));
  Random random(3);
  for (int i = 0; i < 4; ++i) {
    const PairQuery query{{test::random_rotation(random), {5, 0.3, 0.2}}, {test::random_rotation(random), {}}};
    ASSERT_EQ(test::mesh_cast_fault(ball, {-8, 0, 0}, other, query), "") << i;
  }
}

TEST(MeshCasts, ASolidThatHoldsTheOtherIsMetAtOnce) {
  const Model room(test::box_between({-5, -5, -5}, {5, 5, 5})), crate(test::box_between({-1, -1, -1}, {1, 1, 1}));
  const Vec3 away{20, 0, 0};
  for (const Model& inner : {Model(Sphere(1)), Model(Box({1, 1, 1})), crate}) {
    const std::optional<ShapeHit> held = cast_shape(inner, away, room), holds = cast_shape(room, away, inner);
    EXPECT_TRUE(held.has_value() && held->lower == 0 && held->upper == 0);
    EXPECT_TRUE(holds.has_value() && holds->upper == 0);
    EXPECT_EQ(locate(held->point, room).side, Side::inside);
    const PairQuery of_surface{.solid_b = Solid::none};
    const std::optional<ShapeHit> at_wall = cast_shape(inner, away, room, of_surface);
    ASSERT_TRUE(at_wall);
    EXPECT_NEAR(at_wall->upper, 0.2, 1e-12);
    EXPECT_EQ(at_wall->normal, (Vec3{-1, 0, 0}));
  }
  // A solid shape that holds the mesh.
  EXPECT_EQ(cast_shape(Box({9, 9, 9}), away, room)->upper, 0);
}

TEST(MeshCasts, TellElementsAndFacesOfCompounds) {
  const Model crate(test::box_between({-1, -1, -1}, {1, 1, 1}));
  const std::vector<CompoundPart> parts{{Sphere(1), Pose::translation(0, 9, 0)},
                                        {crate.shape(), Pose::translation(0, 0, 0)},
                                        {Box({1, 1, 1}), Pose::translation(-9, 0, 0)}};
  const Model compound((Compound(parts)));
  const std::optional<ShapeHit> found =
      cast_shape(Sphere(1), {-10, 0, 0}, compound, {.pose_a = Pose::translation(7, 0.25, 0.5)});
  const std::optional<ShapeHit> alone =
      cast_shape(Sphere(1), {-10, 0, 0}, crate, {.pose_a = Pose::translation(7, 0.25, 0.5)});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->upper, 0.5, 1e-12);
  EXPECT_EQ(found->element_b, alone->element_b + 1);
  EXPECT_EQ(found->face_b, alone->face_b + 1);
  const std::optional<ShapeHit> moving =
      cast_shape(compound, {10, 0, 0}, Sphere(1), {.pose_b = Pose::translation(7, 0.25, 0.5)});
  EXPECT_EQ(moving->element_a, found->element_b);
  EXPECT_EQ(moving->lower, found->lower);
}

TEST(MeshCasts, AtHalfSpacesAreThoseOfTheLowestTriangle) {
  Random random(11);
  for (int i = 0; i < 40; ++i) {
    const Model soup(test::random_soup(random, 20, 0.4, i % 2 == 0 ? 8 : 0));
    const PairQuery query{test::random_poses("rigid", random).pose_a, {test::random_rotation(random), {0, 0, -3}}};
    const HalfSpace floor({0, 0, 0.5}, {1, 2, 3});
    const Vec3 motion = test::vector_within(random, 9);
    const PosedHalfSpace posed(floor, query.pose_b);
    std::optional<ShapeHit> first;
    const std::vector<PosedPolytope> triangles = test::elements_of(soup, query.pose_a);
    for (Index t = 0; t < triangles.size(); ++t)
      if (const std::optional<Cast> cast = cast_shape(triangles[t], motion, posed))
        keep_first(first, {*cast, t, 0, soup.mesh().face_of(t), 0});
    const std::optional<ShapeHit> found = cast_shape(soup, motion, floor, query);
    if (first && first->upper == 0) {
      ASSERT_TRUE(found.has_value() && found->upper == 0) << i;
      EXPECT_TRUE(overlap(triangles[found->element_a], posed)) << i;
      EXPECT_NEAR(plain_length(found->normal), 1, 1e-12) << i;
      continue;
    }
    ASSERT_EQ(found, first) << i;
    const std::optional<ShapeHit> floor_moves = cast_shape(floor, -motion, soup, test::exchanged(query));
    EXPECT_EQ(floor_moves->upper, found->upper) << i;
    EXPECT_EQ(floor_moves->element_b, found->element_a) << i;
  }
}

TEST(MeshCasts, ThatStartInContactLookAtHardlyMoreThanAnOverlap) {
  const Model ball(generate_mesh("icosphere", {{"subdivisions", 5}}));
  const PairQuery query{.pose_a = Pose::translation(0.7, 0.1, 0.2)};
  Workspace of_cast, of_overlap;
  const std::optional<ShapeHit> hit = cast_shape(ball, {-1, 0, 0}, ball, query, of_cast);
  ASSERT_TRUE(overlap(ball, ball, query, of_overlap));
  EXPECT_EQ(hit->upper, 0);
  EXPECT_LE(of_cast.counts().items, 2 * of_overlap.counts().items);
}

TEST(MeshCasts, TellTheNormalAtTheStart) {
  const Model crate(test::box_between({-1, -1, -1}, {1, 1, 1}));
  for (const Model& standing : {Model(Sphere(0.5)), Model(Box({0.5, 0.5, 0.5})), Model(Capsule({}, {}, 0.5))}) {
    const PairQuery above{.pose_a = Pose::translation(0.25, -0.25, 1.5)};
    EXPECT_EQ(cast_shape(standing, {1, 0, 0}, crate, above)->normal, (Vec3{0, 0, 1}));
    EXPECT_EQ(cast_shape(standing, {1, 0, 0}, Box({1, 1, 1}), above)->normal, (Vec3{0, 0, 1}));
    EXPECT_EQ(cast_shape(crate, {1, 0, 0}, standing, {.pose_b = above.pose_a})->normal, (Vec3{0, 0, -1}));
    EXPECT_EQ(cast_shape(standing, {}, HalfSpace({}, {0, 0, 1}), {.pose_a = Pose::translation(0, 0, 0.5)})->normal,
              (Vec3{0, 0, 1}));
  }
  EXPECT_EQ(cast_shape(Sphere(1), {}, Sphere(1), {.pose_a = Pose::translation(0, 2, 0)})->normal, (Vec3{0, 1, 0}));
}

TEST(MeshCasts, LookAtFewTriangles) {
  const Model ball(generate_mesh("icosphere", {{"subdivisions", 5}}));
  ASSERT_GT(ball.element_count(), 20000U);
  Workspace workspace;
  const std::optional<ShapeHit> hit =
      cast_shape(Sphere(0.1), {-9, 0.1, 0.05}, ball, {.pose_a = Pose::translation(6, 0, 0)}, workspace);
  ASSERT_TRUE(hit);
  EXPECT_LT(workspace.counts().items, 200U);
}

TEST(MeshCasts, RefuseWhatIsNotFinite) {
  EXPECT_THROW(static_cast<void>(cast_shape(Sphere(1), {NAN, 0, 0}, torus)), Error);
}

}  // namespace
}  // namespace toccata
