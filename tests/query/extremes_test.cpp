#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/mesh_soups.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/narrow/posed_shapes.hpp"
#include "toccata/query/contacts.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/query/distance_cache.hpp"
#include "toccata/query/nearest.hpp"
#include "toccata/query/penetration.hpp"
#include "toccata/query/self_contacts.hpp"
#include "toccata/query/signed_distance.hpp"

// Sizes near the ends of the doubles, and solids that are inside out.
namespace toccata {
namespace {

TriangleMesh cube(double size) { return box_mesh({0.5 * size, 0.5 * size, 0.5 * size}); }

TriangleMesh inside_out(const TriangleMesh& mesh) {
  std::vector<std::array<Index, 3>> triangles;
  for (const auto& [i, j, k] : mesh.triangles()) triangles.push_back({j, i, k});
  return {{mesh.vertices().begin(), mesh.vertices().end()}, triangles};
}

/// By a power of two, which rounds nothing.
Pose enlarged(const Pose& pose, double factor) {
  std::array<double, 12> numbers = pose.numbers();
  for (double& number : numbers) number *= factor;
  return Pose::from_numbers(numbers);
}

TEST(Extremes, DistancesOfEnlargedMeshesAreEnlarged) {
  const Model a(torus_mesh({.radius = 1, .tube_radius = 0.25})), b(icosphere_mesh(0.7, 2));
  for (const double degrees : {17.0, 80.0, 143.0}) {
    PairQuery query;
    query.pose_a = {rotation_about({1, 2, 3}, degrees), {0.125, 0, 0.5}};
    query.pose_b = {rotation_about({3, -1, 1}, 2 * degrees), {1.5, 1, 2}};
    const Distance plain = distance(a, b, query);
    for (const int power : {-300, -100, 250, 256, 270, 300}) {
      const double factor = std::ldexp(1.0, power);
      const PairQuery larger{.pose_a = enlarged(query.pose_a, factor), .pose_b = enlarged(query.pose_b, factor)};
      const Distance found = distance(a, b, larger);
      EXPECT_LE(found.lower / factor, plain.upper) << power << ", " << degrees;
      EXPECT_GE(found.upper / factor, plain.lower) << power << ", " << degrees;
      EXPECT_LE(found.upper - found.lower, 1e-12 * found.upper) << power << ", " << degrees;
      EXPECT_TRUE(within_distance(a, b, plain.upper * factor * (1 + 1e-9), larger)) << power << ", " << degrees;
    }
  }
}

/// Nothing can be subtracted there, in trees or blocks: pairs that only exact arithmetic told apart took minutes.
TEST(Extremes, ContactsAtTheGreatestDoublesAreThoseOfSmallMeshes) {
  const Model torus(torus_mesh({.radius = 1, .tube_radius = 0.25}));
  const Pose turned{rotation_about({1, 2, 3}, 30), {0.125, 0, 0.0625}};
  const double factor = std::ldexp(1.0, 1023);
  const PairQuery plain{.pose_b = turned}, huge{.pose_a = enlarged(Pose{}, factor), .pose_b = enlarged(turned, factor)};
  const std::vector<Contact> few = contacts(torus, torus, plain), many = contacts(torus, torus, huge);
  ASSERT_EQ(few.size(), many.size());
  EXPECT_GT(few.size(), 10U);
  for (std::size_t i = 0; i < few.size(); ++i) {
    EXPECT_EQ(few[i].element_a, many[i].element_a);
    EXPECT_EQ(few[i].element_b, many[i].element_b);
  }
  EXPECT_EQ(self_contacts(torus, enlarged(Pose{}, factor)).size(), self_contacts(torus, Pose{}).size());
}

/// The least of all pairs of triangles.
Distance least_of_all_pairs(const TriangleMesh& a, const TriangleMesh& b, const Pose& pose_b) {
  const std::vector<Vec3> world_b = transform(pose_b, b.vertices());
  Distance least;
  least.upper = HUGE_VAL;
  for (const auto& [i, j, k] : a.triangles())
    for (const auto& [l, m, n] : b.triangles()) {
      const Distance one = distance(Triangle{{a.vertices()[i], a.vertices()[j], a.vertices()[k]}},
                                    Triangle{{world_b[l], world_b[m], world_b[n]}});
      if (one.upper < least.upper) least = one;
    }
  return least;
}

TEST(Extremes, DistancesToFarLargerMeshesAreThoseOfTheirTriangles) {
  Random random(11);
  for (const int power : {30, 140, 250, 256, 270, 309})
    for (int round = 0; round < 6; ++round) {
      const TriangleMesh a = test::random_soup(random, 12, 0.2, 0), b = test::random_soup(random, 60, 0.2, 0);
      const Pose pose = enlarged({rotation_about({3, -1, 1}, 30.0 * round), {1.5, 1, -0.5}}, std::ldexp(1.0, power));
      const Distance found = distance(Model(a), Model(b), {.pose_b = pose}), least = least_of_all_pairs(a, b, pose);
      EXPECT_EQ(found.upper, least.upper) << "2^" << power << ", round " << round;
      EXPECT_LE(found.lower, least.upper) << "2^" << power << ", round " << round;
    }
}

TEST(Extremes, ACacheSeesTinyMeshesMove) {
  for (const double size : {1e-165}) {
    const Model a(cube(size)), b(cube(0.1 * size));
    DistanceCache cache;
    for (const double x : {0.0, 5.0, 0.0}) {
      PairQuery query;
      query.pose_b.offset = {x * size, 0, 0};
      EXPECT_EQ(distance(a, b, query, cache), distance(a, b, query)) << size << ", " << x;
    }
  }
}

TEST(Extremes, WhatIsWithinTheGreatestDistanceIsFoundOfAnySize) {
  for (const double size : {1e-160, 1.0, 1e160, 1e298}) {
    const Model mesh(icosphere_mesh(size, 1));
    const std::optional<SurfacePoint> found =
        nearest_point({3 * size, 0, 0}, mesh, {.pose = {}, .max_distance = 2.5 * size});
    EXPECT_TRUE(found) << size;
    EXPECT_EQ(found, nearest_point({3 * size, 0, 0}, mesh)) << size;
    EXPECT_NEAR(found->upper / size, 2, 0.05) << size;
  }
}

TEST(Extremes, RegionsDoNotDependOnSizeOrOrientation) {
  for (const double size : {1e-100, 1e-90, 1.0, 1e90, 1e100})
    for (const bool a_turned : {false, true})
      for (const bool b_turned : {false, true}) {
        const Model a(a_turned ? inside_out(cube(size)) : cube(size)),
            b(b_turned ? inside_out(cube(size)) : cube(size));
        PairQuery query;
        query.pose_b.offset = {0.4 * size, 0.3 * size, 0.45 * size};
        const auto regions = contact_regions(a, b, query);
        ASSERT_EQ(regions.size(), 1U) << size;
        EXPECT_TRUE(regions[0].closed) << size;
        EXPECT_NEAR(regions[0].normal.z, 1, 1e-9) << size;
        EXPECT_NEAR(regions[0].area / size / size, 0.42, 1e-9) << size;
        ASSERT_TRUE(regions[0].depth) << size;
        EXPECT_NEAR(regions[0].depth->lower / size, 0.55, 1e-9) << size;
        EXPECT_NEAR(regions[0].depth->upper / size, 0.55, 1e-9) << size;
      }
}

TEST(Extremes, AMirroredSolidIsNoOtherThanItsImage) {
  const Model a(cube(1)), b(cube(1));
  PairQuery query;
  query.pose_b = {Mat3{{Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}}, {0.4, 0.3, 0.45}};
  const auto regions = contact_regions(a, b, query);
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_NEAR(regions[0].normal.z, 1, 1e-9);
  EXPECT_NEAR(regions[0].area, 0.42, 1e-9);
}

TEST(Extremes, TouchingSolidsAreNotDeepInEachOther) {
  PairQuery query;
  query.pose_b.offset = {1, 1, 0};
  const auto regions = contact_regions(Model(cube(1)), Model(cube(1)), query);
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_EQ(regions[0].depth, (ContactRegion::Depth{0, 0}));
}

TEST(Extremes, AHalfSpaceMayHaveALongNormal) {
  for (const double length : {1e-200, 1.0, 1e155, 1e200})
    for (const double gap : {0.25, 2.0, 1000.0}) {
      PairQuery query;
      query.pose_a.offset = {0, 0, 0.5 + gap};
      const HalfSpace ground({0, 0, 0}, {0, 0, length});
      EXPECT_TRUE(within_distance(Model(cube(1)), ground, gap, query)) << length << ", " << gap;
      EXPECT_FALSE(within_distance(Model(cube(1)), ground, std::nextafter(gap, 0.0), query)) << length << ", " << gap;
    }
}

TEST(Extremes, AWindingNumberThatIsToldExactIsWithinItsTolerance) {
  const Model mesh(cube(1));
  for (const double tolerance : {1e-2, 1e-13, 2e-14, 1.6969e-14, 1e-14})
    for (const double x : {0.1, 0.4, 0.7}) {
      const WindingNumber w = generalized_winding_number({x, 0.2, 0.1}, mesh, {}, {tolerance});
      const double reach = std::max(w.upper - w.value, w.value - w.lower);
      EXPECT_TRUE(w.status != Status::exact || reach <= tolerance * (1 + 1e-15)) << tolerance << ", " << x;
    }
}

TEST(Extremes, PenetrationOfCompoundsIsThatOfTheExchangedOnes) {
  const auto part = [](double degrees) {
    const std::vector<CompoundPart> parts{{Box({0.5, 0.2, 0.3}), {rotation_about({0, 0, 1}, degrees), {}}},
                                          {Sphere(0.6), {}}};
    return Model(Compound(parts));
  };
  const Model a = part(30), b = part(-30);
  PairQuery query, other;
  query.pose_b.offset = other.pose_a.offset = {0.3, 0.1, 0};
  EXPECT_EQ(penetration(a, b, query), flipped(penetration(b, a, other)));
}

TEST(Extremes, PenetrationOfTinyAndHugeSolidsEnds) {
  for (const double size : {1e-160, 1e99}) {
    PairQuery query;
    query.pose_b.offset = {0.9 * size, 0, 0};
    const Penetration depth =
        penetration(Model(torus_mesh({.radius = size, .tube_radius = 0.4 * size, .around = 6, .sides = 4})),
                    Model(cube(size)), query);
    EXPECT_LE(depth.lower, depth.upper) << size;
    EXPECT_GT(depth.upper, 0) << size;
  }
}

}  // namespace
}  // namespace toccata
