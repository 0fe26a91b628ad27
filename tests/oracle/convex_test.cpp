#include "oracle/convex.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "oracle/triangles.hpp"
#include "toccata/core/random.hpp"

namespace toccata::oracle {
namespace {

ConvexSet box(const Vec3& lower, const Vec3& upper) {
  std::vector<Vec3> corners;
  for (const double x : {lower.x, upper.x})
    for (const double y : {lower.y, upper.y})
      for (const double z : {lower.z, upper.z}) corners.push_back({x, y, z});
  return box_set(corners);
}

const ConvexSet unit_box = box({0, 0, 0}, {1, 1, 1});

/// The relation, asked both ways round.
template <class A, class B>
Relation relation_both_ways(const A& a, const B& b) {
  EXPECT_EQ(relation(a, b), flipped(relation(b, a)));
  EXPECT_EQ(overlap(a, b), relation(a, b).kind != RelationKind::apart);
  return relation(a, b);
}

Relation overlapping(Containment containment = Containment::none) { return {RelationKind::overlapping, containment}; }
Relation crossing(Containment containment = Containment::none) { return {RelationKind::crossing, containment}; }
const Relation apart{RelationKind::apart};
const Relation touching{RelationKind::touching};
const Relation surfaces_touching{RelationKind::touching, Containment::none, true};

TEST(OracleConvex, RelationsOfBoxes) {
  EXPECT_EQ(relation_both_ways(unit_box, box({2, 0, 0}, {3, 1, 1})), apart);
  EXPECT_EQ(relation_both_ways(unit_box, box({1, 0, 0}, {2, 1, 1})), touching);
  EXPECT_EQ(relation_both_ways(unit_box, box({1, 1, 0}, {2, 2, 1})), touching);
  EXPECT_EQ(relation_both_ways(unit_box, box({1, 1, 1}, {2, 2, 2})), touching);
  EXPECT_EQ(relation_both_ways(unit_box, box({0.5, 0, 0}, {1.5, 1, 1})), overlapping());
  EXPECT_EQ(relation_both_ways(unit_box, unit_box), overlapping(Containment::equal));
  EXPECT_EQ(relation_both_ways(unit_box, box({0, 0, 0}, {1, 1, 0.5})), overlapping(Containment::b_in_a));
  EXPECT_EQ(relation_both_ways(unit_box, box({1 - 0x1p-53, 0, 0}, {2, 1, 1})), overlapping());
}

TEST(OracleConvex, DistancesOfBoxes) {
  EXPECT_EQ(nearest_points(unit_box, box({4, 5, 0}, {5, 6, 1})).squared_distance, 25);
  EXPECT_EQ(nearest_points(unit_box, box({3, 3, 2}, {5, 6, 3})).squared_distance, 9);
  EXPECT_EQ(compare_distance(unit_box, box({4, 5, 0}, {5, 6, 1}), 5), 0);
  EXPECT_EQ(compare_distance(unit_box, box({4, 5, 0}, {5, 6, 1}), Rational(49, 10)), 1);
  EXPECT_EQ(compare_distance(unit_box, unit_box, 0), 0);
  EXPECT_EQ(compare_distance(unit_box, unit_box, 1), -1);
}

TEST(OracleConvex, SpheresTangentExactly) {
  const ConvexSet ball = sphere_set({0, 0, 0}, 2);
  EXPECT_EQ(relation_both_ways(ball, sphere_set({3, 4, 0}, 3)), touching);
  EXPECT_EQ(relation_both_ways(ball, sphere_set({3, 4, 0}, 3 - 0x1p-50)), apart);
  EXPECT_EQ(relation_both_ways(ball, sphere_set({3, 4, 0}, 3 + 0x1p-50)), overlapping());
  EXPECT_EQ(relation_both_ways(ball, sphere_set({0, 1, 0}, 1)), overlapping(Containment::b_in_a));
  EXPECT_EQ(relation_both_ways(ball, ball), overlapping(Containment::equal));
  EXPECT_EQ(relation_both_ways(ball, sphere_set({0, 1, 0}, 1.5)), overlapping());
}

TEST(OracleConvex, SpheresAndBoxes) {
  EXPECT_EQ(relation_both_ways(unit_box, sphere_set({1 + 3, 1 + 4, 0.5}, 5)), touching);
  EXPECT_EQ(relation_both_ways(unit_box, sphere_set({0.5, 0.5, 0.5}, 0.5)), overlapping(Containment::b_in_a));
  EXPECT_EQ(relation_both_ways(unit_box, sphere_set({0.5, 0.5, 0.5}, 0.5 + 0x1p-52)), overlapping());
  EXPECT_EQ(relation_both_ways(unit_box, sphere_set({0.5, 0.5, 0.5}, 1)), overlapping(Containment::a_in_b));
}

TEST(OracleConvex, CapsulesAreRoundAtTheirEndsOnly) {
  const ConvexSet capsule = capsule_set({0, 0, 0}, {10, 0, 0}, 1);
  EXPECT_EQ(relation_both_ways(capsule, sphere_set({5, 3, 0}, 2)), touching);
  EXPECT_EQ(relation_both_ways(capsule, sphere_set({13, 4, 0}, 4)), touching);
  EXPECT_EQ(relation_both_ways(capsule, capsule_set({2, 0, 0}, {3, 0, 0}, 1)), overlapping(Containment::b_in_a));
  EXPECT_EQ(relation_both_ways(capsule, capsule_set({5, -9, 2}, {5, 9, 2}, 1)), touching);
}

TEST(OracleConvex, SurfacesAndBodies) {
  EXPECT_EQ(relation_both_ways(point_set({0.5, 0.5, 0.5}), unit_box), crossing(Containment::a_in_b));
  EXPECT_EQ(relation_both_ways(point_set({0.5, 0.5, 1}), unit_box), touching);
  EXPECT_EQ(relation_both_ways(segment_set({0, 0, 0}, {1, 1, 0}), unit_box), touching);
  EXPECT_EQ(relation_both_ways(segment_set({0, 0, 0}, {1, 1, 1}), unit_box), crossing());
  EXPECT_EQ(relation_both_ways(triangle_set({-1, 0.5, 0}, {2, 0.5, 0}, {0.5, 0.5, 3}), unit_box), crossing());
  EXPECT_EQ(relation_both_ways(triangle_set({-1, 1, 0}, {2, 1, 0}, {0.5, 1, 3}), unit_box), touching);
  EXPECT_EQ(relation_both_ways(point_set({3, 4, 0}), sphere_set({0, 0, 0}, 5)), touching);
}

TEST(OracleConvex, SurfacesCrossOnlyOutOfOnePlane) {
  const ConvexSet triangle = triangle_set({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
  EXPECT_EQ(relation_both_ways(triangle, segment_set({1, 1, -1}, {1, 1, 1})), crossing());
  EXPECT_EQ(relation_both_ways(triangle, segment_set({1, 1, 0}, {1, 1, 1})), surfaces_touching);
  EXPECT_EQ(relation_both_ways(triangle, segment_set({0, 0, 0}, {1, 1, 0})), surfaces_touching);
  EXPECT_EQ(relation_both_ways(triangle, point_set({1, 1, 0})), surfaces_touching);
  EXPECT_EQ(relation_both_ways(triangle, point_set({1, 1, 1})), apart);
}

TEST(OracleConvex, HalfSpaces) {
  const HalfSpace below = half_space_set({0, 0, 0}, {0, 0, 2});
  EXPECT_EQ(relation(unit_box, below), touching);
  EXPECT_EQ(relation(box({0, 0, -1}, {1, 1, 0}), below), overlapping(Containment::a_in_b));
  EXPECT_EQ(relation(box({0, 0, -1}, {1, 1, 1}), below), overlapping());
  EXPECT_EQ(relation(box({0, 0, 1}, {1, 1, 2}), below), apart);
  EXPECT_EQ(compare_distance(box({0, 0, 1}, {1, 1, 2}), below, 1), 0);
  EXPECT_EQ(relation(sphere_set({0, 0, 3}, 3), below), touching);
  EXPECT_EQ(relation(sphere_set({0, 0, -3}, 3), below), overlapping(Containment::a_in_b));
  EXPECT_EQ(relation(point_set({0, 0, 0}), below), touching);
  EXPECT_EQ(relation(point_set({0, 0, -1}), below), crossing(Containment::a_in_b));
  // 3-4-5: the plane 3x + 4y = 0 is five away from (3, 4, 0).
  EXPECT_EQ(relation(sphere_set({3, 4, 0}, 5), half_space_set({0, 0, 0}, {3, 4, 0})), touching);
  EXPECT_EQ(relation(below, half_space_set({0, 0, 0}, {0, 0, -1})), touching);
  EXPECT_EQ(relation(below, half_space_set({0, 0, 1}, {0, 0, -1})), apart);
  EXPECT_EQ(relation(below, half_space_set({0, 0, 1}, {0, 0, 1})), overlapping(Containment::a_in_b));
  EXPECT_EQ(relation(below, half_space_set({0, 0, 1}, {1, 0, 1})), overlapping());
}

ConvexSet random_hull(Random& random) {
  std::vector<Vec3> vertices(1 + random.below(5));
  for (Vec3& v : vertices)
    v = {static_cast<double>(random.below(4)), static_cast<double>(random.below(4)),
         static_cast<double>(random.below(4))};
  return hull_set(vertices);
}

TEST(OracleConvex, RandomHullsAgreeWithTheirFlip) {
  const std::uint64_t seed = 7;
  Random random(seed);
  for (int round = 0; round < 60; ++round) {
    SCOPED_TRACE("seed 7 round " + std::to_string(round));
    ConvexSet a = random_hull(random);
    ConvexSet b = random_hull(random);
    relation_both_ways(a, b);
    relation_both_ways(rounded(a, 1), rounded(b, 0.5));
    relation_both_ways(rounded(a, 1), b);
  }
}

/// By the planes through every three points of the body that have all others on one side.
bool ball_is_in(const RationalPoint& centre, const Rational& radius, const std::vector<RationalPoint>& body) {
  for (const RationalPoint& p : body)
    for (const RationalPoint& q : body)
      for (const RationalPoint& r : body) {
        const HalfSpace h = half_space(p, cross(q - p, r - p));
        if (is_zero(h.normal)) continue;
        if (!std::ranges::all_of(body, [&](const RationalPoint& v) { return height_above(h, v) <= 0; })) continue;
        const Rational height = height_above(h, centre);
        if (height > 0 || height * height < radius * radius * dot(h.normal, h.normal)) return false;
      }
  return true;
}

// On a small grid many points are equal, in line or in one plane.
TEST(OracleConvex, BallsLieInHullsWithinAllTheirPlanes) {
  const std::uint64_t seed = 4;
  Random random(seed);
  const auto whole = [&](std::uint64_t size) { return static_cast<double>(random.below(size)); };
  int inside = 0;
  for (int round = 0; round < 150; ++round) {
    std::vector<Vec3> points(5 + random.below(9));
    for (Vec3& v : points) {
      const double x = whole(5), y = whole(5);
      v = {x, y, whole(5)};
    }
    const ConvexSet hull = hull_set(points);
    if (!is_solid(hull)) continue;
    const double x = 1 + whole(3), y = 1 + whole(3);
    const ConvexSet ball = sphere_set({x, y, 1 + whole(3)}, (1 + whole(8)) / 8);
    const bool truth = ball_is_in(ball.vertices[0], ball.radius, hull.vertices);
    ASSERT_EQ(relation(ball, hull) == overlapping(Containment::a_in_b), truth) << "seed " << seed << " round " << round;
    inside += truth ? 1 : 0;
  }
  EXPECT_GT(inside, 10);
}

TEST(OracleConvex, AgreesWithTheClippingOfTriangles) {
  const std::uint64_t seed = 8;
  Random random(seed);
  const auto coordinate = [&] { return static_cast<double>(random.below(4)); };
  for (int round = 0; round < 300; ++round) {
    std::array<Vec3, 6> v{};
    for (Vec3& vertex : v) vertex = {coordinate(), coordinate(), coordinate()};
    const CommonSet common = common_set(exact(Triangle{{{v[0], v[1], v[2]}}}), exact(Triangle{{{v[3], v[4], v[5]}}}));
    const Relation hulls = relation(triangle_set(v[0], v[1], v[2]), triangle_set(v[3], v[4], v[5]));
    ASSERT_EQ(common.kind == CommonSetKind::none, hulls.kind == RelationKind::apart) << "seed 8 round " << round;
    ASSERT_EQ(common.crossing, hulls.kind == RelationKind::crossing) << "seed 8 round " << round;
  }
}

}  // namespace
}  // namespace toccata::oracle
