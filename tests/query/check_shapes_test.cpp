#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "support/mesh_soups.hpp"
#include "toccata/core/error.hpp"
#include "toccata/query/batch.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/query/self_contacts.hpp"

namespace toccata {
namespace {

SceneInstance placed_at(const Model& model, double x, double y, double z) {
  return {model, Pose::translation(x, y, z)};
}

std::vector<SceneInstance> playground() {
  const std::array<CompoundPart, 2> parts = {CompoundPart{Sphere{0.5}}, CompoundPart{Box{{0.25, 0.25, 0.25}}}};
  return {placed_at(HalfSpace{{}, {0, 0, 1}}, 0, 0, 0),                           // 0: the ground, z ≤ 0
          placed_at(Sphere{1}, 0, 0, 1),                                          // 1: lies on it
          placed_at(Model(test::box_between({-1, -1, -1}, {1, 1, 1})), 5, 0, 0),  // 2: half in it
          placed_at(Box{{1, 1, 1}}, 7, 0, 2),            // 3: touches 2 along an edge, above the ground
          placed_at(Model(Compound{parts}), 100, 0, 0),  // 4: half in the ground
          placed_at(Point{}, 0, 0, 1)};                  // 5: in the ball
}

TEST(CheckShapes, FindsEveryPairOfShapesThatMeets) {
  const CheckAnswer answer = check_all(playground(), {.contacts = true});
  const auto found = [&](std::size_t i) { return std::pair(answer.pairs[i].a, answer.pairs[i].b); };
  ASSERT_EQ(answer.pairs.size(), 5U);
  EXPECT_EQ(found(0), std::pair(Index{0}, Index{1}));
  EXPECT_EQ(answer.pairs[0].relation.kind, RelationKind::touching);
  EXPECT_EQ(answer.pairs[0].contacts.size(), 1U);
  EXPECT_EQ(found(1), std::pair(Index{0}, Index{2}));
  EXPECT_EQ(answer.pairs[1].relation.kind, RelationKind::overlapping);
  EXPECT_EQ(answer.pairs[1].contacts.size(), 10U);  // all triangles but the two of the top
  EXPECT_EQ(found(2), std::pair(Index{0}, Index{4}));
  EXPECT_EQ(answer.pairs[2].contacts.size(), 2U);
  EXPECT_EQ(found(3), std::pair(Index{1}, Index{5}));
  EXPECT_EQ(answer.pairs[3].relation.containment, Containment::b_in_a);
  EXPECT_EQ(found(4), std::pair(Index{2}, Index{3}));
  EXPECT_EQ(answer.pairs[4].relation.kind, RelationKind::touching);
}

TEST(CheckShapes, TellsHowDeepWhereThatIsDefined) {
  const CheckAnswer answer = check_all(playground(), {.penetration = true, .threads = 2});
  ASSERT_EQ(answer.pairs.size(), 5U);
  const PairAnswer &on_ground = answer.pairs[0], &mesh = answer.pairs[1], &compound = answer.pairs[2],
                   &point = answer.pairs[3];
  ASSERT_TRUE(on_ground.penetration && on_ground.manifold);
  EXPECT_EQ(on_ground.penetration->upper, 0) << "it touches";
  EXPECT_EQ(on_ground.manifold->count, 1);
  ASSERT_TRUE(mesh.penetration && compound.penetration);
  EXPECT_LE(mesh.penetration->lower, 1);
  EXPECT_NEAR(mesh.penetration->upper, 1, 1e-12);
  EXPECT_NEAR(compound.penetration->upper, 0.5, 1e-12) << "of the ball, which is larger than the box";
  EXPECT_FALSE(mesh.manifold || compound.manifold);
  EXPECT_FALSE(point.penetration) << "a point has no interior";
  EXPECT_TRUE(point.manifold);
  EXPECT_FALSE(check_all(playground()).pairs[0].penetration) << "not asked for";
}

TEST(CheckShapes, AFlatHullHasNoDepthAndPointsOfContact) {
  const ConvexHull square(std::vector<Vec3>{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}});
  const CheckAnswer answer = check_all(
      std::vector<SceneInstance>{placed_at(square, 0, 0, 0), placed_at(Sphere{1}, 0, 0, 0.5)}, {.penetration = true});
  ASSERT_EQ(answer.pairs.size(), 1U);
  EXPECT_FALSE(answer.pairs[0].penetration);
  EXPECT_TRUE(answer.pairs[0].manifold);
}

TEST(CheckShapes, ErrorsNameTheModel) {
  std::vector<SceneInstance> models = playground();
  models[1].pose.linear[0][0] = 2;
  models[1].name = "ball";
  try {
    static_cast<void>(check_all(models));
    FAIL() << "a deformed ball is no ball";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("object \"ball\""), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("ellipsoid"), std::string::npos) << error.what();
  }
}

TEST(CheckShapes, OnlyHalfSpacesHaveNoBoxesAndAreStillCompared) {
  const std::vector<SceneInstance> two = {placed_at(HalfSpace{{}, {0, 0, 1}}, 0, 0, 0),
                                          placed_at(HalfSpace{{}, {0, 0, -1}}, 0, 0, 0)};
  const CheckAnswer answer = check_all(two);
  ASSERT_EQ(answer.pairs.size(), 1U);
  EXPECT_EQ(answer.pairs[0].relation.kind, RelationKind::touching);
}

TEST(CheckShapes, ManyPosesOfAShapeAndAMesh) {
  const Model cube(test::box_between({-1, -1, -1}, {1, 1, 1}));
  const std::vector<PairQuery> queries = {{.pose_b = Pose::translation(0, 0, 1.5)},
                                          {.pose_b = Pose::translation(0, 0, 2)},
                                          {.pose_b = Pose::translation(0, 0, 2.5)}};
  EXPECT_EQ(overlap_each({cube, Sphere{1}, queries}), (std::vector<std::uint8_t>{1, 1, 0}));
  const std::vector<ContactCount> counts = count_contacts_each({cube, Sphere{1}, queries});
  EXPECT_GT(counts[0].triangle_pairs, 0U);
  EXPECT_EQ(counts[2], ContactCount{});
}

TEST(CheckShapes, WhatIsAskedOfMeshesIsAnErrorForOthers) {
  EXPECT_THROW(static_cast<void>(self_contacts(Sphere{1})), Error);
  EXPECT_THROW(static_cast<void>(Model(Sphere{1}).mesh()), Error);
  EXPECT_THROW(static_cast<void>(Model(Sphere{1}).wide_bvh()), Error);
  EXPECT_TRUE(self_contacts_each(std::vector<SceneInstance>{{Model(Sphere{1})}})[0].empty());
}

TEST(SelfContactsEach, RefusesACompound) {
  const Compound two(std::vector<CompoundPart>{{Sphere(1), {}}, {Box({1, 1, 1}), {}}});
  const std::vector<SceneInstance> models{{Model(Sphere(1))}, {Model(two), {}, Solid::automatic, "pair"}};
  try {
    (void)self_contacts_each(models, {});
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("pair"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace toccata
