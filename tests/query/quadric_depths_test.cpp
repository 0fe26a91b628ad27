// Depths of quadrics in meshes that are not convex, against those that are known.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "toccata/core/error.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/query/contacts.hpp"
#include "toccata/query/penetration.hpp"
#include "toccata/query/relation.hpp"

namespace toccata::test {
namespace {

TriangleMesh channel_of_depths() {
  const std::vector<Vec2> outline = {{-2, -1}, {2, -1}, {2, 2}, {1, 2}, {1, 0}, {-1, 0}, {-1, 2}, {-2, 2}};
  return extruded_mesh(outline, 4);
}

/// The bracket holds the depth, is as narrow as told, and its translation parts them.
void expect_bracket(const Model& mesh, const Model& shape, const Pose& pose, double depth, double ratio) {
  const PairQuery query{.pose_b = pose}, back{.pose_a = pose};
  const Penetration found = penetration(mesh, shape, query);
  EXPECT_LE(found.lower, depth * (1 + 1e-9));
  EXPECT_GE(found.upper, depth * (1 - 1e-9));
  EXPECT_LE(found.upper, ratio * found.lower) << depth;
  EXPECT_EQ(found.status, found.upper <= 1.5 * found.lower ? Status::exact : Status::not_converged);
  PairQuery moved = query;
  moved.pose_b.offset = moved.pose_b.offset + (1 + 1e-9) * found.upper * found.direction;
  EXPECT_NE(relation(mesh, shape, moved).kind, RelationKind::overlapping);
  EXPECT_EQ(penetration(shape, mesh, back), flipped(found));
}

// On the floor of the channel, and against a wall of it; shallow ones too.
TEST(QuadricDepths, OfShapesInAChannelAreFoundShallowAndDeep) {
  const Model channel(channel_of_depths());
  for (const double depth : {0.1, 1e-3, 1e-6}) {
    expect_bracket(channel, Ellipsoid({0.5, 0.5, 0.5}), Pose::translation(0, 0.5 - depth, 2), depth, 1.5);
    expect_bracket(channel, Ellipsoid({0.5, 0.25, 0.75}), Pose::translation(0.5 + depth, 1, 2), depth, 1.5);
    expect_bracket(channel, Cylinder(0.5, 0.75), Pose::translation(0.5 + depth, 1, 2), depth, 1.5);
  }
}

// A can whose axis is upright sinks into a convex mesh.
TEST(QuadricDepths, OfConvexMeshesAreThoseOfTheirHulls) {
  Pose upright = Pose::translation(0, 0, 1.75);
  expect_bracket(Model(toccata::box_mesh({2, 2, 1})), Cylinder(0.5, 1), upright, 0.25, 1 + 1e-12);
  upright.offset.z = 1.99;
  expect_bracket(Model(toccata::box_mesh({2, 2, 1})), Cone(0.5, 1), upright, 0.01, 1 + 1e-10);
}

// Corners of the difference that nearly lie in its facets: the surface that grows there multiplied without end.
TEST(QuadricDepths, OfTwoConesThatNearlyLieInEachOthersSidesAreFound) {
  const Pose pose =
      Pose::from_numbers({0.86724713126313313, 0.48281002237661391, -0.12156025505303759, -0.4935746197305611,
                          0.86576344240745406, -0.082690728311140604, 0.065318512488405658, 0.13171235357204888,
                          0.98913363497700024, -0.46646785180540329, 0.21856884915272337, 0.13590631336821563});
  const Cone slim(1.1564776831634607, 1.2082436255293743), wide(1.3590906566673655, 0.47138473561347016);
  const Penetration found = penetration(slim, wide, {.pose_b = pose});
  EXPECT_GT(found.lower, 0);
  EXPECT_LE(found.upper, (1 + 1e-12) * found.lower);
  EXPECT_EQ(penetration(wide, slim, {.pose_a = pose}), flipped(found));
}

TEST(QuadricDepths, OfWhatDoesNotOverlapAreZero) {
  const Model channel(channel_of_depths());
  const Penetration apart = penetration(channel, Ellipsoid({0.5, 0.5, 0.5}), {.pose_b = Pose::translation(0, 1, 2)});
  EXPECT_EQ(apart.upper, 0);
  EXPECT_EQ(apart.status, Status::exact);
  const Penetration touching =
      penetration(channel, Ellipsoid({0.5, 0.5, 0.5}), {.pose_b = Pose::translation(0, 0.5, 2)});
  EXPECT_EQ(touching.upper, 0);
  EXPECT_EQ(touching.status, Status::exact);
}

}  // namespace
}  // namespace toccata::test
