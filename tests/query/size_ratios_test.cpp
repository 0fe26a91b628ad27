#include "support/size_ratios.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "oracle/rational.hpp"
#include "query/mesh_casts_checks.hpp"
#include "query/meshes/world_search.hpp"
#include "support/mesh_distances.hpp"
#include "support/mesh_pairs.hpp"
#include "support/mesh_soups.hpp"
#include "support/simd_levels.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/query/casts.hpp"
#include "toccata/query/contacts.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/query/overlap.hpp"

namespace toccata::test {
namespace {

using oracle::exact;
using oracle::Rational;

/// How far outside of the region a point is along the axis for which it is most so; 1 is the edge of its reach.
double most_outside(const WideProbe& probe, const WideBvh& tree, const Vec3& point) {
  double most = 0;
  for (std::size_t i = 0; i < probe.count; ++i) {
    const WideProbe::Axis& axis = probe.axes[i];
    Rational at = exact(0.0);
    for (int k = 0; k < 3; ++k)
      at += exact(static_cast<double>(axis.form.own[static_cast<std::size_t>(k)])) *
            Rational((exact(point[k]) - exact(tree.origin[k])) / exact(tree.unit));
    const Rational off = at - exact(static_cast<double>(axis.at));
    const Rational size = off < exact(0.0) ? Rational(-off) : off;
    most = std::max(most, static_cast<double>(Rational(size / exact(static_cast<double>(axis.reach)))));
  }
  return most;
}

TEST(SizeRatios, ATriangleHoldsItsCornersAsARegion) {
  double most = 0;
  for (const std::string& family : test::pose_families())
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      Random random(seed);
      const TriangleMesh soup = test::random_soup(random, 3, 0.5, 0);
      const PosedMesh mesh(Model(soup), test::random_poses(family, random).pose_a);
      // One corner of the triangle is a world vertex of the mesh.
      Triangle triangle = mesh.triangle(0);
      const double reach = test::random_vector(random, 1).x;
      triangle.vertex[1] = triangle[0] + reach * test::random_vector(random, 1);
      triangle.vertex[2] = triangle[0] + reach * test::random_vector(random, 1);
      const Vec3 local = soup.vertices()[soup.triangles()[0][0]];
      const double outside = most_outside(probe_of(mesh, triangle), mesh.model().wide_bvh(), local);
      EXPECT_LE(outside, 1) << family << ", seed " << seed;
      most = std::max(most, outside);
    }
  EXPECT_GT(most, 0.99) << "the region is far too large";
}

TEST(SizeRatios, AreAsBruteForceAtEveryLevelAndThreadCount) {
  int met = 0;
  for (const std::string& family : test::pose_families())
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      SCOPED_TRACE(family + ", seed " + std::to_string(seed));
      Random random(seed);
      const test::UnlikeSizes pair = test::random_unlike_sizes(family, random);
      const std::vector<Contact> expected = test::contacts_by_brute_force(pair.large, pair.small, pair.query);
      met += expected.empty() ? 0 : 1;
      Workspace workspace;
      std::vector<WalkCounts> counts;
      test::at_every_simd_level([&](SimdLevel) {
        PairQuery query = pair.query;
        for (const int threads : {1, 2}) {
          query.threads = threads;
          const std::span<const Contact> found = contacts(pair.large, pair.small, query, workspace);
          EXPECT_TRUE(test::same({found.begin(), found.end()}, expected));
          counts.push_back(workspace.counts());
        }
        for (const WalkCounts& count : counts) EXPECT_EQ(count, counts.front());
        EXPECT_EQ(overlap(pair.large, pair.small, query, workspace), !expected.empty());
        EXPECT_EQ(overlap(pair.small, pair.large, test::exchanged(query), workspace), !expected.empty());
      });
    }
  EXPECT_GT(met, 20);
}

TEST(SizeRatios, DistancesAreThoseOfThePairs) {
  for (const std::string& family : test::pose_families())
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      Random random(seed);
      const test::UnlikeSizes pair = test::random_unlike_sizes(family, random);
      EXPECT_EQ(test::fault_of_surface_distance(pair.large, pair.small, pair.query), "") << family << ", seed " << seed;
    }
}

