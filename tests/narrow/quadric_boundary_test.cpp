// Nearest points of the boundaries of quadrics, their sides, and what holds what.
#include <cmath>

#include <gtest/gtest.h>

#include "toccata/math/pose.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {
namespace {

void expect_depth_of_quadric(const PosedQuadric& shape, const Vec3& point, double depth) {
  const BoundaryPoint found = boundary_point(point, shape);
  EXPECT_EQ(found.side, Sign::negative);
  EXPECT_EQ(found.status, Status::exact);
  EXPECT_LE(found.upper - found.lower, 1e-12 * found.upper);
  EXPECT_NEAR(found.upper, depth, 1e-12 * depth);
  const Vec3 way = found.point - point;
  EXPECT_NEAR(std::sqrt(dot(way, way)) / std::fmax(depth, 1), depth / std::fmax(depth, 1), 1e-12);
}

TEST(QuadricBoundary, ClosedForms) {
  const PosedQuadric ball(Ellipsoid({1, 1, 1})), can(Cylinder(1, 2)), cone(Cone(1, 1)), egg(Ellipsoid({1, 2, 3}));
  expect_depth_of_quadric(ball, {0, 0, 0}, 1);
  expect_depth_of_quadric(ball, {0.5, 0, 0}, 0.5);
  expect_depth_of_quadric(ball, {1 - 0x1p-40, 0, 0}, 0x1p-40);
  expect_depth_of_quadric(can, {0, 0, 0}, 1);
  expect_depth_of_quadric(can, {0.125, 0, 1.5}, 0.5);
  expect_depth_of_quadric(can, {0.75, 0, -1}, 0.25);
  expect_depth_of_quadric(cone, {0, 0, -0.875}, 0.125);
  expect_depth_of_quadric(cone, {0, 0, 0}, 1 / std::sqrt(5.0));
  expect_depth_of_quadric(cone, {0, 0, 1 - 0x1p-30}, 0x1p-30 / std::sqrt(5.0));
  // On the axes of an ellipsoid the nearest points leave the axis where it bends less: x² = a² (1 − z² / (c² − a²)).
  expect_depth_of_quadric(egg, {0, 0, 0}, 1);
  expect_depth_of_quadric(egg, {0, 0, 2}, std::sqrt(0.5));
  expect_depth_of_quadric(egg, {0, 0, 2.875}, 0.125);
}

TEST(QuadricBoundary, OfNeedlesPlatesAndFarPlaces) {
  const Pose turned{rotation_about({0.36, 0.48, 0.8}, 30), {5, 6, 7}};
  expect_depth_of_quadric(PosedQuadric(Ellipsoid({1e-6, 1e-6, 1}), turned), {5, 6, 7}, 1e-6);
  expect_depth_of_quadric(PosedQuadric(Ellipsoid({1, 1, 1e-6}), turned), {5, 6, 7}, 1e-6);
  expect_depth_of_quadric(PosedQuadric(Cylinder(1e-6, 1), turned), {5, 6, 7}, 1e-6);
  expect_depth_of_quadric(PosedQuadric(Cylinder(1, 1), Pose::translation(1e8, 1e8, 1e8)), {1e8 + 0.75, 1e8, 1e8}, 0.25);
  expect_depth_of_quadric(PosedQuadric(Ellipsoid({0x1p-100, 0x1p-99, 0x1p-98})), {}, 0x1p-100);
  expect_depth_of_quadric(PosedQuadric(Cone(0x1p100, 0x1p100)), {}, 0x1p100 / std::sqrt(5.0));
}

TEST(QuadricBoundary, SidesAreExact) {
  const PosedQuadric ball(Ellipsoid({5, 5, 5})), can(Cylinder(5, 2)), cone(Cone(2, 2));
  EXPECT_EQ(side_of({3, 4, 0}, ball), Sign::zero);
  EXPECT_EQ(side_of({3, 4, 0x1p-500}, ball), Sign::positive);
  EXPECT_EQ(side_of({3, std::nextafter(4, 0), 0}, ball), Sign::negative);
  EXPECT_EQ(side_of({3, 4, 1}, can), Sign::zero);
  EXPECT_EQ(side_of({3, 4, std::nextafter(2, 3)}, can), Sign::positive);
  EXPECT_EQ(side_of({1, 1, 2}, can), Sign::zero);
  EXPECT_EQ(side_of({0, 0, 2}, cone), Sign::zero);
  EXPECT_EQ(side_of({1, 0, 0}, cone), Sign::zero);
  EXPECT_EQ(side_of({1, 0, std::nextafter(0, -1)}, cone), Sign::negative);
  EXPECT_EQ(side_of({0, 0, 6}, cone), Sign::positive);  // within the other half of the double cone
  const BoundaryPoint on = boundary_point({3, 4, 0}, ball);
  EXPECT_EQ(on.upper, 0);
  EXPECT_EQ(on.point, (Vec3{3, 4, 0}));
  // The farthest double within: how near it is takes more digits than there are, and is told as an interval.
  const BoundaryPoint beside = boundary_point({3, std::nextafter(4, 0), 0}, ball);
  EXPECT_EQ(beside.side, Sign::negative);
  EXPECT_GT(beside.upper, 0);
  EXPECT_NEAR(beside.upper, 0.8 * (4 - std::nextafter(4, 0)), 1e-20);
}

template <class A, class B>
void expect_held(const A& held, const B& holder) {
  EXPECT_EQ(relation(held, holder).containment, Containment::a_in_b);
  EXPECT_EQ(relation(holder, held).containment, Containment::b_in_a);
  EXPECT_EQ(relation(held, holder).status, Status::exact);
}

template <class A, class B>
void expect_none(const A& a, const B& b, Status status) {
  EXPECT_EQ(relation(a, b).kind, RelationKind::overlapping);
  EXPECT_EQ(relation(a, b).containment, Containment::none);
  EXPECT_EQ(relation(a, b).status, status);
  EXPECT_EQ(relation(b, a).status, status);
}

TEST(QuadricContainment, OfEveryKindInEveryKind) {
  const PosedQuadric egg(Ellipsoid({1, 1, 1.5})), can(Cylinder(1, 1)), cone(Cone(1, 1));
  const auto small = [](const auto& shape) { return PosedQuadric(shape, Pose::translation(0.01, 0.02, -0.1)); };
  for (const PosedQuadric& holder : {egg, can, cone}) {
    expect_held(small(Ellipsoid({0.2, 0.3, 0.4})), holder);
    expect_held(small(Cylinder(0.2, 0.3)), holder);
    expect_held(small(Cone(0.3, 0.4)), holder);
    expect_held(PosedPolytope(Sphere(0.3)), holder);
    expect_held(PosedPolytope(Capsule({0, 0, -0.2}, {0, 0, 0.2}, 0.2)), holder);
    expect_held(PosedPolytope(Rounded(Box({0.1, 0.1, 0.2}), 0.1)), holder);
    expect_held(PosedPolytope(Box({0.2, 0.2, 0.2})), holder);
    expect_held(PosedPolytope(Segment({0, 0, -0.3}, {0.1, 0, 0.3})), holder);
    expect_held(holder, PosedPolytope(Box({1.5, 1.5, 2})));
    expect_held(holder, PosedPolytope(Sphere(2)));
    expect_held(holder, PosedPolytope(Capsule({0, 0, -1}, {0, 0, 1}, 1.25)));
    expect_held(holder, PosedPolytope(Rounded(Box({0.5, 0.5, 1}), 0.75)));
    expect_held(holder, PosedQuadric(Ellipsoid({2, 2, 2.5})));
    expect_held(holder, PosedQuadric(Cylinder(1.25, 1.75)));
    expect_held(holder, PosedQuadric(Cone(4, 4)));
    expect_none(holder, PosedPolytope(Sphere(0.875), Pose::translation(0.5, 0, 0)), Status::exact);
    EXPECT_EQ(relation(holder, holder).containment, Containment::equal);
  }
}

/// The ball in the cone with the apex angle of 60°, the box in the ball: a little less and a little more.
TEST(QuadricContainment, IsDecidedToTheLastDigits) {
  const PosedQuadric cone(Cone(std::sqrt(3.0), 1.5)), ball(Ellipsoid({1, 1, 1})), can(Cylinder(1, 1));
  const Pose at = Pose::translation(0, 0, -0.5);
  expect_held(PosedPolytope(Sphere(1 - 1e-11), at), cone);
  expect_none(PosedPolytope(Sphere(1 + 1e-11), at), cone, Status::exact);
  expect_held(PosedPolytope(Sphere(1 - 1e-12)), can);
  expect_none(PosedPolytope(Sphere(1 + 1e-12)), can, Status::exact);
  expect_none(PosedPolytope(Sphere(1)), can, Status::undecided);
  expect_held(ball, PosedPolytope(Box({1 + 1e-12, 2, 2})));
  expect_none(ball, PosedPolytope(Box({1 - 1e-12, 2, 2})), Status::exact);
  // Corners of a solid may touch: what they are is exact.
  const PosedQuadric three(Ellipsoid({3, 3, 3}));
  expect_held(PosedPolytope(Box({1, 2, 2})), three);
  expect_none(PosedPolytope(Box({1, 2, std::nextafter(2, 3)})), three, Status::exact);
  // All of a surface has to be within.
  EXPECT_EQ(relation(three, PosedPolytope(Segment({0, 0, 3}, {0, 0, 0}))).containment, Containment::none);
}

}  // namespace
}  // namespace toccata
