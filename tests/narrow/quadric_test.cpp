#include "toccata/narrow/quadrics.hpp"

#include <functional>

#include <gtest/gtest.h>

#include "toccata/core/error.hpp"
#include "toccata/math/pose.hpp"

namespace toccata::test {
namespace {

std::string refusal_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(QuadricShape, RefusesWhatIsNoSolid) {
  EXPECT_EQ(refusal_of([] { Cylinder(0, 1); }), "the radius of a cylinder is 0; give a positive finite number");
  EXPECT_EQ(refusal_of([] { Cylinder(1, -1); }), "the half height of a cylinder is -1; give a positive finite number");
  EXPECT_EQ(refusal_of([] { Cone(HUGE_VAL, 1); }), "the radius of a cone is inf; give a positive finite number");
  EXPECT_EQ(refusal_of([] {
              Ellipsoid({1, 0, 1});
            }),
            "the half axis along y of an ellipsoid is 0; give a positive finite number");
  Pose flat;
  flat.linear[2] = {0, 0, 0};
  EXPECT_NE(refusal_of([&] { PosedQuadric(Cone(1, 1), flat); }).find("the cone: the pose"), std::string::npos);
  EXPECT_NE(refusal_of([&] { PosedQuadric(Cone(1, 1), flat); }).find("singular"), std::string::npos);
  EXPECT_NE(refusal_of([] {
              PosedQuadric(Ellipsoid({1e308, 1, 1}), Pose::translation(1e308, 0, 0));
            }).find("beyond the finite numbers"),
            std::string::npos);
}

// Exactly touching: none of these may be called apart.
TEST(Quadric, TouchingCountsAsContact) {
  const PosedPolytope box(Box({1, 1, 1}));
  const PosedQuadric standing(Cylinder(1, 2), Pose::translation(0, 0, 3));
  EXPECT_TRUE(overlap(standing, box));
  EXPECT_TRUE(overlap(PosedQuadric(Cylinder(2, 1), Pose::translation(3, 0, 0)), box));
  EXPECT_TRUE(overlap(PosedQuadric(Cylinder(1, 2)), PosedQuadric(Cylinder(3, 2), Pose::translation(4, 0, 1))));
  EXPECT_TRUE(overlap(PosedQuadric(Cylinder(1, 2)), PosedQuadric(Cylinder(1, 2), Pose::translation(0.5, 0, 4))));
  const PosedHalfSpace floor(HalfSpace({0, 0, 0}, {0, 0, 1}));
  Pose upside_down = Pose::translation(5, 7, 2);
  upside_down.linear = rotation_about({1, 0, 0}, 180);
  EXPECT_TRUE(overlap(PosedQuadric(Cone(1, 2), upside_down), floor));
  EXPECT_TRUE(overlap(box, PosedQuadric(Ellipsoid({2, 3, 4}), Pose::translation(3, 0.25, 0.5))));
  EXPECT_TRUE(
      overlap(PosedQuadric(Ellipsoid({2, 3, 4})), PosedQuadric(Ellipsoid({1, 5, 2}), Pose::translation(3, 0, 0))));
  EXPECT_NE(quadric_contact(standing, box), QuadricContact::apart);
}

TEST(Quadric, ALastPlaceAwayIsApart) {
  const PosedPolytope box(Box({1, 1, 1}));
  const double height = std::nextafter(3.0, 4);
  const PosedQuadric standing(Cylinder(1, 2), Pose::translation(0, 0, height));
  EXPECT_EQ(quadric_contact(standing, box), QuadricContact::apart);
  const Distance gap = distance(standing, box);
  EXPECT_LE(gap.lower, height - 3);
  EXPECT_GE(gap.upper, height - 3);
  EXPECT_EQ(gap.status, Status::exact);
  EXPECT_EQ(quadric_contact(PosedQuadric(Cylinder(1, 2), Pose::translation(0, 0, std::nextafter(3.0, 2))), box),
            QuadricContact::contact);
}

// They overlap by 1.4 · 10⁻¹² of their size: in doubles, every simplex is flat.
TEST(Quadric, ASegmentThroughTheRimOfAThinConeIsContact) {
  Pose pose;
  pose.linear[0] = {0.7774575494195296, -0.57600732356902762, 0.25253776360264479};
  pose.linear[1] = {0.46750987758482554, 0.79786990455755658, 0.38057604990584626};
  pose.linear[2] = {-0.42070687326356015, -0.17781782418014572, 0.88959909408263105};
  const PosedQuadric cone(Cone(0.10103362791335602, 1.2000488382898523e-05), pose);
  const PosedPolytope segment(Segment({0.070545302343421323, 0.057056543158901074, -0.044448906770015673},
                                      {-0.64762615353316211, 0.24668519331909555, 1.0941304582354512}));
  EXPECT_EQ(quadric_contact(cone, segment), QuadricContact::contact);
  const Distance found = distance(cone, segment);
  EXPECT_EQ(found.status, Status::exact);
  EXPECT_EQ(found.upper, 0);
  EXPECT_EQ(found.on_a, found.on_b);
  const PosedPolytope point{Point(found.on_a)};
  EXPECT_LE(distance(cone, point).upper, 1e-15);
  EXPECT_LE(distance(segment, point).upper, 1e-15);
}

// The tip of a needle is 1.3843441189782 · 10⁻¹² before an edge: the lower end was 4 · 10⁻¹⁷ more.
TEST(Quadric, ANeedleBesideAnEdgeIsNoFartherThanItIs) {
  Pose pose;
  pose.linear[0] = {0.2838305671586695, -0.93522719016584166, -0.21163721771203861};
  pose.linear[1] = {0.86294280437027371, 0.1529069392595693, 0.48161103009777301};
  pose.linear[2] = {-0.41805493123745796, -0.31932674598407068, 0.85044723749758255};
  const PosedQuadric needle(Cone(2.4354780584330685e-06, 1.3221214532741807), pose);
  const PosedPolytope triangle(Triangle({Vec3{-0.00038693981545928624, 1.8369359908678056, -0.089337502881010056},
                                         Vec3{-0.27981010585004251, 0.63674827502257947, 1.1243945375746023},
                                         Vec3{-0.79643484584762747, 1.0046820897295592, 0.49431164234743397}}));
  const Distance found = distance(needle, triangle);
  EXPECT_GT(found.lower, 0);
  EXPECT_LE(found.lower, found.upper);
  EXPECT_LE(found.lower, 1.38434411899e-12);
}

TEST(Quadric, DistancesOfSimplePairs) {
  const PosedQuadric ball(Ellipsoid({1, 1, 1}), Pose::translation(3, 4, 0));
  const Distance d = distance(ball, PosedPolytope(Point({0, 0, 0})));
  EXPECT_LE(d.lower, 4);
  EXPECT_GE(d.upper, 4);
  EXPECT_LE(d.upper - d.lower, 4e-12);
  EXPECT_EQ(d.status, Status::exact);
  const Distance above =
      distance(PosedQuadric(Cone(1, 1), Pose::translation(0, 0, 5)), PosedHalfSpace(HalfSpace({0, 0, 1}, {0, 0, 2})));
  EXPECT_LE(above.lower, 3);
  EXPECT_GE(above.upper, 3);
  EXPECT_NEAR(above.on_b.z, 1, 1e-15);
}

TEST(Quadric, RelationAndPenetrationOfAHalfSpace) {
  const PosedHalfSpace floor(HalfSpace({0, 0, 0}, {0, 0, 1}));
  const PosedQuadric sunk(Cylinder(1, 2), Pose::translation(0, 0, 1.5));
  EXPECT_EQ(relation(sunk, floor).kind, RelationKind::overlapping);
  EXPECT_EQ(relation(PosedQuadric(Cone(1, 2), Pose::translation(0, 0, -3)), floor).containment, Containment::a_in_b);
  EXPECT_EQ(relation(PosedQuadric(Cone(1, 2), Pose::translation(0, 0, 2)), floor).kind, RelationKind::touching);
  const Penetration depth = penetration(sunk, floor);
  EXPECT_LE(depth.lower, 0.5);
  EXPECT_GE(depth.upper, 0.5);
  EXPECT_EQ(depth.status, Status::exact);
  EXPECT_EQ(depth.direction, (Vec3{0, 0, -1}));
}

TEST(Quadric, AHalfSpaceMayComeFirst) {
  const PosedHalfSpace floor(HalfSpace({0, 0, 0}, {0.6, 0, 0.8}));
  const PosedQuadric sunk(Cylinder(1, 2), Pose::translation(0.3, 0.2, 0.7));
  const Relation lie = relation(sunk, floor), seen = relation(floor, sunk);
  EXPECT_EQ(seen.kind, lie.kind);
  EXPECT_EQ(relation(floor, PosedQuadric(Cone(1, 2), Pose::translation(0, 0, -9))).containment, Containment::b_in_a);
  const Penetration depth = penetration(sunk, floor), flipped_depth = penetration(floor, sunk);
  EXPECT_GT(depth.lower, 0);
  EXPECT_EQ(flipped_depth.lower, depth.lower);
  EXPECT_EQ(flipped_depth.upper, depth.upper);
  EXPECT_EQ(flipped_depth.direction, -depth.direction);
  EXPECT_EQ(flipped_depth.on_a, depth.on_b);
  EXPECT_EQ(flipped_depth.on_b, depth.on_a);
  const PosedQuadric above(Cone(1, 1), Pose::translation(0, 0, 5));
  const Vec3 motion{0.5, -0.25, -8};
  const std::optional<Cast> falls = cast_shape(above, motion, floor), rises = cast_shape(floor, -motion, above);
  ASSERT_TRUE(falls);
  EXPECT_EQ(rises->lower, falls->lower);
  EXPECT_EQ(rises->upper, falls->upper);
  EXPECT_EQ(rises->normal, -falls->normal);
}

// With integers 3, 4, 5 and 12 all heights are whole: the last place of a coordinate decides.
TEST(Quadric, AgainstHalfSpacesEveryAnswerIsExact) {
  const auto expect_touching = [](const auto& shape, const Vec3& place, const PosedHalfSpace& wall) {
    const PosedQuadric touching(shape, Pose{{}, place});
    EXPECT_EQ(quadric_contact(touching, wall), QuadricContact::contact);
    EXPECT_EQ(relation(touching, wall).kind, RelationKind::touching);
    EXPECT_EQ(relation(touching, wall).status, Status::exact);
    EXPECT_EQ(distance(touching, wall).upper, 0);
    EXPECT_EQ(distance(touching, wall).status, Status::exact);
    EXPECT_EQ(penetration(touching, wall).upper, 0);
    EXPECT_EQ(cast_shape(touching, {1, 0, 0}, wall)->status, Status::exact);
    const Vec3 out{std::nextafter(place.x, 1e9), place.y, place.z}, in{std::nextafter(place.x, -1e9), place.y, place.z};
    EXPECT_EQ(quadric_contact(PosedQuadric(shape, Pose{{}, out}), wall), QuadricContact::apart);
    EXPECT_GT(distance(PosedQuadric(shape, Pose{{}, out}), wall).upper, 0);
    EXPECT_EQ(relation(PosedQuadric(shape, Pose{{}, in}), wall).kind, RelationKind::overlapping);
  };
  expect_touching(Ellipsoid({1, 1, 1}), {3, -1, 0}, PosedHalfSpace(HalfSpace({0, 0, 0}, {3, 4, 0})));
  expect_touching(Cylinder(1, 2), {3, -1, 2}, PosedHalfSpace(HalfSpace({0, 0, 0}, {3, 4, 12})));
  expect_touching(Cone(1, 2), {3, -1, 2}, PosedHalfSpace(HalfSpace({0, 0, 0}, {3, 4, 12})));
  expect_touching(Cone(1, 2), {4, -3, -2}, PosedHalfSpace(HalfSpace({0, 0, 0}, {3, 4, -12})));
  // Its highest point lies in the plane.
  const Relation held =
      relation(PosedQuadric(Cylinder(1, 2), Pose::translation(-3, 1, -2)), PosedHalfSpace(HalfSpace({}, {3, 4, 12})));
  EXPECT_EQ(held.containment, Containment::a_in_b);
}

TEST(Quadric, HalfSpacesMayHaveAnyNormalAndPoint) {
  const PosedQuadric above(Cylinder(1, 1), Pose::translation(0, 0, 3));
  const auto expect_gap = [](const PosedQuadric& shape, const HalfSpace& wall, double gap) {
    const Distance found = distance(shape, PosedHalfSpace(wall));
    EXPECT_LE(found.lower, gap);
    EXPECT_GE(found.upper, gap);
    EXPECT_LE(found.upper - found.lower, 1e-12 * gap);
    EXPECT_EQ(found.on_b.z, 0);
  };
  expect_gap(above, HalfSpace({0, 0, 0}, {0, 0, 5e-324}), 2);
  expect_gap(above, HalfSpace({0, 0, 0}, {0, 0, 1e308}), 2);
  expect_gap(above, HalfSpace({1e308, -1e308, 0}, {0, 0, 1}), 2);
  expect_gap(PosedQuadric(Cylinder(1, 1), Pose::translation(-1e308, 0, 3)), HalfSpace({1e308, 0, 0}, {0, 0, 1}), 2);
  for (const double size : {1e-100, 1e-200, 1e-300, 1e-310})
    expect_gap(PosedQuadric(Ellipsoid({size, size, size}), Pose::translation(0, 0, 2)), HalfSpace({}, {0, 0, 1}), 2);
}

TEST(Quadric, ATinyShapeInTheMiddleOfAnotherIsInContact) {
  const PosedPolytope box(Box({1, 1, 1})), ball(Sphere(1));
  const PosedQuadric can(Cylinder(1, 1));
  const PosedHalfSpace below(HalfSpace({0, 0, 1}, {0, 0, 1}));
  for (const double size : {1e-30, 1e-150, 1e-300, 1e-310})
    for (const PosedQuadric& tiny : {PosedQuadric(Cylinder(size, size)), PosedQuadric(Cone(size, size)),
                                     PosedQuadric(Ellipsoid({size, size, size}))}) {
      EXPECT_EQ(quadric_contact(tiny, box), QuadricContact::contact) << size;
      EXPECT_EQ(quadric_contact(tiny, ball), QuadricContact::contact) << size;
      EXPECT_EQ(quadric_contact(tiny, can), QuadricContact::contact) << size;
      EXPECT_EQ(quadric_contact(tiny, below), QuadricContact::contact) << size;
      EXPECT_EQ(distance(tiny, box).status, Status::exact) << size;
      EXPECT_EQ(relation(tiny, box).kind, RelationKind::overlapping) << size;
      const Penetration depth = penetration(tiny, box);
      EXPECT_LE(depth.lower, 1) << size;
      EXPECT_GE(depth.upper, 1) << size;
      EXPECT_LE(depth.upper, 1 + 1e-12) << size;
      const Penetration sunk = penetration(tiny, below);
      EXPECT_LE(sunk.lower, 1) << size;
      EXPECT_GE(sunk.upper, 1) << size;
    }
}

// Whole numbers, faces, rims, sides and tips in parallel: the exact gap is 0, whichever axis they lie along.
TEST(Quadric, TouchingAlongEveryAxisCountsAsContact) {
  const PosedPolytope box(Box({1, 1, 1}));
  const auto expect_touch = [](const auto& a, const auto& b, const char* how) {
    EXPECT_TRUE(overlap(a, b)) << how;
    EXPECT_EQ(quadric_contact(a, b), QuadricContact::contact) << how;
    EXPECT_EQ(quadric_contact(b, a), QuadricContact::contact) << how;
    EXPECT_EQ(distance(a, b).status, Status::exact) << how;
    EXPECT_EQ(distance(a, b).upper, 0) << how;
  };
  const Vec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int turn = 0; turn < 3; ++turn)
    for (const double sign : {-1.0, 1.0}) {
      Pose pose;
      for (int i = 0; i < 3; ++i) pose.linear[i] = axes[(i + turn) % 3];
      const int up = [&] {
        for (int i = 0; i < 3; ++i)
          if (pose.linear[i].z == 1) return i;
        return 2;
      }();
      const auto at = [&](int axis, double distance) {
        Pose placed = pose;
        placed.offset[axis] = sign * distance;
        return placed;
      };
      const int across = (up + 1) % 3;
      expect_touch(PosedQuadric(Cylinder(2, 3), at(up, 4)), box, "standing");
      expect_touch(PosedQuadric(Cylinder(2, 3), at(across, 3)), box, "lying");
      expect_touch(PosedQuadric(Cone(2, 3), at(up, 4)), box, "on its base, or its tip");
      expect_touch(PosedQuadric(Ellipsoid({2, 2, 3}), at(up, 4)), box, "on its pole");
      expect_touch(PosedQuadric(Ellipsoid({2, 2, 3}), at(across, 3)), box, "on its side");
      expect_touch(PosedQuadric(Cylinder(2, 3), at(up, 6)), PosedQuadric(Cylinder(1, 3), pose), "two quadrics");
      expect_touch(PosedQuadric(Cylinder(2, 3), at(across, 3)), PosedQuadric(Cylinder(1, 3), pose), "two quadrics");
      expect_touch(PosedQuadric(Ellipsoid({2, 2, 3}), at(up, 5)), PosedQuadric(Cylinder(1, 2), pose), "two quadrics");
      expect_touch(PosedQuadric(Cylinder(2, 3), at(across, 4)), PosedPolytope(Sphere(2)), "at a ball");
    }
}

TEST(Quadric, DepthOfABallInAWall) {
  const Penetration p =
      penetration(PosedQuadric(Ellipsoid({1, 1, 1}), Pose::translation(0, 0, 2.75)), PosedPolytope(Box({5, 5, 2})));
  EXPECT_LE(p.lower, 0.25);
  EXPECT_GE(p.upper, 0.25);
  EXPECT_LE(p.upper, 0.25 * (1 + 1e-12));
  EXPECT_NEAR(p.direction.z, -1, 1e-12);
  EXPECT_NE(refusal_of([] {
              (void)penetration(PosedQuadric(Cone(1, 1)), PosedPolytope(Point({0, 0, 0})));
            }).find("surface"),
            std::string::npos);
}

TEST(Quadric, RaysEnterWhereTheyShould) {
  const PosedQuadric tower(Cylinder(2, 5));
  const std::optional<Cast> side = cast_ray({10, 0, 1}, {-16, 0, 0}, tower);
  ASSERT_TRUE(side);
  EXPECT_LE(side->lower, 0.5);
  EXPECT_GE(side->upper, 0.5);
  EXPECT_EQ(side->normal, (Vec3{1, 0, 0}));
  EXPECT_FALSE(cast_ray({10, 0, 6}, {-16, 0, 0}, tower));
  EXPECT_TRUE(cast_ray({10, 0, 5}, {-16, 0, 0}, tower)) << "along the edge of the cap";
  EXPECT_TRUE(cast_ray({2, 0, 10}, {0, 0, -20}, tower)) << "down the side";
  const std::optional<Cast> tip = cast_ray({0, 0, 9}, {0, 0, -8}, PosedQuadric(Cone(1, 5)));
  ASSERT_TRUE(tip);
  EXPECT_LE(tip->lower, 0.5);
  EXPECT_GE(tip->upper, 0.5);
  EXPECT_NE(refusal_of([&] { (void)cast_ray({0, 0, 0}, {0, 0, 0}, tower); }).find("motion is zero"), std::string::npos);
}

TEST(Quadric, ARayThatEntersAtATipComesFromBeforeItsNormal) {
  const double radius = 3.9285255105366881, half = 14.952253068946977;
  const Mat3 turn{{{{0.99999999999940514, 6.4816867930369634e-07, 8.7721805547116462e-07},
                    {-6.4816732247356271e-07, 0.99999999999859368, -1.5467169729482058e-06},
                    {-8.7721905801935337e-07, 1.5467164043541758e-06, 0.99999999999841893}}}};
  const PosedQuadric cone(Cone(radius, half), {turn, {-4, 4, 3}});
  const Vec3 motion{200.0144687601516, 0.0022253091688870558, -1522.5494966590602};
  const std::optional<Cast> cast =
      cast_ray({-3.9999868836136381, 3.9999768730963945, 17.952253068923337}, motion, cone);
  ASSERT_TRUE(cast);
  EXPECT_LT(dot(cast->normal, motion), 0);
  for (const Vec3& aside : {Vec3{}, Vec3{0x1p-53, 0, 0}, Vec3{0, -0x1p-50, 0}})
    EXPECT_LT(dot(cast_ray(Vec3{0.25, 0, 9} + aside, {-0.5, 0, -8}, PosedQuadric(Cone(1, 5)))->normal, {-0.5, 0, -8}),
              0);
}

TEST(Quadric, AFallingConeMeetsTheFloor) {
  const PosedQuadric cone(Cone(1, 1), Pose::translation(0, 0, 5));
  const std::optional<Cast> cast = cast_shape(cone, {0, 0, -8}, PosedHalfSpace(HalfSpace({0, 0, 0}, {0, 0, 1})));
  ASSERT_TRUE(cast);
  EXPECT_LE(cast->lower, 0.5);
  EXPECT_GE(cast->upper, 0.5);
  const std::optional<Cast> onto_box =
      cast_shape(cone, {0, 0, -8}, PosedPolytope(Box({3, 3, 1}), Pose::translation(0, 0, -1)));
  EXPECT_LE(onto_box->lower, 0.5);
  EXPECT_GE(onto_box->upper, 0.5);
  EXPECT_LE(onto_box->upper - onto_box->lower, 0x1p-40);
  EXPECT_FALSE(cast_shape(cone, {0, 0, 8}, PosedPolytope(Box({3, 3, 1}))));
}

}  // namespace
}  // namespace toccata::test
