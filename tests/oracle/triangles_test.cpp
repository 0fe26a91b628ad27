#include "oracle/triangles.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "toccata/core/random.hpp"

namespace toccata::oracle {
namespace {

const Triangle right_angle{{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}};

CommonSet common_with_right_angle(const Triangle& other) {
  CommonSet forward = common_set(exact(right_angle), exact(other));
  const CommonSet backward = common_set(exact(other), exact(right_angle));
  EXPECT_EQ(forward.kind, backward.kind);
  EXPECT_EQ(forward.coplanar, backward.coplanar);
  EXPECT_EQ(forward.crossing, backward.crossing);
  EXPECT_TRUE(std::ranges::is_permutation(forward.extreme_points, backward.extreme_points));
  return forward;
}

TEST(OracleTriangles, OneThroughTheFaceOfAnotherCrosses) {
  const CommonSet common = common_with_right_angle({{{{1, 1, -1}, {1, 1, 1}, {9, 9, 0}}}});
  EXPECT_EQ(common.kind, CommonSetKind::segment);
  EXPECT_TRUE(common.crossing);
  EXPECT_FALSE(common.coplanar);
}

TEST(OracleTriangles, AnEdgeThroughAnEdgeTouches) {
  const CommonSet common = common_with_right_angle({{{{2, 2, -1}, {2, 2, 1}, {9, 9, 0}}}});
  EXPECT_EQ(common.kind, CommonSetKind::point);
  EXPECT_FALSE(common.crossing);
}

TEST(OracleTriangles, AVertexOnAFaceTouches) {
  const CommonSet common = common_with_right_angle({{{{1, 1, 0}, {1, 1, 1}, {2, 1, 1}}}});
  EXPECT_EQ(common.kind, CommonSetKind::point);
  EXPECT_EQ(common.extreme_points, (std::vector<RationalPoint>{{1, 1, 0}}));
  EXPECT_FALSE(common.crossing);
}

TEST(OracleTriangles, AnEdgeOnAFaceTouches) {
  const CommonSet common = common_with_right_angle({{{{1, 1, 0}, {2, 1, 0}, {2, 1, 1}}}});
  EXPECT_EQ(common.kind, CommonSetKind::segment);
  EXPECT_FALSE(common.crossing);
}

TEST(OracleTriangles, CoplanarOnesShareAPolygonAndDoNotCross) {
  const CommonSet hexagon = common_set(exact(Triangle{{{{0, 0, 0}, {6, 0, 0}, {0, 6, 0}}}}),
                                       exact(Triangle{{{{3, 3, 0}, {3, -1, 0}, {-1, 3, 0}}}}));
  EXPECT_EQ(hexagon.kind, CommonSetKind::polygon);
  EXPECT_TRUE(hexagon.coplanar);
  EXPECT_FALSE(hexagon.crossing);
  const CommonSet star = common_set(exact(Triangle{{{{0, 0, 0}, {6, 0, 0}, {3, 6, 0}}}}),
                                    exact(Triangle{{{{0, 4, 0}, {6, 4, 0}, {3, -2, 0}}}}));
  EXPECT_EQ(star.extreme_points.size(), 6U);
}

TEST(OracleTriangles, IdenticalOnesShareAllOfThemselves) {
  const CommonSet common = common_with_right_angle(right_angle);
  EXPECT_EQ(common.kind, CommonSetKind::polygon);
  EXPECT_EQ(common.extreme_points.size(), 3U);
}

TEST(OracleTriangles, ASegmentThroughAFaceCrosses) {
  const CommonSet common = common_with_right_angle({{{{1, 1, -1}, {1, 1, 1}, {1, 1, 0.5}}}});
  EXPECT_EQ(common.kind, CommonSetKind::point);
  EXPECT_TRUE(common.crossing);
}

TEST(OracleTriangles, APointOnAFaceIsCoplanarWithIt) {
  const CommonSet common = common_with_right_angle({{{{1, 1, 0}, {1, 1, 0}, {1, 1, 0}}}});
  EXPECT_EQ(common.kind, CommonSetKind::point);
  EXPECT_TRUE(common.coplanar);
  EXPECT_FALSE(common.crossing);
}

TEST(OracleTriangles, SmallestDoubleDecides) {
  EXPECT_EQ(common_with_right_angle({{{{1, 1, 5e-324}, {1, 1, 1}, {2, 1, 1}}}}).kind, CommonSetKind::none);
  EXPECT_EQ(common_with_right_angle({{{{1, 1, -5e-324}, {1, 1, 1}, {2, 1, 1}}}}).kind, CommonSetKind::segment);
}

TEST(OracleTriangles, DimensionAndFeatures) {
  const RationalTriangle segment = exact(Triangle{{{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}}});
  EXPECT_EQ(dimension(segment), 1);
  EXPECT_EQ(feature_at(segment, {0, 0, 0}), (TriangleFeature{0, 0}));
  EXPECT_EQ(feature_at(segment, {1, 0, 0}), (TriangleFeature{1, 2}));
  const RationalTriangle face = exact(right_angle);
  EXPECT_EQ(feature_at(face, {2, 2, 0}), (TriangleFeature{1, 1}));
  EXPECT_EQ(feature_at(face, {1, 1, 0}), (TriangleFeature{2, 0}));
  EXPECT_EQ(feature_at(face, {0, 4, 0}), (TriangleFeature{0, 2}));
}

Triangle random_grid_triangle(Random& random) {
  Triangle triangle;
  for (Vec3& v : triangle.vertex)
    v = {static_cast<double>(random.below(4)), static_cast<double>(random.below(4)),
         static_cast<double>(random.below(4))};
  return triangle;
}

Triangle rotated_vertices(const Triangle& t) { return {{{t[2], t[0], t[1]}}}; }

Triangle mirrored_and_scaled(const Triangle& t) {
  Triangle result = t;
  for (Vec3& v : result.vertex) v = {-0x1p-40 * v.y, 0x1p-40 * v.x, 0x1p-40 * v.z};
  return result;
}

TEST(OracleTriangles, InvariantUnderSwapOrderMirrorAndScale) {
  const std::uint64_t seed = 5;
  Random random(seed);
  for (int round = 0; round < 500; ++round) {
    const Triangle a = random_grid_triangle(random);
    const Triangle b = random_grid_triangle(random);
    const CommonSet common = common_set(exact(a), exact(b));
    const auto same = [&](const CommonSet& other) {
      return other.kind == common.kind && other.coplanar == common.coplanar && other.crossing == common.crossing &&
             other.extreme_points.size() == common.extreme_points.size();
    };
    ASSERT_TRUE(same(common_set(exact(b), exact(a)))) << "seed " << seed << " round " << round;
    ASSERT_TRUE(same(common_set(exact(rotated_vertices(a)), exact(b)))) << "seed " << seed << " round " << round;
    ASSERT_TRUE(same(common_set(exact(mirrored_and_scaled(a)), exact(mirrored_and_scaled(b)))))
        << "seed " << seed << " round " << round;
  }
}

TEST(OracleTriangles, ExtremePointsLieOnBoth) {
  const std::uint64_t seed = 6;
  Random random(seed);
  for (int round = 0; round < 300; ++round) {
    const RationalTriangle a = exact(random_grid_triangle(random));
    const RationalTriangle b = exact(random_grid_triangle(random));
    for (const RationalPoint& p : common_set(a, b).extreme_points)
      ASSERT_TRUE(contains(a, p) && contains(b, p)) << "seed " << seed << " round " << round;
  }
}

}  // namespace
}  // namespace toccata::oracle
