#include "query/meshes/pair_cull.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>

#include "oracle/rational.hpp"
#include "support/mesh_soups.hpp"
#include "toccata/narrow/triangle_triangle.hpp"

namespace toccata {
namespace {

using oracle::exact;

Aabb point_box(const Vec3& p) { return {p, p}; }

TriangleMesh triangle_mesh(const Triangle& t) { return {{t[0], t[1], t[2]}, {{0, 1, 2}}}; }

const Aabb& root_box(const PosedMesh& mesh) { return mesh.model().wide_bvh().box; }

/// The error of the culling test in one direction for two vertices, against its pad.
double error_ratio(const CullDirection& d, const PosedMesh& a, Index vertex_a, const PosedMesh& b, Index vertex_b) {
  const Vec3 x = a.model().mesh().vertices()[vertex_a], y = b.model().mesh().vertices()[vertex_b];
  const oracle::Rational truth =
      oracle::dot(exact(d.world), exact(a.vertices()[vertex_a]) - exact(b.vertices()[vertex_b]));
  const FormRange on_a = range_of(d.on_a, point_box(x)), on_b = range_of(d.on_b, point_box(y));
  const oracle::Rational ahead = abs(exact((on_a.low + d.offset) - on_b.high) - truth);
  const oracle::Rational behind = abs(exact((on_b.low - d.offset) - on_a.high) + truth);
  return static_cast<double>(oracle::Rational((ahead > behind ? ahead : behind) / exact(d.pad)));
}

double worst_ratio(const std::string& family, std::uint64_t seed, double coordinate_scale) {
  Random random(seed);
  const auto vertex = [&] { return coordinate_scale * Vec3{random.unit(), random.unit(), random.unit()}; };
  const auto mesh = [&] { return Model(triangle_mesh({vertex(), vertex(), vertex()})); };
  PairQuery query = test::random_poses(family, random);
  // Poses that cancel large offsets by large coordinates are the hard ones.
  if (seed % 2 == 0) query.pose_a.offset = -transform({query.pose_a.linear, {}}, vertex());
  const PosedMesh a(mesh(), query.pose_a), b(mesh(), query.pose_b);
  double worst = 0;
  const PairCull cull(a, b);
  for (const CullDirection& direction : cull.directions())
    for (Index i = 0; i < 3; ++i)
      for (Index j = 0; j < 3; ++j) worst = std::max(worst, error_ratio(direction, a, i, b, j));
  return worst;
}

TEST(PairCull, ThePadsCoverTheRounding) {
  double worst = 0;
  for (const std::string& family : test::pose_families())
    for (std::uint64_t seed = 0; seed < 4; ++seed)
      for (const double scale : {1.0, 1e3, 1e-3, 1e-300, 5e-324, 1e-160}) {
        const double ratio = worst_ratio(family, seed, scale);
        EXPECT_LT(ratio, 1) << family << ", seed " << seed << ", coordinates of size " << scale;
        worst = std::max(worst, ratio);
      }
  RecordProperty("worst_ratio_of_error_and_pad", std::to_string(worst));
  EXPECT_GT(worst, 0.01) << "the pads are far too large";
}

/// Two small triangles that have world vertices in common only because their sums round to the same doubles.
struct RoundedTogether {
  explicit RoundedTogether(std::uint64_t seed) {
    Random random(seed);
    query.pose_a.linear = test::random_rotation(random);
    query.pose_b.linear = test::random_rotation(random);
    query.pose_a.offset = query.pose_b.offset = {1e6, -1e6, 1e6 * random.unit()};
    const auto vertex = [&] { return 1e-12 * Vec3{random.unit(), random.unit(), random.unit()}; };
    a.emplace(Model(triangle_mesh({vertex(), vertex(), vertex()})), query.pose_a);
    b.emplace(Model(triangle_mesh({vertex(), vertex(), vertex()})), query.pose_b);
  }
  PairQuery query;
  std::optional<PosedMesh> a, b;
};

TEST(PairCull, WithoutThePadsContactsAreLost) {
  int meeting = 0, lost_without_pads = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const RoundedTogether pair(seed);
    if (!overlap(pair.a->triangle(0), pair.b->triangle(0))) continue;
    ++meeting;
    const Aabb &box_a = root_box(*pair.a), &box_b = root_box(*pair.b);
    EXPECT_FALSE(PairCull(*pair.a, *pair.b).disjoint(box_a, box_b)) << "seed " << seed;
    if (PairCull(*pair.a, *pair.b, 0).disjoint(box_a, box_b)) ++lost_without_pads;
  }
  EXPECT_GT(meeting, 100);
  EXPECT_GT(lost_without_pads, 10) << "this test no longer shows that the pads are needed";
}

TEST(PairCull, NeverSeparatesTrianglesThatMeetUnderAnyPose) {
  for (const std::string& family : test::pose_families())
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
      Random random(seed);
      const PairQuery query = test::random_poses(family, random);
      const PosedMesh a(Model(test::random_soup(random, 1, 0.5, 4)), query.pose_a);
      const PosedMesh b(Model(test::random_soup(random, 1, 0.5, 4)), query.pose_b);
      const bool separated = PairCull(a, b).disjoint(root_box(a), root_box(b));
      EXPECT_FALSE(separated && overlap(a.triangle(0), b.triangle(0))) << family << ", seed " << seed;
    }
}

TEST(PairCull, SeparatesBoxesThatAreApart) {
  const Model unit(test::box_between({0, 0, 0}, {1, 1, 1}));
  const PosedMesh a(unit, Pose{}), b(unit, Pose::translation(1.001, 0, 0));
  EXPECT_TRUE(PairCull(a, b).disjoint(root_box(a), root_box(b)));
  EXPECT_EQ(PairCull(a, b).directions().size(), 3U) << "equal directions are kept once";
}

TEST(PairCull, WhatOverflowsIsNotSeparated) {
  const double huge = 1e308;
  const Model wide(triangle_mesh({Vec3{-huge, 0, 0}, Vec3{huge, 0, 0}, Vec3{0, huge, 0}}));
  const Model point(triangle_mesh({Vec3{0, 0, 1}, Vec3{0, 0, 1}, Vec3{0, 0, 1}}));
  Random random(1);
  const PosedMesh a(wide, Pose{}), b(point, Pose{test::random_rotation(random), {huge, huge, huge}});
  for (const CullDirection& d : PairCull(a, b).directions()) EXPECT_TRUE(std::isfinite(d.pad) && is_finite(d.on_a));
  EXPECT_FALSE(is_certain(std::numeric_limits<double>::infinity(), 0));
  EXPECT_FALSE(is_certain(std::numeric_limits<double>::quiet_NaN(), 0));
  EXPECT_FALSE(is_certain(1, std::numeric_limits<double>::quiet_NaN()));
}

TEST(PairCull, ASingularPoseStillHasDirections) {
  const Model unit(test::box_between({0, 0, 0}, {1, 1, 1}));
  Pose flat;
  flat.linear[2] = {};
  const PosedMesh a(unit, flat), b(unit, Pose::translation(0, 0, 0.001));
  EXPECT_TRUE(PairCull(a, b).disjoint(root_box(a), root_box(b)));
  Pose point;
  point.linear = {{{{}, {}, {}}}};
  const PosedMesh c(unit, point), d(unit, Pose::translation(0.5, 0.5, 0.001));
  EXPECT_TRUE(PairCull(c, d).disjoint(root_box(c), root_box(d)));
}

}  // namespace
}  // namespace toccata