TEST(SizeRatios, CastsAreThoseOfThePairs) {
  for (const std::string& family : test::pose_families())
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      Random random(seed);
      const test::UnlikeSizes pair = test::random_unlike_sizes(family, random);
      const Vec3 motion = test::random_vector(random, 3 * pair.ratio);
      EXPECT_EQ(test::mesh_cast_fault(pair.large, motion, pair.small, pair.query), "") << family << ", seed " << seed;
    }
}

TEST(SizeRatios, ATriangleWithoutAreaIsToldFromBoxesBesideIt) {
  const Model ball(scaled_mesh(icosphere_mesh(1, 5), 1e-2));
  Workspace workspace;
  for (const Vec3& end : {Vec3{1, 0, 0}, Vec3{1, 1, 0}}) {
    const Model needle(TriangleMesh({{0, 0, 0}, 0.5 * end, end}, {{0, 1, 2}}));
    const PairQuery query{Pose{}, Pose::translation(0.5, 0.0, 0.009), Solid::none, Solid::none};
    EXPECT_EQ(overlap(needle, ball, query, workspace), end.y == 0);
    EXPECT_LT(workspace.counts().items, 4000U);
  }
}

/// Boxes and pairs of triangles that a yes or no about a small ball just above or just within a slanted face takes.
WalkCounts counts_of_small_ball(double ratio, double height) {
  const Model floor(TriangleMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 3, 2}}));
  const Model ball(scaled_mesh(icosphere_mesh(1, 5), ratio));
  const Mat3 turn = rotation_about({0.6, 0.8, 0}, 40);
  const Pose above{Mat3{}, {0.3, 0.3, height * ratio}};
  Workspace workspace;
  const PairQuery query{{turn, {}}, Pose{turn, {}} * above, Solid::none, Solid::none};
  EXPECT_EQ(overlap(floor, ball, query, workspace), height < 1);
  return workspace.counts();
}

TEST(SizeRatios, AQuestionDoesNotGrowWithTheRatio) {
  // The box of the slanted triangle holds all of the ball, 20,480 triangles, however far its surface is from them.
  for (const double ratio : {1e-1, 1e-2, 1e-3, 1e-6})
    for (const double height : {1.001, 0.999, 0.5}) {
      const WalkCounts counts = counts_of_small_ball(ratio, height);
      EXPECT_LT(counts.volume_tests, 1000U) << ratio << ", " << height;
      EXPECT_LT(counts.items, 300U) << ratio << ", " << height;
    }
}

TEST(SizeRatios, ACastDoesNotGrowWithTheRatio) {
  // The ball flies along a slanted triangle whose box it does not leave.
  const Model floor(TriangleMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}));
  const Mat3 turn = rotation_about({0.6, 0.8, 0}, 40);
  for (const double ratio : {1e-1, 1e-2, 1e-3, 1e-6}) {
    const Model ball(scaled_mesh(icosphere_mesh(1, 5), ratio));
    const Pose start = Pose{turn, {}} * Pose{Mat3{}, {0.3, 0.3, 1.01 * ratio}};
    const Vec3 motion = transform(Pose{turn, {}}, Vec3{ratio, ratio, 0});
    Workspace workspace;
    const PairQuery query{start, {turn, {}}, Solid::none, Solid::none};
    EXPECT_FALSE(cast_shape(ball, motion, floor, query, workspace));
    EXPECT_LT(workspace.counts().volume_tests, 3000U) << ratio;
  }
}

TEST(SizeRatios, ADistanceDoesNotGrowWithTheRatio) {
  // The ball lies beside the longest side of a triangle, within the triangle's oriented box.
  const Model floor(TriangleMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}));
  for (const double ratio : {1e-1, 1e-2, 1e-3, 1e-6}) {
    const Model ball(scaled_mesh(icosphere_mesh(1, 5), ratio));
    Workspace workspace;
    const PairQuery query{Pose{}, Pose{Mat3{}, {0.5 + ratio, 0.5 + ratio, 0}}, Solid::none, Solid::none};
    const Distance found = distance(floor, ball, query, workspace);
    EXPECT_NEAR(found.upper / ratio, std::sqrt(2.0) - 1, 0.01);
    EXPECT_LT(workspace.counts().volume_tests, 2000U) << ratio;
  }
}

}  // namespace
}  // namespace toccata::test
