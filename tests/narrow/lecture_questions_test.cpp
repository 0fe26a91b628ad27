// The questions of the lectures about shapes of a few numbers, each shown (docs/methods/questions.md lists them).
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "support/convex_cases.hpp"
#include "support/mesh_soups.hpp"
#include "toccata/bounds/aabb.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/methods/sphere_ways.hpp"
#include "toccata/narrow/convex_convex.hpp"
#include "toccata/narrow/plane.hpp"
#include "toccata/narrow/primitives.hpp"
#include "toccata/narrow/triangle_triangle.hpp"

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

TEST(LectureQuestion, ACubesBoxIsAtMostRootThreeTimesAsWide) {
  Random random(10);
  double widest = 0;
  for (int i = 0; i < 2000; ++i) {
    const Aabb box = box_around(PosedPolytope(Box({0.5, 0.5, 0.5}), Pose{test::random_rotation(random), {}}));
    widest = std::max(widest, box.upper.x - box.lower.x);
  }
  EXPECT_GT(widest, 1.7);
  EXPECT_LE(widest, std::sqrt(3.0) * (1 + 1e-12));
  // √2 at 45° about an axis, √3 where a diagonal is turned along x.
  const auto width = [](const Mat3& turn) {
    return 2 * box_around(PosedPolytope(Box({0.5, 0.5, 0.5}), {turn, {}})).upper.x;
  };
  EXPECT_NEAR(width(rotation_about({0, 0, 1}, 45)), std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(width(rotation_about({0, 1, 0}, std::atan(std::sqrt(0.5)) * 180 / std::acos(-1.0)) *
                    rotation_about({0, 0, 1}, -45)),
              std::sqrt(3.0), 1e-12);
}

/// The point as the box's own edges see it: |(p − c) · u| ≤ e along each.
bool goes_into(const Vec3& point, const Vec3& half, const Pose& pose) {
  for (int axis = 0; axis < 3; ++axis)
    if (std::fabs(dot(point - pose.offset, pose.linear.column(axis))) > half[axis]) return false;
  return true;
}

TEST(LectureQuestion, TwoBoxesMayMeetWithoutACornerOfEitherInTheOther) {
  // Two bars laid across each other: their edges cross, and every corner is outside of the other.
  const Vec3 long_half{3, 0.5, 0.5};
  const Pose one{rotation_about({0, 0, 1}, 20), {}}, other{rotation_about({0, 0, 1}, 100), {0.25, 0, 0.25}};
  const PosedPolytope a(Box(long_half), one), b(Box(long_half), other);
  for (Index i = 0; i < 8; ++i) {
    EXPECT_FALSE(goes_into(a.vertex(i), long_half, other));
    EXPECT_FALSE(goes_into(b.vertex(i), long_half, one));
  }
  EXPECT_TRUE(overlap(a, b));
  EXPECT_TRUE(overlap_by_separating_axes(a, b));
  // Whether a point goes into a box the coordinates do tell.
  Random random(12);
  for (int i = 0; i < 500; ++i) {
    const Vec3 p{random.between(-3, 3), random.between(-3, 3), random.between(-1, 1)};
    EXPECT_EQ(goes_into(p, long_half, one), overlap(a, PosedPolytope(Point(p))));
  }
}

TEST(LectureQuestion, BothSidesOfABoxsEdgesAreLookedAt) {
  // The slide's (V2 − V1) · (W − V1) < 0 says "left of V1 V4"; what lies to the right is not seen by that sign, but by
  // > |V2 − V1|².
  const Vec3 v1{0, 0, 0}, v2{2, 0, 0};
  const PosedPolytope v(Box({1, 1, 1}), Pose::translation(1, 1, 0));
  const auto left = [&](const PosedPolytope& w) {
    bool all = true;
    for (Index i = 0; i < 8; ++i) all &= dot(v2 - v1, w.vertex(i) - v1) < 0;
    return all;
  };
  const auto right = [&](const PosedPolytope& w) {
    bool all = true;
    for (Index i = 0; i < 8; ++i) all &= dot(v2 - v1, w.vertex(i) - v1) > dot(v2 - v1, v2 - v1);
    return all;
  };
  for (const double x : {-3.0, 1.0, 5.0}) {
    const PosedPolytope w(Box({0.5, 0.5, 0.5}), Pose{rotation_about({0, 0, 1}, 30), {x, 1, 0}});
    EXPECT_EQ(left(w), x < 0);
    EXPECT_EQ(right(w), x > 2);
    EXPECT_EQ(overlap(v, w), !left(w) && !right(w));
  }
}

TEST(LectureQuestion, AConvexPolygonIsAskedLikeATriangleAndAConcaveOneIsCut) {
  // An arrowhead in the plane z = 0, with its notch at (1, 0, 0), and a needle through the notch, and one beside it.
  const Vec3 tip{3, 0, 0}, left{0, 2, 0}, notch{1, 0, 0}, right{0, -2, 0};
  const std::vector<Triangle> cut{{{tip, left, notch}}, {{tip, notch, right}}};
  const auto needle = [](double x) { return PosedPolytope(Segment({x, 0, -1}, {x, 0, 1})); };
  const auto meets_a_triangle = [&](const PosedPolytope& shape) {
    return overlap(PosedPolytope(cut[0]), shape) || overlap(PosedPolytope(cut[1]), shape);
  };
  EXPECT_FALSE(meets_a_triangle(needle(0.5)));
  EXPECT_TRUE(meets_a_triangle(needle(2)));
  const ConvexHull filled({tip, left, notch, right});  // has no notch
  EXPECT_TRUE(overlap(PosedPolytope(filled), needle(0.5)));
  // A convex pentagon against the same of its triangles, edge on edge and corner on face included.
  const ConvexHull pentagon({{0, 0, 0}, {2, 0, 0}, {3, 2, 0}, {1, 3, 0}, {-1, 2, 0}});
  Random random(27);
  int met = 0;
  for (int i = 0; i < 500; ++i) {
    const auto corner = [&] {
      const double x = static_cast<double>(random.below(6)) - 1, y = static_cast<double>(random.below(4));
      return Vec3{x, y, static_cast<double>(random.below(3)) - 1};
    };
    const PosedPolytope other{Triangle{{corner(), corner(), corner()}}};
    bool any = false;
    for (Index k = 2; k < pentagon.vertex_count(); ++k)
      any |= overlap(PosedPolytope(Triangle{{pentagon.vertex(0), pentagon.vertex(k - 1), pentagon.vertex(k)}}), other);
    EXPECT_EQ(overlap(PosedPolytope(pentagon), other), any);
    met += any;
  }
  EXPECT_GT(met, 100);
  EXPECT_LT(met, 450);
}

TEST(LectureQuestion, ShadowsThatOverlapAlongBothNormalsAreNoCollision) {
  // Two triangles each of which crosses the other's plane: no normal parts them, and the cross product of two edges
  // does.
  const Triangle a{{Vec3{0, 0, 0}, Vec3{4, 0, 0}, Vec3{0, 4, 0}}}, b{{Vec3{3, 3, -1}, Vec3{3, 3, 1}, Vec3{6, 6, 0}}};
  const auto shadows_overlap = [&](const Vec3& axis) {
    double least_a = 1e9, most_a = -1e9, least_b = 1e9, most_b = -1e9;
    for (std::size_t i = 0; i < 3; ++i) {
      least_a = std::min(least_a, dot(axis, a.vertex[i]));
      most_a = std::max(most_a, dot(axis, a.vertex[i]));
      least_b = std::min(least_b, dot(axis, b.vertex[i]));
      most_b = std::max(most_b, dot(axis, b.vertex[i]));
    }
    return least_a <= most_b && least_b <= most_a;
  };
  const auto edge = [](const Triangle& t, std::size_t i) { return t.vertex[(i + 1) % 3] - t.vertex[i]; };
  EXPECT_TRUE(shadows_overlap(cross(edge(a, 0), edge(a, 1))));
  EXPECT_TRUE(shadows_overlap(cross(edge(b, 0), edge(b, 1))));
  int separating = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) separating += !shadows_overlap(cross(edge(a, i), edge(b, j)));
  EXPECT_GT(separating, 0);
  EXPECT_LT(separating, 9);
  EXPECT_FALSE(overlap_by_separating_axes(a, b));
  EXPECT_FALSE(overlap(a, b));
}

