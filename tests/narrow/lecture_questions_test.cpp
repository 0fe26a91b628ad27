// The questions of the lectures about shapes of a few numbers, each shown (docs/methods/*.md name these tests).
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "support/convex_cases.hpp"
#include "toccata/bounds/aabb.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/methods/sphere_ways.hpp"
#include "toccata/narrow/convex_convex.hpp"
#include "toccata/narrow/primitives.hpp"

namespace toccata {
namespace {

Aabb box_around(const PosedPolytope& shape) {
  Aabb box;
  for (Index i = 0; i < shape.vertex_count(); ++i) box = merge(box, shape.vertex(i));
  return box;
}

/// A plate of half extents 2, 2, 0.1, turned by 45° about z and moved.
PosedPolytope turned_plate(const Vec3& offset) {
  return PosedPolytope(Box({2, 2, 0.1}), Pose{rotation_about({0, 0, 1}, 45), offset});
}

TEST(LectureQuestion, BoxesAroundTurnedBoxesTellOnlyWhatIsApart) {
  // Apart along an axis of the world: "definitely do not overlap".
  EXPECT_FALSE(overlap(box_around(turned_plate({})), box_around(turned_plate({5.7, 0, 0}))));
  EXPECT_FALSE(overlap(turned_plate({}), turned_plate({5.7, 0, 0})));
  // "Possibly overlap": the boxes around them do, they do not.
  EXPECT_TRUE(overlap(box_around(turned_plate({})), box_around(turned_plate({3, 3, 0}))));
  EXPECT_FALSE(overlap(turned_plate({}), turned_plate({3, 3, 0})));
  // And here both do.
  EXPECT_TRUE(overlap(box_around(turned_plate({})), box_around(turned_plate({2, 2, 0}))));
  EXPECT_TRUE(overlap(turned_plate({}), turned_plate({2, 2, 0})));
}

TEST(LectureQuestion, TheDefiniteAnswerIsSeenAlongTheEdgesOfABox) {
  const PosedPolytope a = turned_plate({}), b = turned_plate({3, 3, 0});
  // All vertices of B lie to one side of a face of A, in the coordinate that A's edge gives.
  const Vec3 edge = rotation_about({0, 0, 1}, 45).column(0);
  double farthest_of_a = -1e9, nearest_of_b = 1e9;
  for (Index i = 0; i < 8; ++i) {
    farthest_of_a = std::max(farthest_of_a, dot(edge, a.vertex(i)));
    nearest_of_b = std::min(nearest_of_b, dot(edge, b.vertex(i)));
  }
  EXPECT_LT(farthest_of_a, nearest_of_b);
  EXPECT_FALSE(overlap_by_separating_axes(a, b));
}

TEST(LectureQuestion, AlignedBoxesOverlapExactlyWhenTheyDoAlongEveryAxis) {
  Random random(20261121);
  for (int i = 0; i < 500; ++i) {
    // Whole numbers, so that faces, edges and corners often touch.
    const auto number = [&] { return static_cast<double>(random.below(7)); };
    const auto box = [&] {
      return Box({1 + number(), 1 + number(), 1 + number()}, 2 * Vec3{number(), number(), number()});
    };
    const PosedPolytope a{box()}, b{box()};
    const Aabb around_a = box_around(a), around_b = box_around(b);
    bool along_every_axis = true;
    for (int axis = 0; axis < 3; ++axis)
      along_every_axis &= around_a.lower[axis] <= around_b.upper[axis] && around_b.lower[axis] <= around_a.upper[axis];
    EXPECT_EQ(overlap(a, b), along_every_axis);
    EXPECT_EQ(overlap(around_a, around_b), along_every_axis);
    EXPECT_EQ(overlap_by_separating_axes(a, b), along_every_axis);
  }
}

TEST(LectureQuestion, ThePlanesOfVoronoiRegionsStandOnTheEdges) {
  const Triangle triangle{{Vec3{0, 0, 0}, Vec3{4, 0, 0}, Vec3{0, 4, 0}}};
  const PosedPolytope posed(triangle);
  const auto nearest_to = [&](const Vec3& centre) {
    const Vec3 found = distance(posed, PosedPolytope(Point(centre))).on_a;
    // To eight digits, since witness points are rounded.
    return Vec3{std::round(found.x * 0x1p27) * 0x1p-27, std::round(found.y * 0x1p27) * 0x1p-27,
                std::round(found.z * 0x1p27) * 0x1p-27};
  };
  // The face's region ends at planes through the edges, along the normal: y = 0 for the first edge. On its one side the
  // nearest point is in the face, on the other on the edge.
  EXPECT_EQ(nearest_to({1, 0.125, 9}), (Vec3{1, 0.125, 0}));
  EXPECT_EQ(nearest_to({1, -0.125, 9}), (Vec3{1, 0, 0}));
  // The edge's region ends at planes through its ends, at right angles to it: x = 0. Beyond is the vertex's.
  EXPECT_EQ(nearest_to({0.125, -3, 9}), (Vec3{0.125, 0, 0}));
  EXPECT_EQ(nearest_to({-0.125, -3, 9}), (Vec3{0, 0, 0}));
  // The vertex at the origin is bounded by one such plane of each of its edges.
  EXPECT_EQ(nearest_to({-0.125, -0.125, 9}), (Vec3{0, 0, 0}));
  EXPECT_EQ(nearest_to({-0.125, 0.125, 9}), (Vec3{0, 0.125, 0}));
  // The way that walks these regions sees the same.
  EXPECT_TRUE(overlap_by_voronoi_regions(PosedSphere({1, -3, 4}, 5), triangle));
  EXPECT_FALSE(overlap_by_voronoi_regions(PosedSphere({1, -3, 4}, std::nextafter(5, 0)), triangle));
}

TEST(LectureQuestion, ASphereWhoseCentreIsInsideMeetsAndHasItsWayOut) {
  const PosedPolytope box(Box({4, 4, 4})), ball(Sphere(0.5, {3, 0, 0}));
  EXPECT_TRUE(overlap(box, ball));
  EXPECT_EQ(distance(box, ball).upper, 0);
  const Penetration way_out = penetration(box, ball);
  EXPECT_LE(way_out.lower, 1.5);
  EXPECT_GE(way_out.upper, 1.5);  // 1 from the centre to the face, and the radius
  EXPECT_NEAR(way_out.direction.x, 1, 1e-12);
}

TEST(LectureQuestion, TheDistanceToAPlaneIsTheHeightOverTheNormalsLength) {
  // n = (1, 2, 2), d = −6: |n| is 3. The centre (5, 5, 5) has n·x + d = 19.
  const PosedHalfSpace plane(HalfSpace({2, 1, 1}, {1, 2, 2}));
  const Distance found = distance(PosedPolytope(Sphere(2, {5, 5, 5})), plane);
  const double exact = 19.0 / 3 - 2;
  EXPECT_LE(found.lower, std::nextafter(exact, 9));
  EXPECT_GE(found.upper, std::nextafter(exact, 0));
  EXPECT_LE(found.upper - found.lower, 1e-12 * exact);
  // The nearest points: from the centre along the normal, to the surface and to the plane.
  for (int axis = 0; axis < 3; ++axis) {
    const double n = axis == 0 ? 1.0 / 3 : 2.0 / 3;
    EXPECT_NEAR(found.on_a[axis], 5 - 2 * n, 1e-12);
    EXPECT_NEAR(found.on_b[axis], 5 - 19.0 / 3 * n, 1e-12);
  }
}

TEST(LectureQuestion, OverlapIsAPointInTheMinkowskiSum) {
  // A box grown by a ball of the other's radius and the ball's centre: one set and a point.
  const Rounded sum(Box({1, 1, 1}), 0.5);
  for (const Vec3& centre :
       {Vec3{1.5, 0, 0}, Vec3{1.25, 1.25, 1.25}, Vec3{1.5, 1.5, 1.5}, Vec3{1.5, 1, 1}, Vec3{1.4, 1.4, 0}})
    EXPECT_EQ(overlap(PosedPolytope(sum), PosedPolytope(Point(centre))),
              overlap(PosedPolytope(Box({1, 1, 1})), PosedPolytope(Sphere(0.5, centre))));
  // Grown planes alone would say otherwise at a corner: the sum is round there.
  EXPECT_FALSE(overlap(PosedPolytope(sum), PosedPolytope(Point({1.4, 1.4, 1.4}))));
  EXPECT_TRUE(overlap(PosedPolytope(Box({1.5, 1.5, 1.5})), PosedPolytope(Point({1.4, 1.4, 1.4}))));
}

}  // namespace
}  // namespace toccata
