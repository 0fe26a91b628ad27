#include "toccata/motion/rigid_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "query/search_scratch.hpp"
#include "support/error_message.hpp"
#include "support/rigid_cases.hpp"
#include "support/simd_levels.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/query/overlap.hpp"

namespace toccata::test {
namespace {

constexpr double quarter = 0.25;

/// About the z axis through the origin.
RigidMotion turned_about_z(const Pose& start, double turns) { return {start, {.turns = turns}}; }

bool have_common_time(const std::optional<ShapeHit>& x, const std::optional<ShapeHit>& y, double more = 0) {
  return x && y && x->lower <= y->upper + more && y->lower <= x->upper + more;
}

TEST(RigidSweep, ARodThatTurnsMeetsAPegWhenItsSideIsThere) {
  const double reach = std::hypot(0.6, 0.6), thickness = 0.02 + 0.05;
  const std::optional<ShapeHit> hit =
      sweep(Box({1, 0.02, 0.02}), turned_about_z({}, quarter), Sphere(0.05), Pose::translation(0.6, 0.6, 0));
  const double right_angle = std::acos(-1.0) / 2;
  const double expected = (right_angle / 2 - std::asin(thickness / reach)) / right_angle;
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->status, Status::exact);
  EXPECT_LE(hit->lower, expected + 1e-15);
  EXPECT_GE(hit->upper, expected - 1e-15);
  EXPECT_LT(hit->upper - hit->lower, 1e-11);
  const double angle = expected * right_angle;
  EXPECT_LT(length(hit->normal - Vec3{std::sin(angle), -std::cos(angle), 0}), 1e-6);
}

TEST(RigidSweep, WhatHasTurnedAllTheWayRoundHasMetWhatStoodInItsWay) {
  const Model rod = Box({1, 0.02, 0.02}), peg = Sphere(0.05);
  for (const double turns : {1.0, -1.0, 5.0, 100.5}) {
    EXPECT_TRUE(sweep(rod, turned_about_z({}, turns), peg, Pose::translation(0, 0.7, 0)));
    EXPECT_FALSE(sweep(rod, turned_about_z({}, turns), peg, Pose::translation(0, 1.06, 0)));
    EXPECT_FALSE(sweep(rod, turned_about_z({}, turns), peg, Pose::translation(0, 0.7, 0.071)));
  }
}

TEST(RigidSweep, TheNormalOfAHalfSpaceThatTurnsIsThatOfTheContact) {
  const RigidMotion tipping(Pose{}, {.axis = {0, 1, 0}, .turns = quarter});
  const std::optional<ShapeHit> hit =
      sweep(Sphere(0.1), Pose::translation(-1, 0, 0.5), HalfSpace({0, 0, 0}, {0, 0, 1}), tipping);
  ASSERT_TRUE(hit);
  EXPECT_LT(length(hit->normal - tipping.at(hit->lower).linear.column(2)), 1e-9);
}

TEST(RigidSweep, WithoutATurnItIsTheCast) {
  const Model a = Cylinder(0.3, 0.5), b = Model(torus_mesh({.radius = 1, .tube_radius = 0.3}));
  const Pose start = Pose::translation(-3, 0.2, 0.1);
  const std::optional<ShapeHit> hit = sweep(a, RigidMotion::straight(start, {6, 0, 0}), b, Pose{});
  EXPECT_EQ(hit, cast_shape(a, {6, 0, 0}, b, {.pose_a = start}));
  const std::optional<ShapeHit> both =
      sweep(a, RigidMotion::straight(start, {3, 0, 0}), b, RigidMotion::straight({}, {-3, 0, 0}));
  EXPECT_EQ(both->lower, hit->lower);
  EXPECT_LT(length(both->point - (hit->point + hit->upper * Vec3{-3, 0, 0})), 1e-15);
}

TEST(RigidSweep, WhatMeetsAtTheStartIsMetAtOnce) {
  const Model box = Box({1, 1, 1}), ball = Sphere(0.125);
  const RigidMotion away(Pose::translation(1.125, 0, 0), {.turns = 1, .translation = {5, 0, 0}});
  const std::optional<ShapeHit> touching = sweep(ball, away, box, Pose{});
  EXPECT_TRUE(touching.has_value() && touching->upper == 0 && touching->status == Status::exact);
  const RigidMotion inside(Pose{}, {.turns = 1});
  EXPECT_TRUE(sweep(ball, inside, Model(box_mesh({1, 1, 1})), Pose{}));
  EXPECT_FALSE(sweep(ball, inside, Model(box_mesh({1, 1, 1})), Pose{}, {.solid_b = Solid::none}));
}

TEST(RigidSweep, WhatMovesTogetherNeverMeets) {
  const RigidMove move{{1, 2, 3}, {1, 1, 0}, 3, {4, 5, 6}};
  const Model a = Box({1, 1, 1}), b = Capsule({0, 0, -1}, {0, 0, 1}, 0.4);
  EXPECT_FALSE(sweep(a, {Pose{}, move}, b, {Pose::translation(1.5, 0, 0), move}));
}

TEST(RigidSweep, AMeshOfABoxIsMetAsTheBox) {
  Random random(5);
  for (int i = 0; i < 60; ++i) {
    RigidCase pair = rigid_families()[0].draw(random);
    const Vec3 half{random.between(0.2, 1), random.between(0.2, 1), random.between(0.2, 1)};
    pair.b.shape = Box(half);
    const std::optional<ShapeHit> of_box = swept(pair);
    const std::optional<ShapeHit> of_mesh =
        sweep(Model(pair.a.shape), pair.a.motion(), Model(box_mesh(half)), pair.b.motion());
    const std::optional<ShapeHit> exchanged =
        sweep(Model(box_mesh(half)), pair.b.motion(), Model(pair.a.shape), pair.a.motion());
    ASSERT_EQ(of_box.has_value(), of_mesh.has_value()) << i;
    EXPECT_EQ(of_box.has_value(), exchanged.has_value()) << i;
    if (!of_box.has_value() || of_box->status != Status::exact || of_mesh->status != Status::exact) continue;
    EXPECT_TRUE(have_common_time(of_box, of_mesh)) << i << " " << of_box->lower << " " << of_mesh->lower;
    EXPECT_TRUE(have_common_time(of_box, exchanged)) << i;
  }
}

/// The first hit of all triangles of both, one by one.
std::optional<ShapeHit> by_all_triangles(const TriangleMesh& a, const RigidMotion& motion_a, const TriangleMesh& b,
                                         const RigidMotion& motion_b) {
  const auto triangle = [](const TriangleMesh& mesh, Index i) {
    const auto& corner = mesh.triangles()[i];
    return Triangle{{mesh.vertices()[corner[0]], mesh.vertices()[corner[1]], mesh.vertices()[corner[2]]}};
  };
  std::optional<ShapeHit> first;
  for (Index i = 0; i < a.triangle_count(); ++i)
    for (Index j = 0; j < b.triangle_count(); ++j) {
      const std::optional<ShapeHit> hit = sweep(triangle(a, i), motion_a, triangle(b, j), motion_b);
      if (hit && (!first || hit->upper < first->upper)) first = hit;
    }
  return first;
}

TEST(RigidSweep, TwoMeshesAreMetAsTheirTrianglesOneByOne) {
  const TriangleMesh knot = torus_mesh({.radius = 1, .tube_radius = 0.35, .around = 8, .sides = 5});
  const Model model(knot);
  Random random(6);
  int hits = 0;
  for (int i = 0; i < 12; ++i) {
    const RigidCase pair = rigid_families()[0].draw(random);
    RigidMotion motion_a = pair.a.motion(), motion_b = pair.b.motion();
    if (overlap(model, model, {.pose_a = pair.a.start, .pose_b = pair.b.start})) continue;
    const std::optional<ShapeHit> hit = sweep(model, motion_a, model, motion_b);
    const auto expected = by_all_triangles(knot, motion_a, knot, motion_b);
    ASSERT_EQ(hit.has_value(), expected.has_value()) << i;
    hits += hit.has_value();
    EXPECT_TRUE(!hit.has_value() || hit->status != Status::exact || have_common_time(hit, expected)) << i;
  }
  EXPECT_GT(hits, 2);
}

/// One shape of each kind, about one unit large.
std::vector<Shape> one_of_each() {
  std::vector<Shape> shapes{Point{},
                            Segment({-1, 0, 0}, {1, 0, 0}),
                            Triangle{{Vec3{-1, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}},
                            HalfSpace({0, 0, 0.5}, {0, 0, 1}),
                            Sphere(0.7),
                            Box({0.5, 0.6, 0.7}),
                            Capsule({-0.5, 0, 0}, {0.5, 0, 0}, 0.3),
                            ConvexHull(std::array{Vec3{1, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}),
                            Rounded(Box({0.4, 0.4, 0.4}), 0.1),
                            Cylinder(0.5, 0.5),
                            Cone(0.5, 0.5),
                            Ellipsoid({0.5, 0.6, 0.7}),
                            std::make_shared<const TriangleMesh>(icosphere_mesh(0.7, 2)),
                            HeightField(4, 4, 0.3, 0.3, std::vector<double>(16, 0.1))};
  shapes.push_back(
      Compound{{Sphere(0.3), Pose::translation(0.3, 0, 0)}, {Box({0.2, 0.2, 0.2}), Pose::translation(-0.3, 0, 0)}});
  return shapes;
}

TEST(RigidSweep, EveryTwoKindsAreAnsweredBothWaysRound) {
  const RigidMotion coming(Pose::translation(0, 0, 9), {{0, 0, 9}, {1, 2, 0.5}, 0.7, {0, 0, -9}});
  for (const Shape& shape_a : one_of_each())
    for (const Shape& shape_b : one_of_each()) {
      const Model a(shape_a), b(shape_b);
      const bool is_defined = kind_of(shape_a) != ShapeKind::half_space || kind_of(shape_b) != ShapeKind::half_space;
      const std::string names = std::string(name_of(shape_a)) + " and " + std::string(name_of(shape_b));
      if (!is_defined) {
        EXPECT_NE(message_of([&] { (void)sweep(a, coming, b, Pose{}); }), "") << names;
        continue;
      }
      const std::optional<ShapeHit> hit = sweep(a, coming, b, Pose{}), other = sweep(b, Pose{}, a, coming);
      EXPECT_EQ(hit.has_value(), other.has_value()) << names;
      // Surfaces may pass each other, and the height field lies beside the way of a part.
      const bool may_pass = always_surface(kind_of(shape_a)) || always_surface(kind_of(shape_b));
      EXPECT_TRUE(may_pass || hit) << names;
      if (!hit || !other) continue;
      const bool is_exact = hit->status == Status::exact && other->status == Status::exact;
      EXPECT_TRUE(!is_exact || have_common_time(hit, other)) << names;
      EXPECT_FALSE(overlap(a, b, {.pose_a = coming.at(std::max(0.0, hit->lower - 1e-9))}) && hit->lower > 0) << names;
    }
}

TEST(RigidSweep, AnswersHaveTheSameBitsAtEverySimdLevel) {
  std::vector<Model> models;
  for (const Shape& shape : one_of_each())
    if (kind_of(shape) != ShapeKind::half_space) models.emplace_back(shape);
  models.emplace_back(torus_mesh({.radius = 1, .tube_radius = 0.3}));
  const RigidMotion coming(Pose::translation(0, 0.3, 9), {{0, 0, 9}, {1, 2, 0.5}, 0.7, {0, 0, -9}});
  std::vector<std::optional<ShapeHit>> first;
  at_every_simd_level([&](SimdLevel level) {
    std::vector<std::optional<ShapeHit>> hits;
    for (const Model& a : models)
      for (const Model& b : models) hits.push_back(sweep(a, coming, b, Pose{}));
    if (first.empty()) first = hits;
    EXPECT_EQ(hits, first) << name_of(level);
  });
  EXPECT_GT(std::count_if(first.begin(), first.end(), [](const auto& hit) { return hit.has_value(); }), 20);
}

TEST(RigidSweep, WhatIsFarFromAMeshLooksAtNoneOfItsTriangles) {
  const Model mesh(icosphere_mesh(0.7, 3));
  for (const Shape& shape : one_of_each()) {
    if (kind_of(shape) == ShapeKind::half_space) continue;
    Workspace workspace;
    const RigidMotion passing(Pose::translation(0, 3, 9), {{0, 3, 9}, {1, 2, 0.5}, 0.7, {0, 0, -18}});
    EXPECT_FALSE(sweep(Model(shape), passing, mesh, Pose{}, {}, workspace));
    EXPECT_EQ(workspace.scratch().counts.items, 0U) << name_of(shape);
  }
}

/// Their points that are farthest along x are at 1, and all that is around x = 1 there is a part of a ball or of a
/// plane.
std::vector<Model> reaching_to_one() {
  return {Model(Box({1, 1, 1})),
          Model(Sphere(1)),
          Model(Capsule({0, 0, -1}, {0, 0, 1}, 1)),
          Model(Rounded(Box({0.75, 1, 1}), 0.25)),
          Model(Cylinder(1, 1)),
          Model(Ellipsoid({1, 2, 2})),
          Model(HalfSpace({1, 0, 0}, {1, 0, 0})),
          Model(box_mesh({1, 1, 1}))};
}

// A radius does not turn: of a ball that spins in its place no point of its core moves, nor of a capsule about its
// axis.
TEST(RigidSweep, WhatIsRoundMaySpinAsCloseToAnotherAsItIs) {
  const Vec3 one{-0.3, 0.1, -0.2}, other{0.3, -0.1, 0.2};
  const double beside = 1.5 + 0.3;  // the reach of the capsule along x
  for (const Model& near : reaching_to_one())
    for (const double gap : {1e-3, 1e-6, 1e-9})
      for (const double turns : {0.25, 1.0, 1000.0}) {
        const Vec3 ball_at{1.5 + gap, 0, 0}, capsule_at{beside + gap, 0, 0};
        const RigidMotion spinning(Pose::translation(ball_at), {.centre = ball_at, .axis = {1, 2, 3}, .turns = turns});
        EXPECT_FALSE(sweep(Sphere(0.5), spinning, near, Pose{})) << name_of(near.shape()) << gap << " " << turns;
        EXPECT_FALSE(sweep(near, Pose{}, Sphere(0.5), spinning)) << name_of(near.shape()) << gap << " " << turns;
        const RigidMotion rolling(Pose::translation(capsule_at),
                                  {.centre = capsule_at, .axis = other - one, .turns = turns});
        EXPECT_FALSE(sweep(Capsule(one, other, 0.5), rolling, near, Pose{}))
            << name_of(near.shape()) << gap << " " << turns;
      }
}

// A ball that spins on its way is where one is that does not.
TEST(RigidSweep, ABallThatSpinsOnItsWayIsMetWhereAndWhenItIsWithoutThat) {
  const Pose start = Pose::translation(3, 0.2, 0.1);
  const RigidMotion straight = RigidMotion::straight(start, {-4, 0, 0});
  const RigidMotion spinning(start,
                             {.centre = start.offset, .axis = {1, 2, 3}, .turns = 50, .translation = {-4, 0, 0}});
  for (const Model& near : reaching_to_one()) {
    const std::optional<ShapeHit> expected = sweep(Sphere(0.5), straight, near, Pose{}),
                                  hit = sweep(Sphere(0.5), spinning, near, Pose{});
    ASSERT_TRUE(expected && hit) << name_of(near.shape());
    EXPECT_EQ(hit->status, Status::exact) << name_of(near.shape());
    EXPECT_TRUE(have_common_time(hit, expected)) << name_of(near.shape());
    EXPECT_LT(hit->upper - hit->lower, 1e-11) << name_of(near.shape());
    EXPECT_LT(length(hit->point - expected->point), 1e-7) << name_of(near.shape());
  }
}

// A rod that turns beside a peg leaves it along a direction that turns with the rod.
TEST(RigidSweep, ARodThatTurnsPastAPegInALittleWayIsFree) {
  const Model rod = Box({1, 0.02, 0.02}), peg = Box({0.05, 0.05, 0.5});
  for (const double gap : {1e-2, 1e-4, 1e-6, 1e-9}) {
    // The corners of the rod's ends are the farthest of all that the rod passes, at √(1 + 0.02²).
    const double corner = std::hypot(1.0, 0.02);
    const Pose standing = Pose::translation(0, corner + 0.05 + gap, 0);
    EXPECT_FALSE(sweep(rod, turned_about_z({}, 0.5), peg, standing)) << gap;
    EXPECT_TRUE(sweep(rod, turned_about_z({}, 0.5), peg, Pose::translation(0, corner + 0.05 - gap, 0))) << gap;
  }
}

TEST(RigidSweep, AMotionToldByAFunctionIsAnsweredAsTheMoveThatItIs) {
  const RigidMotion move(Pose{}, {.turns = 0.5, .translation = {0, 0, 0.3}});
  const auto told = RigidMotion::of([&](double time) { return move.at(time); }, {.speed = 0.3, .turns = 0.5});
  const Model rod = Box({1, 0.02, 0.02}), peg = Sphere(0.05);
  const std::optional<ShapeHit> hit = sweep(rod, told, peg, Pose::translation(0.6, 0.6, 0.1)),
                                expected = sweep(rod, move, peg, Pose::translation(0.6, 0.6, 0.1));
  ASSERT_TRUE(hit && expected);
  EXPECT_TRUE(have_common_time(hit, expected));
  EXPECT_EQ(hit->status, Status::exact);
  EXPECT_FALSE(sweep(rod, told, peg, Pose::translation(0.6, 0.6, 0.3)));
}

TEST(RigidSweep, AFunctionThatIsFasterThanItsBoundIsAnError) {
  const Model rod = Box({1, 0.02, 0.02}), peg = Sphere(0.05);
  const auto turning = [](double time) { return Pose::rotation({0, 0, 1}, 180 * time); };
  const auto sliding = [](double time) { return Pose::translation(0, 0, 2 * time); };
  for (const auto& told : {RigidMotion::of(turning, {.turns = 0.4}), RigidMotion::of(sliding, {.speed = 1.9})}) {
    const std::string message = message_of([&] { (void)sweep(rod, told, peg, Pose::translation(0.6, 0.6, 0.5)); });
    EXPECT_NE(message.find("faster than its bound"), std::string::npos) << message;
  }
}

TEST(RigidSweep, AMotionThroughPosesIsMetInWhicheverPieceItIs) {
  const std::vector<MotionKey> keys{{0, Pose::translation(0, 0, 5)},
                                    {0.5, {rotation_about({0, 1, 0}, 90), {5, 0, 5}}},
                                    {1, {rotation_about({0, 1, 0}, 170), {5, 0, -5}}}};
  const RigidMotion motion = RigidMotion::through(keys);
  const Model rod = Box({1, 0.02, 0.02});
  const std::optional<ShapeHit> hit = sweep(rod, motion, Sphere(0.5), Pose::translation(5, 0, 0));
  ASSERT_TRUE(hit);
  EXPECT_GT(hit->lower, 0.5);
  EXPECT_FALSE(sweep(rod, motion, Sphere(0.5), Pose::translation(0, 0, 0)));
}

TEST(RigidSweep, ItStopsAsFarBeforeAsItIsTold) {
  const Model ball = Sphere(0.5), box = Box({1, 1, 1});
  const RigidMotion coming(Pose::translation(5, 0, 0), {.centre = {5, 0, 0}, .turns = 1, .translation = {-5, 0, 0}});
  for (const double before : {0.25, 1.0}) {
    const std::optional<ShapeHit> hit = sweep(ball, coming, box, Pose{}, {.stop_before = before});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->status, Status::exact);
    EXPECT_LE(hit->lower, (3.5 - before) / 5 + 1e-15);
    EXPECT_GE(hit->upper, (3.5 - before) / 5 - 1e-15);
    EXPECT_LT(hit->upper - hit->lower, 1e-11);
  }
  EXPECT_EQ(sweep(ball, coming, box, Pose{}, {.stop_before = 4})->upper, 0);
  EXPECT_FALSE(sweep(ball, {Pose::translation(5, 0, 0), {.turns = 1}}, box, Pose{}, {.stop_before = 2.9}));
}

/// Stands on the floor, whose top is at z = 0, as exactly as doubles are.
RigidMotion walking(const Vec3& by) { return {Pose::translation(0, 0, 0.75), {.translation = by}}; }

TEST(RigidSweep, WhatStandsOnAFloorMayWalkWhereItIsAllowedSomeDepth) {
  const Model body = Capsule({0, 0, -0.25}, {0, 0, 0.25}, 0.5);
  const Model box = Box({4, 4, 1}, {0, 0, -1});
  const Model field(HeightField(9, 9, 1, 1, std::vector<double>(81, 0.0)));
  for (const Model* floor : {&box, &field}) {
    const Pose below = floor == &box ? Pose{} : Pose::translation(-4, -4, 0);
    EXPECT_EQ(sweep(body, walking({3, 1, 0}), *floor, below)->upper, 0);
    EXPECT_TRUE(sweep(body, walking({3, 1, 0}), *floor, below));
    for (const Vec3& way : {Vec3{3, 1, 0}, Vec3{0, 0, 2}, Vec3{-3, 2, 1}, Vec3{9, 0, 0}})
      EXPECT_FALSE(sweep(body, walking(way), *floor, below, {.stop_before = -1e-6}));
    const std::optional<ShapeHit> sunk = sweep(body, walking({0, 0, -1}), *floor, below, {.stop_before = -1e-6});
    ASSERT_TRUE(sunk);
    EXPECT_LE(sunk->lower, 1e-6 + 1e-13);
    EXPECT_GE(sunk->upper, 1e-6 - 1e-13);
    EXPECT_NEAR(sunk->normal.z, 1, 1e-9);
  }
}

TEST(RigidSweep, WhatWalksIsStoppedByAWall) {
  const Model body = Capsule({0, 0, -0.25}, {0, 0, 0.25}, 0.5);
  const Compound room{{Box({4, 4, 1}, {0, 0, -1}), Pose{}}, {Box({0.1, 4, 4}), Pose::translation(2, 0, 0)}};
  const std::optional<ShapeHit> hit = sweep(body, walking({4, 0, 0}), Model(room), Pose{}, {.stop_before = -1e-6});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->element_b, 1U);
  EXPECT_NEAR(hit->lower, (1.4 + 1e-6) / 4, 1e-9);
  EXPECT_NEAR(hit->normal.x, -1, 1e-9);
}

TEST(RigidSweep, ElementsAndFacesAreThoseThatMeet) {
  const Compound pair{{Sphere(0.1), Pose::translation(0, 5, 0)}, {Model(box_mesh({1, 1, 1})).shape(), Pose{}}};
  const RigidMotion coming(Pose::translation(5, 0.2, 0.1),
                           {.centre = {5, 0, 0}, .axis = {1, 0, 0}, .turns = 0.1, .translation = {-5, 0, 0}});
  const std::optional<ShapeHit> hit = sweep(Sphere(0.5), coming, Model(pair), Pose{});
  ASSERT_TRUE(hit);
  EXPECT_GE(hit->element_b, 1U);
  EXPECT_NEAR(hit->point.x, 1, 1e-12);
  EXPECT_NEAR(hit->normal.x, 1, 1e-9);
}

TEST(RigidSweep, WhatIsAskedWronglyIsAnError) {
  const Model box = Box({1, 1, 1});
  EXPECT_THROW((void)sweep(box, Pose{}, box, Pose{}, {.stop_before = -std::numeric_limits<double>::infinity()}), Error);
  EXPECT_THROW((void)sweep(box, Pose{}, box, Pose{}, {.stop_before = std::nan("")}), Error);
  EXPECT_THROW((void)sweep(box, Pose{}, Model(height_field_mesh({})), Pose{}, {.solid_b = Solid::all}), Error);
  EXPECT_THROW((void)sweep(Sphere(1), scaled(Pose{}, 2), box, Pose{}), Error);
}

}  // namespace
}  // namespace toccata::test
