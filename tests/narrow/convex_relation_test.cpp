#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "narrow/exact/exact_interior.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/math/predicates.hpp"
#include "toccata/narrow/convex_convex.hpp"

namespace toccata {
namespace {

PosedPolytope box_at(const Vec3& centre, double half = 1) { return PosedPolytope{Box({half, half, half}, centre)}; }
PosedPolytope ball_at(const Vec3& centre, double radius) { return PosedPolytope{Sphere(radius, centre)}; }

/// The relation, which is that of the exchanged shapes too.
Relation seen(const PosedPolytope& a, const PosedPolytope& b) {
  const Relation relation_of_both = relation(a, b), exchanged = relation(b, a);
  EXPECT_EQ(exchanged.kind, relation_of_both.kind);
  EXPECT_EQ(exchanged.side_unresolved, relation_of_both.side_unresolved);
  EXPECT_EQ(exchanged.a_solid, relation_of_both.b_solid);
  EXPECT_EQ(exchanged.b_solid, relation_of_both.a_solid);
  const bool one_in_the_other =
      relation_of_both.containment == Containment::a_in_b || relation_of_both.containment == Containment::b_in_a;
  EXPECT_EQ(exchanged.containment == relation_of_both.containment, !one_in_the_other);
  return relation_of_both;
}

void expect(const PosedPolytope& a, const PosedPolytope& b, RelationKind kind,
            Containment containment = Containment::none) {
  const Relation answer = seen(a, b);
  EXPECT_EQ(answer.kind, kind);
  EXPECT_EQ(answer.containment, containment);
}

TEST(ConvexRelation, OfBoxes) {
  const PosedPolytope unit = box_at({});
  expect(unit, box_at({2, 0, 0}), RelationKind::touching);
  expect(unit, box_at({2, 2, 2}), RelationKind::touching);
  expect(unit, box_at({2 + 0x1p-50, 0, 0}), RelationKind::apart);
  expect(unit, box_at({2 - 0x1p-50, 0, 0}), RelationKind::overlapping);
  expect(unit, box_at({1, 0, 0}), RelationKind::overlapping);  // half of each, no faces cross
  expect(unit, unit, RelationKind::overlapping, Containment::equal);
  expect(box_at({0.5, 0.5, 0.5}, 0.5), unit, RelationKind::overlapping, Containment::a_in_b);
}

TEST(ConvexRelation, ABallInABox) {
  expect(ball_at({}, 1), box_at({}), RelationKind::overlapping, Containment::a_in_b);  // touches all faces from inside
  expect(ball_at({}, std::nextafter(1.0, 2.0)), box_at({}), RelationKind::overlapping);
  expect(ball_at({}, 1.75), box_at({}), RelationKind::overlapping, Containment::b_in_a);
  expect(ball_at({}, 1.7), box_at({}), RelationKind::overlapping);
  expect(ball_at({3, 0, 0}, 2), box_at({}), RelationKind::touching);
  // Centre inside: the surface is nowhere near.
  expect(ball_at({0.25, 0.25, 0.25}, 0.125), box_at({}), RelationKind::overlapping, Containment::a_in_b);
}

TEST(ConvexRelation, BallsExactlyByTheSquares) {
  // 3, 4, 5: the distance of the centres is 5.
  expect(ball_at({}, 2), ball_at({3, 4, 0}, 3), RelationKind::touching);
  expect(ball_at({}, 2), ball_at({3, 4, 0}, std::nextafter(3.0, 4.0)), RelationKind::overlapping);
  expect(ball_at({}, 8), ball_at({3, 4, 0}, 3), RelationKind::overlapping, Containment::b_in_a);
  expect(ball_at({}, std::nextafter(8.0, 0.0)), ball_at({3, 4, 0}, 3), RelationKind::overlapping);
  expect(ball_at({1, 2, 3}, 3), ball_at({1, 2, 3}, 3), RelationKind::overlapping, Containment::equal);
}

TEST(ConvexRelation, RoundedShapesThatAreTheSameSet) {
  const PosedPolytope capsule{Capsule({-1, 0, 0}, {1, 0, 0}, 0.5)};
  const std::vector<Vec3> points{{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}};
  expect(capsule, PosedPolytope{Rounded(Segment({1, 0, 0}, {-1, 0, 0}), 0.5)}, RelationKind::overlapping,
         Containment::equal);
  const ConvexHull flat(points);
  const Rounded around_flat(flat, 0.5);
  expect(capsule, PosedPolytope{around_flat}, RelationKind::overlapping, Containment::equal);
  expect(ball_at({0.5, 0, 0}, 0.5), capsule, RelationKind::overlapping, Containment::a_in_b);
  expect(ball_at({std::nextafter(1.0, 2.0), 0, 0}, 0.5), capsule, RelationKind::overlapping);
}

TEST(ConvexRelation, ALargerRadiusInABody) {
  const Rounded around_box(Box({2, 2, 2}), 1);
  const PosedPolytope rounded{around_box};
  // A ball of radius 2 reaches 1 beyond the part that it shares with the radius of the box.
  expect(ball_at({1, 1, 1}, 2), rounded, RelationKind::overlapping, Containment::a_in_b);
  expect(ball_at({std::nextafter(1.0, 2.0), 1, 1}, 2), rounded, RelationKind::overlapping);
  // In a slanted body: the depth is not a double, its square is whole.
  const ConvexHull octahedron(std::vector<Vec3>{{3, 0, 0}, {-3, 0, 0}, {0, 3, 0}, {0, -3, 0}, {0, 0, 3}, {0, 0, -3}});
  const double depth = std::sqrt(3.0);  // rounded down
  expect(ball_at({}, depth), PosedPolytope{octahedron}, RelationKind::overlapping, Containment::a_in_b);
  expect(ball_at({}, std::nextafter(depth, 2.0)), PosedPolytope{octahedron}, RelationKind::overlapping);
}

TEST(ConvexRelation, OfSurfaces) {
  const PosedPolytope floor{Triangle{{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}}};
  expect(floor, PosedPolytope{Segment({1, 1, -1}, {1, 1, 1})}, RelationKind::crossing);
  expect(floor, PosedPolytope{Segment({1, 1, 0}, {1, 1, 1})}, RelationKind::touching);   // ends in it
  expect(floor, PosedPolytope{Segment({2, 2, -1}, {2, 2, 1})}, RelationKind::touching);  // through its edge
  expect(floor, PosedPolytope{Segment({1, 1, 0}, {2, 1, 0})}, RelationKind::touching);   // in its plane
  expect(floor, PosedPolytope{Point({1, 1, 0})}, RelationKind::touching);
  expect(PosedPolytope{Segment({-1, 0, 0}, {1, 0, 0})}, PosedPolytope{Segment({0, -1, 0}, {0, 1, 0})},
         RelationKind::touching);  // six vertices in one plane
  EXPECT_TRUE(seen(floor, PosedPolytope{Point({1, 1, 0})}).side_unresolved);
  EXPECT_FALSE(seen(floor, PosedPolytope{Segment({1, 1, -1}, {1, 1, 1})}).side_unresolved);
  EXPECT_FALSE(seen(floor, PosedPolytope{Point({1, 1, 1})}).side_unresolved);
}

TEST(ConvexRelation, AFlatHullIsOneFace) {
  const std::vector<Vec3> corners{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
  const ConvexHull square(corners);
  // On what would be its diagonal.
  expect(PosedPolytope{square}, PosedPolytope{Segment({2, 2, -1}, {2, 2, 1})}, RelationKind::crossing);
}

TEST(ConvexRelation, OfASurfaceAndASolid) {
  const PosedPolytope box = box_at({});
  expect(PosedPolytope{Point(Vec3{})}, box, RelationKind::crossing, Containment::a_in_b);
  expect(PosedPolytope{Point({1, 0, 0})}, box, RelationKind::touching);
  expect(PosedPolytope{Segment({0, 0, 0}, {1, 0, 0})}, box, RelationKind::crossing);  // its end is on the boundary
  expect(PosedPolytope{Segment({-1, 0, 0}, {1, 0, 0})}, box, RelationKind::crossing);
  expect(PosedPolytope{Segment({-1, 1, 0}, {1, 1, 0})}, box, RelationKind::touching);
  expect(PosedPolytope{Segment({0, 0, 0}, {std::nextafter(1.0, 0.0), 0, 0})}, box, RelationKind::crossing,
         Containment::a_in_b);
  expect(PosedPolytope{Point({3, 4, 0})}, ball_at({}, 5), RelationKind::touching);
  expect(PosedPolytope{Point({3, 4, 0})}, ball_at({}, std::nextafter(5.0, 6.0)), RelationKind::crossing,
         Containment::a_in_b);
}

TEST(ConvexRelation, ASurfaceThatReachesTheBoundaryFromInside) {
  const Segment to_the_boundary({0, 0, 0}, {3, 4, 0});
  expect(PosedPolytope{to_the_boundary}, ball_at({}, 5), RelationKind::crossing);
  expect(PosedPolytope{to_the_boundary}, ball_at({}, std::nextafter(5.0, 6.0)), RelationKind::crossing,
         Containment::a_in_b);
}

TEST(ConvexRelation, ASolidThatRoundingFlattensOnlyTouches) {
  Pose far;
  far.offset = {0, 0, 0x1p60};
  const Box thin({1, 1, 0x1p-10});
  const PosedPolytope flattened{thin, far};
  expect(flattened, flattened, RelationKind::touching);
  expect(flattened, PosedPolytope{Sphere(1), far}, RelationKind::touching);
  expect(flattened, PosedPolytope{Segment({0, 0, -0x1p60}, {0, 0, 0x1p60}), far}, RelationKind::touching);
  EXPECT_TRUE(relation(flattened, flattened).a_solid);
}

TEST(ConvexRelation, AtTheEndsOfTheRange) {
  for (const double unit : {0x1p-1070, 1e-300, 1.0, 1e300}) {
    const Box box({2 * unit, 2 * unit, 2 * unit});
    Pose beside, shifted;
    beside.offset = {4 * unit, 0, 0};
    shifted.offset = {3 * unit, 0, 0};
    expect(PosedPolytope{box}, PosedPolytope{box, beside}, RelationKind::touching);
    expect(PosedPolytope{box}, PosedPolytope{box, shifted}, RelationKind::overlapping);
    expect(PosedPolytope{box}, PosedPolytope{box}, RelationKind::overlapping, Containment::equal);
    expect(ball_at({}, 2 * unit), ball_at({4 * unit, 0, 0}, 2 * unit), RelationKind::touching);
    expect(ball_at({}, 2 * unit), PosedPolytope{box}, RelationKind::overlapping, Containment::a_in_b);
  }
}

/// The greatest sign of a height of A's vertices above a face of the hull of B's world vertices, exactly: A lies within
/// where it is not positive.
Sign highest_above(const PosedPolytope& a, const PosedPolytope& b) {
  std::vector<Vec3> corners;
  for (Index i = 0; i < b.vertex_count(); ++i) corners.push_back(b.vertex(i));
  const ConvexHull hull(corners);
  const HullTopology t = hull.topology();
  Sign highest = Sign::negative;
  for (Index f = 0; f < t.face_count(); ++f) {
    const auto corner = [&](Index k) { return hull.vertex(t.origin[t.face_start[f] + k]); };
    for (Index i = 0; i < a.vertex_count(); ++i)
      highest = std::max(highest, orient3d(corner(0), corner(1), corner(2), a.vertex(i)));
  }
  return highest;
}

const ConvexHull& block() {
  static const ConvexHull hull(std::vector<Vec3>{
      {-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {-1, 1, 1}, {1, 1, 1}});
  return hull;
}

// Far from the origin the corners of a face are rounded off its plane by far more than a product of small differences
// is off: how much is part of what doubles have to prove.
TEST(ConvexRelation, WithinAFaceThatRoundingHasBentIsToldExactly) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> number(-1, 1);
  std::array<int, 2> counts{};
  for (int i = 0; i < 1000; ++i) {
    Pose pose{rotation_about({number(random), number(random), number(random)}, 180 * number(random)),
              {1e6 * number(random), 1e6, 1e6 * number(random)}};
    if (i % 4 == 3) pose.linear = pose.linear * Mat3{{Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}};
    if (i % 4 == 2) pose.linear = pose.linear * Mat3{{Vec3{1, 0.5, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 3}}};
    const Vec3 middle = pose * Vec3{},
               peak = pose * Vec3{0.6 * number(random), 0.6 * number(random), 1 - 2e-10 * number(random)};
    const Vec3 x = middle + Vec3{0.1, 0, 0}, y = middle + Vec3{0, 0.1, 0}, z = middle + Vec3{0, 0, 0.1};
    const ConvexHull spike(std::vector<Vec3>{peak, middle, x, y, z});
    const PosedPolytope a{spike}, surface{Triangle{peak, x, y}};
    for (const PosedPolytope& b : {PosedPolytope{block(), pose}, PosedPolytope{Box({1, 1, 1}), pose}}) {
      const Sign highest = highest_above(a, b);
      EXPECT_EQ(relation(a, b).containment == Containment::a_in_b, highest != Sign::positive) << i;
      EXPECT_EQ(relation(surface, b).containment == Containment::a_in_b, highest == Sign::negative) << i;
      ++counts[highest == Sign::positive ? 1 : 0];
    }
  }
  EXPECT_GT(counts[0], 100);
  EXPECT_GT(counts[1], 100);
}

TEST(ConvexRelation, OfAGrownShapeDeepInAnother) {
  const Pose pose{rotation_about({1, 2, 3}, 40), {1e3, 0, 0}};
  const PosedPolytope sharp{block(), pose}, round{Rounded(block(), 0.125), pose};
  for (const auto& [outer, reach] : {std::pair(sharp, 1.0), std::pair(round, 1.125)})
    for (const double radius : {0.25, 0.5, 0.875, reach - 1e-9, reach + 1e-9})
      expect(ball_at({1e3, 0, 0}, radius), outer, RelationKind::overlapping,
             radius < reach ? Containment::a_in_b : Containment::none);
}

TEST(ConvexRelation, OfHullsOfManyVerticesThatAreLong) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> number;
  std::vector<Vec3> points, smaller;
  for (int i = 0; i < 400; ++i) {
    const Vec3 v{number(random), number(random), number(random)};
    const Vec3 on_ball = (1 / length(v)) * v;
    points.push_back({10 * on_ball.x, on_ball.y, on_ball.z});
    smaller.push_back(0.9 * points.back());
  }
  const ConvexHull hull(points), within(smaller);
  expect(PosedPolytope{within}, PosedPolytope{hull}, RelationKind::overlapping, Containment::a_in_b);
  expect(PosedPolytope{within, Pose::translation(1.2, 0, 0)}, PosedPolytope{hull}, RelationKind::overlapping);
}

TEST(ConvexRelation, CountsAQuestionOnce) {
  SimplexCache workspace;
  (void)relation(box_at({}), box_at({9, 0, 0}), &workspace);
  (void)relation(box_at({}), box_at({0.5, 0.25, 0.125}), &workspace);
  EXPECT_EQ(workspace.counts.exact, 0U);
  EXPECT_EQ(workspace.counts.certificates + workspace.counts.closed_forms, 2U);
  (void)relation(box_at({}), box_at({2, 0, 0}), &workspace);
  EXPECT_EQ(workspace.counts.exact, 1U);
  EXPECT_EQ(workspace.counts.certificates + workspace.counts.closed_forms, 2U);
}

TEST(ConvexRelation, OfGrownShapesThatMeetDeeplyNeedsNoExactArithmetic) {
  const auto capsule_at = [](double y, double z) { return PosedPolytope{Capsule({-1, y, z}, {1, y, z}, 0.5)}; };
  const PosedPolytope box = box_at({}), rounded{Rounded(Box({1, 1, 1}), 0.25)};
  for (const double depth : {1.0, 1e-3, 1e-9}) {
    SimplexCache workspace;
    static_cast<void>(
        relation(PosedPolytope{block()}, PosedPolytope{block(), Pose::rotation({1, 2, 3}, 40)}, &workspace));
    workspace.counts = {};
    const auto is_deep = [&](const PosedPolytope& a, const PosedPolytope& b) {
      const Relation answer = relation(a, b, &workspace);
      return answer.kind == RelationKind::overlapping && answer.containment == Containment::none;
    };
    EXPECT_TRUE(is_deep(ball_at({2 - depth, 0.3, 0.2}, 1), box)) << depth;
    EXPECT_TRUE(is_deep(capsule_at(0, 0), ball_at({0.3, 1.5 - depth, 0}, 1))) << depth;
    EXPECT_TRUE(is_deep(capsule_at(0, 0), capsule_at(1 - depth, 1e-5))) << depth;
    EXPECT_TRUE(is_deep(capsule_at(1.5 - depth, 0.1), box)) << depth;
    EXPECT_TRUE(is_deep(rounded, box_at({2.25 - depth, 0.3, 0.2}))) << depth;
    EXPECT_TRUE(is_deep(rounded, PosedPolytope{Rounded(Box({1, 1, 1}), 0.5), Pose::translation(2.75 - depth, 0, 0)}));
    EXPECT_EQ(workspace.counts.exact, 0U) << depth;
  }
}

TEST(InteriorsMeet, WhereTheCommonPointIsAVertexOfBoth) {
  // The pyramids of two octants meet in the origin; turned a little, their insides do.
  const ConvexHull octant(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  const ConvexHull opposite(std::vector<Vec3>{{0, 0, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}});
  const ConvexHull over_the_edge(std::vector<Vec3>{{0, 0, 0}, {-1, 0, 0}, {0, -1, 0}, {0x1p-60, 0x1p-60, 1}});
  VertexPairs common;
  common.append(0, 0);
  EXPECT_FALSE(interiors_meet(PosedPolytope{octant}, PosedPolytope{opposite}, common));
  EXPECT_TRUE(interiors_meet(PosedPolytope{octant}, PosedPolytope{over_the_edge}, common));
  EXPECT_TRUE(interiors_meet(PosedPolytope{octant}, PosedPolytope{octant}, common));
  EXPECT_FALSE(interiors_meet(PosedPolytope{octant}, PosedPolytope{opposite}, {}));
}

}  // namespace
}  // namespace toccata
