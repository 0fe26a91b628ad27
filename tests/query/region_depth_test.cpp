#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "query/slow_solids.hpp"
#include "support/mesh_soups.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/query/contacts.hpp"
#include "toccata/query/penetration.hpp"
#include "toccata/query/relation.hpp"

// How deep two solids are in each other at a region: closed forms, and a slow oracle.
namespace toccata {
namespace {

constexpr double precision = 1.1 + 1e-9;

std::vector<ContactRegion> regions_of(const Model& a, const Model& b, const Pose& pose_b) {
  return contact_regions(a, b, {.pose_b = pose_b});
}

/// The bracket holds the number and is as narrow as promised.
void expect_depth(const ContactRegion& region, double exact, const std::string& what, double error = 1e-9) {
  ASSERT_TRUE(region.depth) << what;
  EXPECT_LE(region.depth->lower, exact * (1 + error)) << what;
  EXPECT_GE(region.depth->upper, exact * (1 - error)) << what;
  EXPECT_LE(region.depth->upper, precision * region.depth->lower) << what;
}

Model unit_box() { return Model(box_mesh({0.5, 0.5, 0.5})); }

/// Its top is at height 0.
Model table() { return Model(box_mesh({4, 4, 1}, {0, 0, -1})); }

TEST(RegionDepth, OfEqualBoxesIsTheWidthOfWhatTheyHaveInCommon) {
  const Model box = unit_box();
  for (const double shift : {0.999, 0.99, 0.97, 0.75, 0.5, 0.3, 0.01})
    for (int axis = 0; axis < 3; ++axis)
      for (const double sign : {-1.0, 1.0}) {
        Pose pose;
        pose.offset[axis] = sign * shift;
        const auto regions = regions_of(box, box, pose);
        ASSERT_EQ(regions.size(), 1U) << shift;
        expect_depth(regions[0], 1 - shift, std::to_string(shift));
        EXPECT_LE(regions[0].depth->upper, (1 + 1e-9) * regions[0].depth->lower) << shift;
        EXPECT_NEAR(regions[0].normal[axis], sign, 1e-9) << shift;
        EXPECT_NEAR(regions[0].area, 1, 1e-9) << shift;
      }
  const auto same = regions_of(box, box, {});
  ASSERT_EQ(same.size(), 1U);
  expect_depth(same[0], 1, "one box twice");
}

TEST(RegionDepth, OfCoplanarSidesIsThatOfTheInterface) {
  const auto regions = regions_of(unit_box(), unit_box(), Pose::translation(0.99, 0.5, 0));
  ASSERT_EQ(regions.size(), 1U);
  expect_depth(regions[0], 0.01, "shifted twice");
  EXPECT_NEAR(regions[0].area, 0.5, 1e-9);
  EXPECT_NEAR(regions[0].normal.x, 1, 1e-9);
}

TEST(RegionDepth, MovesWithTheSolids) {
  Random random(20261129);
  for (int i = 0; i < 20; ++i) {
    const Pose place{test::random_rotation(random), test::random_vector(random, 3)};
    const auto regions = contact_regions(unit_box(), unit_box(),
                                         {.pose_a = place, .pose_b = place * Pose::translation(0.95, 0.1, -0.2)});
    ASSERT_EQ(regions.size(), 1U);
    expect_depth(regions[0], 0.05, "posed");
    EXPECT_NEAR(regions[0].area, 0.9 * 0.8, 1e-9);
    EXPECT_NEAR(dot(regions[0].normal, place.linear.column(0)), 1, 1e-6);
  }
}

TEST(RegionDepth, OfACornerInAFaceIsItsHeight) {
  const double c = std::sqrt(0.5), d = std::sqrt(1.0 / 3), e = std::sqrt(1.0 / 6);
  for (const double depth : {0.25, 0.0625, 0.001}) {
    const Pose on_corner{{{Vec3{c, -c, 0}, Vec3{e, e, -2 * e}, Vec3{d, d, d}}}, {0, 0, std::sqrt(3.0) / 2 - depth}};
    const auto regions = regions_of(table(), unit_box(), on_corner);
    ASSERT_EQ(regions.size(), 1U);
    expect_depth(regions[0], depth, "a corner");
    EXPECT_NEAR(regions[0].normal.z, 1, 1e-6);
    EXPECT_NEAR(regions[0].area, 1.5 * std::sqrt(3.0) * depth * depth, 1e-9);  // of the cut cube, a triangle
  }
}

TEST(RegionDepth, OfAnEdgeInAFaceIsItsHeight) {
  const double c = std::sqrt(0.5);
  const Pose on_edge{{{Vec3{1, 0, 0}, Vec3{0, c, -c}, Vec3{0, c, c}}}, {0, 0, c - 0.03125}};
  const auto regions = regions_of(table(), unit_box(), on_edge);
  ASSERT_EQ(regions.size(), 1U);
  expect_depth(regions[0], 0.03125, "an edge");
  EXPECT_NEAR(regions[0].area, 0.0625, 1e-9);
}

TEST(RegionDepth, OfBallsIsThatOfSpheres) {
  for (const int subdivisions : {3, 5})
    for (const double overlap : {0.02, 0.1, 1.0}) {
      const Model ball(icosphere_mesh(1, subdivisions));
      const double deviation = subdivisions == 3 ? 0.02 : 0.0013;  // of one mesh from the sphere, inwards
      const auto regions = regions_of(ball, ball, Pose::translation(0.6 * (2 - overlap), 0, 0.8 * (2 - overlap)));
      if (regions.empty()) continue;
      ASSERT_EQ(regions.size(), 1U);
      EXPECT_LE(regions[0].depth->lower, overlap);
      EXPECT_GE(regions[0].depth->upper, overlap - 2 * deviation);
      EXPECT_LE(regions[0].depth->upper, precision * regions[0].depth->lower);
    }
}

TEST(RegionDepth, OfCrossedCylindersIsAlongTheirCommonNormal) {
  const Model rod(prism_mesh(0.5, 4, 64));
  const Pose across{{{Vec3{0, 0, 1}, Vec3{0, 1, 0}, Vec3{-1, 0, 0}}}, {-2, 0.95, 2}};
  const auto regions = regions_of(rod, rod, across);
  ASSERT_EQ(regions.size(), 1U);
  expect_depth(regions[0], 0.05, "crossed", 0.05);
  EXPECT_NEAR(regions[0].normal.y, 1, 0.02);
}

TEST(RegionDepth, OfARodThroughAPlateIsOnePlaceAsDeepAsTheRodIsThick) {
  const Model rod(prism_mesh(0.5, 4, 32)), plate(box_mesh({3, 3, 0.125}));
  const auto regions = regions_of(rod, plate, Pose::translation(0, 0, 2));
  ASSERT_EQ(regions.size(), 1U);
  expect_depth(regions[0], 0.5 * std::cos(std::acos(-1.0) / 32) + 0.125, "rod", 1e-6);
  EXPECT_TRUE(regions[0].closed);
}

TEST(RegionDepth, OfARectangularRodThroughAPlateHasTheAreaAcrossBoth) {
  const double w = 2, d = 4, t = 1, slanted = std::sqrt(w * w + t * t);
  const Model rod(box_mesh({w / 2, d / 2, 5})), plate(box_mesh({9, 9, t / 2}));
  const auto regions = regions_of(rod, plate, {});
  ASSERT_EQ(regions.size(), 1U);
  expect_depth(regions[0], (w + t) / 2, "rod", 1e-9);
  EXPECT_NEAR(std::abs(regions[0].normal.x), w / slanted, 1e-9);
  EXPECT_NEAR(regions[0].normal.y, 0, 1e-9);
  EXPECT_NEAR(std::abs(regions[0].normal.z), t / slanted, 1e-9);
  EXPECT_NEAR(regions[0].area, 2 * w * d * t / slanted, 1e-9);
}

TEST(RegionDepth, OfAPressFitIsWhatThePinIsTooThick) {
  const TriangleMesh pin = prism_mesh(0.5, 2, 48);
  const Model block(negative_image(pin, 1));
  const double thicker = 1.1, apothem = 0.5 * std::cos(std::acos(-1.0) / 48);
  const Pose pose{{{Vec3{thicker, 0, 0}, Vec3{0, thicker, 0}, Vec3{0, 0, 0.5}}}, {0, 0, 0.5}};
  const auto regions = regions_of(block, Model(pin), pose);
  ASSERT_EQ(regions.size(), 1U);
  ASSERT_TRUE(regions[0].depth);
  EXPECT_LE(regions[0].depth->lower, 0.05);
  EXPECT_GE(regions[0].depth->upper, 0.1 * apothem - 1e-9);
  EXPECT_LE(regions[0].depth->upper, precision * regions[0].depth->lower);
}

TEST(RegionDepth, OfABoxTooWideForItsChannelIsThatOfEachSide) {
  const std::vector<Vec2> outline = {{-2, -1}, {2, -1}, {2, 2}, {1, 2}, {1, 0}, {-1, 0}, {-1, 2}, {-2, 2}};
  const auto regions =
      regions_of(Model(extruded_mesh(outline, 4)), Model(box_mesh({1.05, 0.9, 0.9})), Pose::translation(0, 1.2, 2));
  ASSERT_EQ(regions.size(), 2U);
  for (const ContactRegion& region : regions) {
    expect_depth(region, 0.05, "a side");
    EXPECT_NEAR(std::abs(region.normal.x), 1, 1e-9);
    EXPECT_NEAR(region.area, 1.7 * 1.8, 1e-9);
  }
  EXPECT_NEAR(regions[0].normal.x, -regions[1].normal.x, 1e-9);
}

TEST(RegionDepth, OfTouchingSolidsIsNone) {
  const auto flat = regions_of(table(), unit_box(), Pose::translation(0.3, 0.2, 0.5));
  ASSERT_EQ(flat.size(), 1U);
  EXPECT_EQ(flat[0].depth, (ContactRegion::Depth{0, 0}));
  EXPECT_NEAR(flat[0].area, 1, 1e-12);
  EXPECT_NEAR(flat[0].normal.z, 1, 1e-12);
  const auto edge = regions_of(unit_box(), unit_box(), Pose::translation(1, 1, 0));
  ASSERT_EQ(edge.size(), 1U);
  EXPECT_EQ(edge[0].depth, (ContactRegion::Depth{0, 0}));
  EXPECT_NEAR(edge[0].area, 0, 1e-12);
}

TEST(RegionDepth, OfSolidsThatTouchInOnePlaceAndOverlapInAnotherIsThatOfEach) {
  const std::vector<Vec2> outline = {{0, 0}, {1, 0}, {1, 2}, {3, 2}, {3, 0.25}, {4, 0.25}, {4, 3}, {0, 3}};
  const Model floor(box_mesh({9, 1, 9})), bench(extruded_mesh(outline, 0.5));
  const auto regions = regions_of(floor, bench, Pose::translation(0, 0.75, 0));
  ASSERT_EQ(regions.size(), 2U);
  expect_depth(regions[0], 0.25, "the long leg");
  EXPECT_EQ(regions[1].depth->lower, 0);
  EXPECT_LE(regions[1].depth->upper, 1e-10);
  EXPECT_NEAR(regions[1].area, 0.5, 1e-12);
}

TEST(RegionDepth, HoldsWhatASlowOracleFindsForRandomSolids) {
  Random random(11292026);
  const std::vector<TriangleMesh> meshes = test::some_solids();
  int seen = 0, wide = 0;
  for (int i = 0; i < 120; ++i) {
    const TriangleMesh &mesh_a = meshes[random.below(meshes.size())], &mesh_b = meshes[random.below(meshes.size())];
    const Model a(mesh_a), b(mesh_b);
    const PairQuery query{.pose_a = {test::random_rotation(random), {}},
                          .pose_b = {test::random_rotation(random), test::random_vector(random, 1.3)}};
    const test::SlowSolid slow_a(mesh_a, query.pose_a), slow_b(mesh_b, query.pose_b);
    for (const ContactRegion& region : contact_regions(a, b, query)) {
      ++seen;
      ASSERT_TRUE(region.depth);
      const double most = region.depth->upper;
      wide += most > precision * region.depth->lower ? 1 : 0;
      EXPECT_GE(slow_a.distance(region.deepest) + slow_b.distance(region.deepest),
                region.depth->lower * (1 - 1e-9) - 1e-12)
          << i;
      for (int k = 0; k < 60; ++k) {
        Vec3 p;
        for (int axis = 0; axis < 3; ++axis) p[axis] = random.between(region.box.lower[axis], region.box.upper[axis]);
        if (slow_a.holds(p) && slow_b.holds(p)) {
          EXPECT_LE(slow_a.distance(p) + slow_b.distance(p), most * (1 + 1e-9) + 1e-12) << i;
        }
      }
    }
  }
  EXPECT_GT(seen, 60);
  EXPECT_EQ(wide, 0);
}

TEST(RegionDepth, IsThatOfThePointsOfItsOwnBox) {
  // Beside the boxes of some of these regions, within a turned box around them, are deeper points of others.
  for (const std::uint64_t seed : {12596323584061756495ULL, 7086638178683056257ULL}) {
    Random random(seed);
    const test::Meeting made = test::random_meeting(test::some_solids(), random);
    const test::SlowSolid slow_a(made.a, made.query.pose_a), slow_b(made.b, made.query.pose_b);
    const auto regions = contact_regions(Model(made.a), Model(made.b), made.query);
    EXPECT_GE(regions.size(), 2U);
    for (const ContactRegion& region : regions) {
      EXPECT_TRUE(contains(region.box, Aabb{region.deepest, region.deepest})) << seed;
      EXPECT_GE(slow_a.distance(region.deepest) + slow_b.distance(region.deepest), region.depth->lower * (1 - 1e-9));
      EXPECT_LE(region.depth->upper, precision * region.depth->lower) << seed;
    }
  }
}

TEST(RegionDepth, OfAThinWedgeIsThatOfItsEdge) {
  Random random(20261130);
  const double thin = 1e-5;
  const Model wedge(extruded_mesh(std::vector<Vec2>{{0, 0}, {2, -thin}, {2, thin}}, 4)), block(box_mesh({1, 1, 1}));
  for (int i = 0; i < 20; ++i) {
    const Pose place{test::random_rotation(random), test::random_vector(random, 1)};
    const auto regions =
        contact_regions(wedge, block, {.pose_a = place * Pose::translation(0.2, 0.1, -2), .pose_b = place});
    ASSERT_EQ(regions.size(), 1U) << i;
    expect_depth(regions[0], 0.8, "an edge 0.8 below the block's side", 2 * thin);
  }
}

TEST(RegionDepth, IsALowerBoundOfThePenetration) {
  Random random(5);
  const std::vector<TriangleMesh> meshes = test::some_solids();
  for (int i = 0; i < 60; ++i) {
    const Model a(meshes[random.below(meshes.size())]), b(meshes[random.below(meshes.size())]);
    const PairQuery query{.pose_b = {test::random_rotation(random), test::random_vector(random, 1.2)}};
    for (const ContactRegion& region : contact_regions(a, b, query))
      for (int k = 0; k < 8; ++k) {
        const Vec3 v = test::random_vector(random, 1);
        const Vec3 way = k == 0 ? region.normal : (1 / std::sqrt(dot(v, v))) * v;
        PairQuery moved = query;
        moved.pose_b.offset = moved.pose_b.offset + (0.999 * region.depth->lower) * way;
        if (region.depth->lower > 1e-9) {
          EXPECT_EQ(relation(a, b, moved).kind, RelationKind::overlapping) << i;
        }
      }
  }
  const Model gear(gear_mesh({}));
  const PairQuery mesh_of_teeth{.pose_b = Pose::translation(1.95, 0, 0.02)};
  const Penetration whole = penetration(gear, gear, mesh_of_teeth);
  for (const ContactRegion& region : contact_regions(gear, gear, mesh_of_teeth))
    EXPECT_LE(region.depth->lower, whole.upper);
}

TEST(RegionDepth, IsTheSameForTheOtherOrderAndOnManyThreads) {
  Random random(6);
  const std::vector<TriangleMesh> meshes = test::some_solids();
  for (int i = 0; i < 60; ++i) {
    const Model a(meshes[random.below(meshes.size())]), b(meshes[random.below(meshes.size())]);
    PairQuery query{.pose_a = {test::random_rotation(random), {}},
                    .pose_b = {test::random_rotation(random), test::random_vector(random, 1.2)}};
    const auto regions = contact_regions(a, b, query);
    const auto other = contact_regions(b, a, {.pose_a = query.pose_b, .pose_b = query.pose_a});
    ASSERT_EQ(other.size(), regions.size()) << i;
    for (std::size_t k = 0; k < regions.size(); ++k) {
      EXPECT_EQ(other[k].depth, regions[k].depth) << i;
      EXPECT_EQ(other[k].deepest, regions[k].deepest) << i;
      EXPECT_EQ(other[k].box, regions[k].box) << i;
      EXPECT_NEAR(dot(other[k].normal, regions[k].normal), -1, 1e-9) << i;
      EXPECT_NEAR(other[k].area, regions[k].area, 1e-9) << i;
    }
    query.threads = 3;
    EXPECT_EQ(contact_regions(a, b, query), regions) << i;
  }
}

}  // namespace
}  // namespace toccata
