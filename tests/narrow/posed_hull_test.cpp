#include <gtest/gtest.h>

#include <limits>
#include <type_traits>
#include <vector>

#include "toccata/core/error.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/narrow/posed_polytope.hpp"

namespace toccata {
namespace {

const std::vector<Vec3> octahedron = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};

TEST(PosedHull, VerticesArePosedWhenLookedAt) {
  const ConvexHull hull(octahedron);
  const Pose pose{rotation_about({1, 2, 3}, 40), {0.1, 0.2, 0.3}};
  const PosedPolytope posed(hull, pose);
  ASSERT_EQ(posed.vertex_count(), 6U);
  EXPECT_FALSE(posed.in_world());
  EXPECT_TRUE(posed.solid());
  for (Index i = 0; i < 6; ++i) EXPECT_EQ(posed.vertex(i), transform(pose, hull.vertex(i)));
  const std::vector<PosedPolytope> copies(2, posed);
  EXPECT_EQ(copies[1].vertex(5), posed.vertex(5));
  EXPECT_EQ(posed.topology().face_count(), 8U);
}

TEST(PosedHull, AFlatHullIsASurfaceAndMayBeFlattened) {
  const ConvexHull flat(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}});
  const Pose flattened{{{Vec3{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}}, {}};
  EXPECT_FALSE(PosedPolytope(flat, flattened).solid());
  const ConvexHull solid(octahedron);
  EXPECT_THROW(PosedPolytope(solid, flattened), Error);
  static_assert(!std::is_constructible_v<PosedPolytope, ConvexHull&&>, "it would refer to a hull that has ended");
}

TEST(PosedHull, WorldVerticesMustBeFinite) {
  const double most = std::numeric_limits<double>::max();
  const std::vector<Vec3> far = {{most, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}};
  const ConvexHull hull(far);
  EXPECT_EQ(PosedPolytope(hull).vertex(0), far[0]);
  EXPECT_THROW(PosedPolytope(hull, Pose::translation(most, 0, 0)), Error);
  EXPECT_EQ(PosedPolytope(hull, Pose::translation(-most, 0, 0)).vertex(0), Vec3{});
}

TEST(PosedHull, RoundedShapesGrowTheirCore) {
  const PosedPolytope rounded(Rounded(Box{{1, 1, 1}}, 0.5), Pose::translation(1, 0, 0));
  EXPECT_EQ(rounded.topology().face_count(), 6U);
  EXPECT_EQ(rounded.radius(), 0.5);
  EXPECT_TRUE(rounded.solid());
  EXPECT_EQ(rounded.vertex(7), (Vec3{2, 1, 1}));
  EXPECT_TRUE(PosedPolytope(Rounded(Segment{{}, {1, 0, 0}}, 0.5)).solid());
  EXPECT_TRUE(PosedPolytope(Rounded(ConvexHull(octahedron), 0.5)).solid());
}

TEST(PosedHull, APoseMustNotDeformARoundedShape) {
  const Pose stretched{{{Vec3{1, 0, 0}, {0, 2, 0}, {0, 0, 1}}}, {}};
  EXPECT_THROW(PosedPolytope(Rounded(Box{{1, 1, 1}}, 1), stretched), Error);
  EXPECT_THROW(PosedPolytope(Rounded(Point{}, 1), stretched), Error);
}

}  // namespace
}  // namespace toccata