TEST(LectureQuestion, TheCutOfASegmentIsThatOfTheFormula) {
  const Vec3 v1{1, 0, 0}, v2{0, 2, 0}, v3{0, 0, 4};
  const Plane plane(v1, v2, v3);
  const Vec3 n = cross(v2 - v1, v3 - v1);
  Random random(63);
  int cuts = 0;
  for (int i = 0; i < 500; ++i) {
    const auto end = [&] {
      const double x = random.between(-4, 4), y = random.between(-4, 4), z = random.between(-4, 4);
      return Vec3{x, y, z};
    };
    const Vec3 w1 = end(), w2 = end();
    const double t = dot(n, v1 - w1) / dot(n, w2 - w1);
    const PlaneCut cut = cut_segment(plane, w1, w2);
    EXPECT_EQ(cut.kind == PlaneCutKind::point, t >= 0 && t <= 1);
    if (cut.kind != PlaneCutKind::point) continue;
    ++cuts;
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(cut.point[axis], (w1 + t * (w2 - w1))[axis], 1e-12);
  }
  EXPECT_GT(cuts, 50);
  // The denominator is 0 where the segment is parallel to the plane: contained or disjoint, and there is no t.
  EXPECT_EQ(cut_segment(plane, v1, v2).kind, PlaneCutKind::whole);
  EXPECT_EQ(cut_segment(plane, v1 + n, v2 + n).kind, PlaneCutKind::none);
}

}  // namespace
}  // namespace toccata
