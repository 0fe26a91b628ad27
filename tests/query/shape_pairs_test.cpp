#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "query/shape_pairs_checks.hpp"
#include "support/mesh_soups.hpp"
#include "toccata/core/error.hpp"
#include "toccata/query/casts.hpp"
#include "toccata/query/contacts.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/query/manifold.hpp"
#include "toccata/query/overlap.hpp"
#include "toccata/query/penetration.hpp"
#include "toccata/query/relation.hpp"

namespace toccata {
namespace {

using test::as_mesh;
using test::fault_of;

TEST(MeshAndHalfSpace, LieAsTheHullDoes) {
  const std::uint64_t seed = 20261121;
  Random random(seed);
  for (const char* kind : {"triangle", "box", "hull"})
    for (const std::string& regime : test::convex_regimes())
      for (int repeat = 0; repeat < 3; ++repeat) {
        const test::HalfSpaceCase pair = test::half_space_case(kind, regime, random);
        const std::optional<Model> a = as_mesh(pair.a);
        if (!a) continue;
        const oracle::Relation truth = oracle::relation(test::set_of(pair.a), test::set_of(pair.b));
        const Solid taken = test::is_solid(pair.a) ? Solid::all : Solid::none;
        EXPECT_EQ(fault_of(*a, Model(pair.b.shape), {.pose_b = pair.b.pose, .solid_a = taken}, truth), "")
            << "seed " << seed << "\n"
            << test::to_text(pair);
      }
}

TEST(ShapeQuestions, FirstCallsOfTheGuideWork) {
  const Model wall(Box{{1, 1, 0.1}});
  const Model cube(test::box_between({-1, -1, -1}, {1, 1, 1}));
  EXPECT_TRUE(overlap(cube, wall));
  EXPECT_TRUE(overlap(cube, Box{{1, 1, 0.1}}, {.pose_b = Pose::translation(0, 0, 1.1)}));
  EXPECT_FALSE(overlap(cube, Box{{1, 1, 0.1}}, {.pose_b = Pose::translation(0, 0, 1.2)}));
  EXPECT_TRUE(overlap(Sphere{1}, Sphere{1}, {.pose_b = Pose::translation(2, 0, 0)}));
  const Distance gap = distance(Sphere{1}, Box{{1, 1, 1}}, {.pose_b = Pose::translation(0, 3, 0)});
  EXPECT_NEAR(gap.upper, 1, 1e-12);
  EXPECT_EQ(gap.on_b, (Vec3{0, 2, 0}));
  EXPECT_EQ(relation(Sphere{1}, HalfSpace{{}, {0, 0, 1}}).kind, RelationKind::overlapping);
}

TEST(ShapeQuestions, ContactsOfAShapeAreTheTrianglesThatMeetIt) {
  const Model cube(test::box_between({-1, -1, -1}, {1, 1, 1}));
  const PairQuery above{.pose_b = Pose::translation(0, 0, 1.5)};
  const std::vector<Contact> hits = contacts(cube, Sphere{0.5}, above);
  ASSERT_FALSE(hits.empty());
  for (const Contact& hit : hits) {
    EXPECT_EQ(hit.element_b, 0U);
    EXPECT_EQ(hit.intersection.kind, IntersectionKind::none);
    EXPECT_TRUE(
        overlap(PosedPolytope(cube.mesh().vertices().empty() ? Triangle{} : world_triangle(cube, {}, hit.element_a)),
                PosedPolytope(Sphere{0.5}, above.pose_b)));
  }
  // Triangles have an intersection of their own.
  const Triangle across{{Vec3{-3, 0, 0}, {3, 0.1, 0}, {0, 0, 3}}};
  for (const Contact& hit : contacts(across, cube)) EXPECT_NE(hit.intersection.kind, IntersectionKind::none);
}

TEST(ShapeQuestions, AHeightFieldIsTheSurfaceOfItsTriangles) {
  const std::vector<double> heights = {0, 0, 0, 0, 1, 0, 0, 0, 0};
  const Model hill(HeightField(3, 3, 1, 1, heights));
  EXPECT_EQ(relation(hill, Sphere{0.5, {1, 1, 1.5}}).kind, RelationKind::touching);
  EXPECT_EQ(relation(hill, Sphere{0.5, {1, 1, 1.25}}).kind, RelationKind::crossing);
  EXPECT_EQ(relation(hill, Sphere{0.5, {1, 1, 1.75}}).kind, RelationKind::apart);
  const Relation all_inside = relation(hill, Sphere{10});
  EXPECT_EQ(all_inside.containment, Containment::a_in_b);
  EXPECT_FALSE(all_inside.a_solid);
  EXPECT_THROW(static_cast<void>(relation(hill, Sphere{1}, {.solid_a = Solid::all})), Error);
}

TEST(Compounds, AreTheUnionOfTheirParts) {
  const std::array<CompoundPart, 2> halves = {CompoundPart{Box{{1, 1, 1}}, Pose::translation(-2, 0, 0)},
                                              CompoundPart{Sphere{1}, Pose::translation(2, 0, 0)}};
  const Model dumbbell(Compound{halves});
  EXPECT_EQ(dumbbell.element_count(), 2U);
  EXPECT_FALSE(overlap(dumbbell, Sphere{0.5}));
  EXPECT_EQ(relation(dumbbell, Sphere{1}).kind, RelationKind::touching);
  EXPECT_EQ(relation(dumbbell, Sphere{1.5}).kind, RelationKind::overlapping);
  EXPECT_EQ(relation(dumbbell, Sphere{9}).containment, Containment::a_in_b);
  EXPECT_EQ(relation(dumbbell, Sphere{0.25, {2, 0, 0}}).containment, Containment::b_in_a);
  EXPECT_NEAR(distance(dumbbell, Sphere{0.5}).upper, 0.5, 1e-12);
  const std::vector<Contact> hits = contacts(Sphere{1}, dumbbell);
  ASSERT_EQ(hits.size(), 2U);
  EXPECT_EQ(hits[1].element_b, 1U);
}

TEST(Compounds, CountTheElementsOfTheirMeshes) {
  const auto cube = std::make_shared<const TriangleMesh>(test::box_between({-1, -1, -1}, {1, 1, 1}));
  const std::array<CompoundPart, 2> parts = {CompoundPart{cube, {}},
                                             CompoundPart{Sphere{1}, Pose::translation(2, 0, 0)}};
  const Model model(Compound{parts});
  EXPECT_EQ(model.element_count(), 13U);
  const std::vector<Contact> hits = contacts(model, Sphere{0.5, {3.25, 0, 0}});
  ASSERT_EQ(hits.size(), 1U);
  EXPECT_EQ(hits[0].element_a, 12U);
  EXPECT_EQ(distance(model, Sphere{0.5, {4, 0, 0}}).element_a, 12U);
  EXPECT_TRUE(taken_as_solid(model, Solid::automatic));
}

TEST(SolidMeshAndBall, SeesHollowsAndSheets) {
  // A cube with a hollow in which a ball floats, touches and cuts.
  const TriangleMesh outer = test::box_between({-3, -3, -3}, {3, 3, 3}),
                     inner = test::box_between({-2, -2, -2}, {2, 2, 2});
  std::vector<Vec3> vertices(outer.vertices().begin(), outer.vertices().end());
  vertices.insert(vertices.end(), inner.vertices().begin(), inner.vertices().end());
  std::vector<std::array<Index, 3>> triangles(outer.triangles().begin(), outer.triangles().end());
  for (const auto& [i, j, k] : inner.triangles()) triangles.push_back({i + 8, k + 8, j + 8});
  const Model hollow(TriangleMesh(vertices, triangles));
  ASSERT_TRUE(hollow.closed());
  EXPECT_EQ(relation(hollow, Sphere{1}).kind, RelationKind::apart);
  EXPECT_EQ(relation(hollow, Sphere{2}).kind, RelationKind::touching);
  const Relation cut = relation(hollow, Sphere{2.5});
  EXPECT_EQ(cut.kind, RelationKind::overlapping);
  EXPECT_EQ(cut.containment, Containment::none);
  EXPECT_EQ(relation(hollow, Sphere{6}).containment, Containment::a_in_b);
  EXPECT_EQ(relation(hollow, Sphere{0.25, {2.5, 0, 0}}).containment, Containment::b_in_a);
  EXPECT_EQ(relation(hollow, Capsule{{}, {9, 0, 0}, 0.5}).kind, RelationKind::overlapping);

  // A doubled sheet has no interior, so a ball through it only touches.
  const Model sheet(TriangleMesh({{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}}, {{0, 1, 2}, {0, 2, 1}}));
  ASSERT_TRUE(sheet.closed());
  EXPECT_EQ(relation(sheet, Sphere{1}).kind, RelationKind::touching);
  EXPECT_EQ(relation(sheet, HalfSpace{{}, {1, 0, 0}}).kind, RelationKind::touching);
}

TEST(ShapeQuestions, WhatIsNotDefinedIsAnErrorWithTheReason) {
  const Model cube(test::box_between({-1, -1, -1}, {1, 1, 1})), point(Point{}), ball(Sphere{1});
  const Model ground(HalfSpace{{}, {0, 0, 1}});
  const auto expect_refused = [](const std::string& words, const std::function<void()>& ask) {
    try {
      ask();
      ADD_FAILURE() << "nothing was refused with \"" << words << "\"";
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  };
  const Model sheet(TriangleMesh({{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}}, {{0, 1, 2}}));
  expect_refused("model b is an open mesh", [&] { static_cast<void>(penetration(cube, sheet)); });
  expect_refused("model a is taken as a surface",
                 [&] { static_cast<void>(penetration(cube, ball, {.solid_a = Solid::none})); });
  expect_refused("no interior", [&] { static_cast<void>(penetration(point, ball)); });
  expect_refused("normals are opposite", [&] { static_cast<void>(penetration(ground, ground)); });
  expect_refused("model a", [&] { static_cast<void>(overlap(point, ball, {.solid_a = Solid::all})); });
  Pose stretched;
  stretched.linear[0][0] = 2;
  expect_refused("model b: the sphere", [&] { static_cast<void>(overlap(cube, ball, {.pose_b = stretched})); });
}

// A pair that is not defined does not compile.
template <class A, class B>
concept HasPenetration = requires(const A& a, const B& b) {
  penetration(a, b);
};
static_assert(HasPenetration<Sphere, Box>);
static_assert(HasPenetration<HalfSpace, ConvexHull>);
static_assert(!HasPenetration<Point, Box>);
static_assert(!HasPenetration<Box, Triangle>);
static_assert(!HasPenetration<HalfSpace, HalfSpace>);

}  // namespace
}  // namespace toccata
