#include "toccata/query/contacts.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "toccata/core/error.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/query/batch.hpp"

// Regions of contact whose areas, normals and depths are known.
namespace toccata {
namespace {

std::vector<ContactRegion> regions_of(const TriangleMesh& a, const TriangleMesh& b, const Pose& pose_b) {
  return contact_regions(Model(a), Model(b), {.pose_b = pose_b});
}

/// A table whose top is at height 0.
TriangleMesh table() { return box_mesh({4, 4, 1}, {0, 0, -1}); }

/// Three legs below z = 1, the lowest at x = 2.
TriangleMesh stool() {
  std::vector<Vec2> outline = {{-2.25, 0}, {-1.75, 0}, {-1.75, 1},   {-0.25, 1},   {-0.25, -0.25}, {0.25, -0.25},
                               {0.25, 1},  {1.75, 1},  {1.75, -0.5}, {2.25, -0.5}, {2.25, 2},      {-2.25, 2}};
  return extruded_mesh(outline, 0.5);
}

/// Turns y upwards: the extruded outline stands.
Pose standing(double height) { return {{{Vec3{1, 0, 0}, Vec3{0, 0, -1}, Vec3{0, 1, 0}}}, {0.125, 0.0625, height}}; }

TEST(ContactRegions, OfABoxPressedIntoATable) {
  const auto regions = regions_of(table(), box_mesh({0.5, 0.5, 0.5}), Pose::translation(0.3, 0.2, 0.375));
  ASSERT_EQ(regions.size(), 1U);
  const ContactRegion& region = regions[0];
  EXPECT_TRUE(region.closed);
  EXPECT_NEAR(region.area, 1, 1e-12);
  EXPECT_NEAR(region.normal.z, 1, 1e-12);
  ASSERT_TRUE(region.depth);
  EXPECT_NEAR(region.depth->lower, 0.125, 1e-12);
  EXPECT_NEAR(region.depth->upper, 0.125, 1e-12);
  EXPECT_LE(region.deepest.z, 0);
  EXPECT_GE(region.deepest.z, -0.125);
  EXPECT_EQ(region.box.lower.x, 0.3 - 0.5);
  const auto other = regions_of(box_mesh({0.5, 0.5, 0.5}, {0.3, 0.2, 0.375}), table(), {});
  ASSERT_EQ(other.size(), 1U);
  EXPECT_NEAR(other[0].area, 1, 1e-12);
  EXPECT_NEAR(other[0].normal.z, -1, 1e-12);
  EXPECT_EQ(other[0].depth, region.depth);
}

TEST(ContactRegions, AreThoseOfEachLegTheDeepestFirst) {
  const auto regions = regions_of(table(), stool(), standing(-0.125));
  ASSERT_EQ(regions.size(), 3U);
  const std::vector<double> depths = {0.625, 0.375, 0.125}, middles = {2.125, 0.125, -1.875};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LE(regions[i].depth->lower, depths[i] * (1 + 1e-12));
    EXPECT_GE(regions[i].depth->upper, depths[i]);
    EXPECT_LE(regions[i].depth->upper, 1.1 * regions[i].depth->lower);
    EXPECT_NEAR((regions[i].box.lower.x + regions[i].box.upper.x) / 2, middles[i], 1e-12);
    EXPECT_NEAR(regions[i].area, 0.25, 1e-12);
    EXPECT_TRUE(regions[i].closed);
  }
}

TEST(ContactRegions, OfFacesThatLieOnEachOtherAreTheirCommonArea) {
  const auto regions = regions_of(table(), box_mesh({0.5, 0.5, 0.5}), Pose::translation(0.3, 0.2, 0.5));
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_FALSE(regions[0].closed);
  EXPECT_NEAR(regions[0].area, 1, 1e-12);
  EXPECT_NEAR(regions[0].normal.z, 1, 1e-12);
  EXPECT_GE(regions[0].point_count, 4U);
  EXPECT_EQ(regions[0].depth, (ContactRegion::Depth{0, 0}));
}

// A triangle of the table is in contact with hundreds.
TEST(ContactRegions, OfManySidesOnOneTriangleHaveTheAreaOfThePolygon) {
  const int sides = 600;
  const double area = 0.5 * sides * std::sin(2 * std::acos(-1.0) / sides);
  for (const double depth : {0.0, 0.125}) {
    const auto regions = regions_of(table(), prism_mesh(1, 1, sides), Pose::translation(0.3, 0.2, -depth));
    ASSERT_EQ(regions.size(), 1U);
    EXPECT_NEAR(regions[0].area, area, 1e-9) << depth;
    EXPECT_NEAR(regions[0].normal.z, 1, 1e-9) << depth;
    EXPECT_NEAR(regions[0].depth->lower, depth, 1e-9);
    EXPECT_NEAR(regions[0].depth->upper, depth, 1e-9);
  }
}

// The corner of a box lies on the bottom of a prism, but for what rounding does to the turned bottom: on either side of
// it by some 10⁻¹⁷, while the triangles at the corner lie on one side or the other as a whole.
TEST(ContactRegions, OfACornerThatRoundingPutsBesideAFaceHaveTheAreaOfOneNearby) {
  const Model prism(prism_mesh(0.8, 1.2, 5)), box(box_mesh({1, 0.5, 0.5}));
  int compared = 0;
  for (int k = 0; k < 60; ++k) {
    const Pose pose_a = Pose::rotation({1, 0.3 * k, 2}, 7.0 * k),
               pose_b = Pose::rotation({0.2 * k, 1, 1}, 11.0 * k) * Pose::translation(1, 0.5, 0.5);
    const auto regions = contact_regions(prism, box, {.pose_a = pose_a, .pose_b = pose_b});
    const auto nearby =
        contact_regions(prism, box, {.pose_a = pose_a, .pose_b = Pose::translation(1e-9, -1e-9, 2e-9) * pose_b});
    // They may merely touch there; and which of the deep points is found may differ, and the direction with it, along
    // which the area is seen.
    if (regions.size() != 1 || nearby.size() != 1 || !(dot(regions[0].normal, nearby[0].normal) > 1 - 1e-12)) continue;
    ++compared;
    EXPECT_NEAR(regions[0].area, nearby[0].area, 1e-6) << k;
  }
  EXPECT_GT(compared, 20);
}

TEST(ContactRegions, OfSurfacesHaveNoDepth) {
  const TriangleMesh sheet({{-4, -4, 0}, {4, -4, 0}, {0, 4, 0}}, {{0, 1, 2}});
  const auto regions = regions_of(sheet, box_mesh({0.5, 0.5, 0.5}), Pose::translation(0.3, -0.2, 0.125));
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_TRUE(regions[0].closed);
  EXPECT_NEAR(regions[0].area, 1, 1e-12);
  EXPECT_FALSE(regions[0].depth);
}

/// A sheet around a box of these half extents, on its four sides, each of which has an edge somewhere in its middle.
TriangleMesh sleeve_around(double x, double y) {
  const std::vector<Vec2> outline = {{-x, -y}, {0.1 * x, -y}, {x, -y}, {x, 0.3 * y},
                                     {x, y},   {-0.7 * x, y}, {-x, y}, {-x, -0.2 * y}};
  const auto count = static_cast<Index>(outline.size());
  std::vector<Vec3> vertices;
  std::vector<std::array<Index, 3>> triangles;
  for (Index i = 0; i < count; ++i) {
    const Index here = 2 * i, next = 2 * ((i + 1) % count);
    for (const double z : {-0.37, 0.41}) vertices.push_back({outline[i].x, outline[i].y, z});
    triangles.push_back({here, next, next + 1});
    triangles.push_back({here, next + 1, here + 1});
  }
  return {vertices, triangles};
}

TEST(ContactRegions, OfWhatIsHeldFromAllSidesHaveNoNormal) {
  const TriangleMesh box = box_mesh({0.3, 0.7, 1.1}), sleeve = sleeve_around(0.3, 0.7);
  for (const bool box_first : {true, false}) {
    const auto regions = box_first ? regions_of(box, sleeve, {}) : regions_of(sleeve, box, {});
    ASSERT_EQ(regions.size(), 1U);
    EXPECT_EQ(regions[0].normal, Vec3{});
    EXPECT_EQ(regions[0].area, 0);
  }
}

TEST(ContactRegions, CountEveryContactOnce) {
  const Model a(torus_mesh({})), b(noise_sphere_mesh({.subdivisions = 2}));
  const PairQuery query{.pose_b = Pose::translation(0.75, 0.25, 0.5)};
  std::size_t pairs = 0;
  const auto regions = contact_regions(a, b, query);
  for (const ContactRegion& region : regions) pairs += region.triangle_pairs;
  EXPECT_EQ(pairs, contacts(a, b, query).size());
  const auto other = contact_regions(b, a, {.pose_a = query.pose_b});
  ASSERT_EQ(other.size(), regions.size());
  for (std::size_t i = 0; i < regions.size(); ++i) {
    EXPECT_NEAR(other[i].area, regions[i].area, 1e-9);
    EXPECT_NEAR(dot(other[i].normal, regions[i].normal), -1, 1e-9);
    EXPECT_EQ(other[i].depth, regions[i].depth);
  }
}

TEST(ContactRegions, AreRefusedForOtherShapes) {
  EXPECT_THROW(static_cast<void>(contact_regions(Model(table()), Sphere(1))), Error);
  EXPECT_TRUE(regions_of(table(), table(), Pose::translation(0, 0, 9)).empty());
}

TEST(ContactRegions, OfManyPosesAreThoseOfEach) {
  const Model legs(stool()), floor(table());
  std::vector<PairQuery> queries;
  std::vector<ModelPair> pairs;
  for (int i = 0; i < 40; ++i) {
    queries.push_back({.pose_a = standing(0.02 * i), .pose_b = {}});
    pairs.push_back({floor, legs, {.pose_a = {}, .pose_b = standing(0.02 * i)}});
  }
  const auto of_poses = contact_regions_each({legs, floor, queries}, {.threads = 3});
  EXPECT_EQ(of_poses, contact_regions_each({legs, floor, queries}, {.threads = 1}));
  const auto of_pairs = contact_regions_each(pairs, {.threads = 3});
  ASSERT_EQ(of_pairs.size(), pairs.size());
  std::size_t regions = 0;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    ASSERT_EQ(of_poses[i], contact_regions(legs, floor, queries[i])) << i;
    ASSERT_EQ(of_pairs[i], contact_regions(floor, legs, pairs[i].query)) << i;
    regions += of_poses[i].size();
  }
  EXPECT_GE(regions, 40U);
  const std::vector<ModelPair> wrong{pairs[0], {Model(Sphere(1)), legs, {}}};
  EXPECT_THROW(static_cast<void>(contact_regions_each(wrong)), Error);
}

}  // namespace
}  // namespace toccata
