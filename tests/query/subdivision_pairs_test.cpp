// Two limit surfaces, what lies within one, and where rounding ends a search.
#include <gtest/gtest.h>

#include <string>

#include "query/subdivision_cages.hpp"
#include "support/error_message.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/query/subdivision.hpp"

namespace toccata::test {
namespace {

SubdivisionCage cube_of_size(double half, CageFeatures features = {}) {
  PolygonMesh cube = cube_cage();
  for (Vec3& v : cube.vertices) v = half * v;
  return {cube, SubdivisionScheme::catmull_clark, std::move(features)};
}

TEST(LimitPairs, AgreeWithFineMeshesBothWaysRound) {
  const SubdivisionCage a = cube_of_size(1), b(bipyramid_cage(5), SubdivisionScheme::loop);
  const SubdividedMesh fine_a = refine(a, {.tolerance = 0.02}), fine_b = refine(b, {.tolerance = 0.02});
  const Model mesh_a(fine_a.mesh), mesh_b(fine_b.mesh);
  const double off = fine_a.distance_to_limit + fine_b.distance_to_limit;
  Random random(21);
  for (int i = 0; i < 3; ++i) {
    const Pose pose = Pose::translation(random.between(1.5, 3), random.between(-2, 2), random.between(-2, 2)) *
                      Pose::rotation({1, 2, 3}, random.between(0, 360));
    const LimitDistance found = distance(a, b, {.pair = {.pose_b = pose}, .tolerance = 1e-4});
    const LimitDistance turned = distance(b, a, {.pair = {.pose_a = pose}, .tolerance = 1e-4});
    const Distance mesh = distance(mesh_a, mesh_b, {.pose_b = pose, .solid_a = Solid::none, .solid_b = Solid::none});
    EXPECT_EQ(found.status, Status::exact);
    EXPECT_LE(found.upper - found.lower, 1e-4);
    EXPECT_LE(found.lower, mesh.upper + off);
    EXPECT_GE(found.upper, mesh.lower - off);
    EXPECT_LE(std::max(found.lower, turned.lower), std::min(found.upper, turned.upper));
    EXPECT_NEAR(length(found.on_mesh - found.on_model), found.upper, 1e-3);
    EXPECT_LT(found.element, b.polygons().first.size() - 1);
  }
}

TEST(LimitPairs, OfWhichOneIsWithinTheOtherMeetAsSolidsOnly) {
  const SubdivisionCage large = cube_of_size(1), small = cube_of_size(0.2);
  const LimitQuery surfaces{.pair = {.solid_a = Solid::none, .solid_b = Solid::none}, .tolerance = 1e-2};
  for (const bool is_turned : {false, true}) {
    const SubdivisionCage &a = is_turned ? small : large, &b = is_turned ? large : small;
    EXPECT_TRUE(overlap(a, b).overlap);
    EXPECT_EQ(overlap(a, b).status, Status::exact);
    EXPECT_EQ(distance(a, b).upper, 0);
    EXPECT_FALSE(overlap(a, b, surfaces).overlap);
    EXPECT_GT(distance(a, b, surfaces).lower, 0.3);
    // The small one is no solid, but lies within one.
    LimitQuery one{.pair = {.solid_a = Solid::none}};
    if (!is_turned) one = {.pair = {.solid_b = Solid::none}};
    EXPECT_TRUE(overlap(a, b, one).overlap);
  }
  EXPECT_FALSE(overlap(large, small, {.pair = {.pose_b = Pose::translation(1.1, 1.1, 0)}}).overlap);
}

TEST(LimitPairs, ThatCrossAreProvedToAndThatTouchAreUndecided) {
  const SubdivisionCage cube = cube_of_size(1);
  const LimitOverlap crossing = overlap(cube, cube, {.pair = {.pose_b = Pose::translation(0.5, 0.1, 0)}});
  EXPECT_TRUE(crossing.overlap);
  EXPECT_EQ(crossing.status, Status::exact);
  EXPECT_EQ(distance(cube, cube, {.pair = {.pose_b = Pose::translation(0.5, 0.1, 0)}}).upper, 0);
  // By symmetry the middle of a face is the farthest point, and two such cubes beside each other touch there.
  const LimitDistance gap = distance(cube, HalfSpace({0, 0, 3}, {0, 0, -1}), {.tolerance = 1e-9});
  const double top = 3 - gap.lower;
  const LimitOverlap touching =
      overlap(cube, cube, {.pair = {.pose_b = Pose::translation(0, 0, 2 * top)}, .tolerance = 1e-5});
  EXPECT_TRUE(touching.overlap);
  EXPECT_EQ(touching.status, Status::undecided);
  EXPECT_LE(touching.distance, 1e-5);
}

TEST(LimitPairs, OfOpenCagesAreSurfaces) {
  const SubdivisionCage sheet(sheet_cage(3, false), SubdivisionScheme::catmull_clark);
  // Parallel over their whole area, so a small tolerance would keep all faces.
  const LimitDistance found =
      distance(sheet, sheet, {.pair = {.pose_b = Pose::translation(0, 0, 0.5)}, .tolerance = 0.2});
  EXPECT_LE(found.lower, 0.5);
  EXPECT_GE(found.upper, 0.5);
  EXPECT_NE(message_of([&] { (void)overlap(sheet, sheet, {.pair = {.solid_b = Solid::all}}); }).find("has a border"),
            std::string::npos);
}

// A whole mesh so near the limit would need millions of triangles.
TEST(LimitPairs, WhatLiesWithinIsToldFromNearbyFacesAlone) {
  const SubdivisionCage cube = cube_of_size(1);
  const double top = 3 - distance(cube, HalfSpace({0, 0, 3}, {0, 0, -1}), {.tolerance = 1e-9}).lower;
  const std::size_t few = 1 << 14;
  const double radius = 0.01, gap = 1e-7;
  const auto ask = [&](double height) {
    return overlap(cube, Sphere(radius, {0, 0, height}), {.tolerance = 1e-9, .max_faces = few});
  };
  const LimitOverlap within = ask(top - radius - gap), above = ask(top + radius + gap);
  EXPECT_TRUE(within.overlap);
  EXPECT_EQ(within.status, Status::exact);
  EXPECT_FALSE(above.overlap);
  EXPECT_EQ(above.status, Status::exact);
}

// Two bodies of one mesh: the one is beside the cage, the other within.
TEST(LimitPairs, EveryPartOfAMeshIsLookedAt) {
  const SubdivisionCage cube = cube_of_size(1);
  PolygonMesh two = cube_cage();
  for (Vec3& v : two.vertices) v = 0.1 * v;
  const std::size_t count = two.vertices.size(), corners = two.corners.size();
  for (std::size_t v = 0; v < count; ++v) two.vertices.push_back(two.vertices[v] + Vec3{5, 0, 0});
  for (std::size_t c = 0; c < corners; ++c) two.corners.push_back(two.corners[c] + static_cast<Index>(count));
  for (Index f = 1; f <= 6; ++f) two.first.push_back(static_cast<Index>(corners) + 4 * f);
  const Model mesh(triangulate(two));
  for (const double at : {0.0, -5.0}) {
    EXPECT_TRUE(overlap(cube, mesh, {.pair = {.pose_b = Pose::translation(at, 0, 0)}}).overlap) << at;
    EXPECT_TRUE(overlap(cube, SubdivisionCage(two, SubdivisionScheme::catmull_clark),
                        {.pair = {.pose_b = Pose::translation(at, 0, 0)}})
                    .overlap)
        << at;
  }
  EXPECT_FALSE(overlap(cube, mesh, {.pair = {.pose_b = Pose::translation(-2.5, 0, 0)}}).overlap);
}

TEST(LeastTolerance, IsToldAtOnce) {
  PolygonMesh far = cube_cage();
  for (Vec3& v : far.vertices) v.x += 1e6;
  const SubdivisionCage cage(far, SubdivisionScheme::catmull_clark);
  const double least = least_tolerance(cage);
  EXPECT_GT(least, 1e-11);
  EXPECT_LT(least, 1e-7);
  const std::string message = message_of([&] { (void)refine(cage, {.tolerance = least / 2}); });
  EXPECT_NE(message.find("leaves"), std::string::npos) << message;
  EXPECT_GE(refine(cage, {.levels = 2}).distance_to_limit, least);
  // Flat cages of sharp edges are where they will be, but for rounding.
  const SubdivisionCage flat(sheet_cage(1, false), SubdivisionScheme::catmull_clark,
                             {.border = CageBorder::sharp_corner});
  EXPECT_GE(refine(flat, {.levels = 2}).distance_to_limit, least_tolerance(flat));
}

TEST(LimitSearch, EndsWhereOnlyRoundingIsLeft) {
  PolygonMesh far = cube_cage();
  for (Vec3& v : far.vertices) v.x += 1e8;
  const SubdivisionCage cage(far, SubdivisionScheme::catmull_clark);
  const LimitDistance found = distance(cage, HalfSpace({0, 0, 3}, {0, 0, -1}), {.tolerance = 1e-12});
  EXPECT_EQ(found.status, Status::not_converged);
  EXPECT_LT(found.upper - found.lower, 1e-4);
  EXPECT_LT(found.level, 30);
  const LimitDistance near = distance(cube_of_size(1), HalfSpace({0, 0, 3}, {0, 0, -1}), {.tolerance = 1e-10});
  EXPECT_LE(std::max(found.lower, near.lower), std::min(found.upper, near.upper));
}

}  // namespace
}  // namespace toccata::test
