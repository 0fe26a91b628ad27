#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "narrow/quadrics/exact_place.hpp"
#include "toccata/narrow/quadrics.hpp"
#include "toccata/shapes/convex_hull.hpp"

// Shapes at whole and half numbers, along the axes, that are put against each other: exactly touching, by construction.
namespace toccata::test {
namespace {

using AnyPosed = std::variant<PosedQuadric, PosedPolytope>;

/// A shape with what is known of it by hand.
struct Toucher {
  std::string name;
  std::function<AnyPosed(const Pose&)> at;
  /// In its own frame, the points farthest along a signed axis (0 to 2), some of them.
  std::function<std::vector<Vec3>(int axis, double sign)> ends;
  bool solid = true;
  bool may_be_scaled = true;
};

/// A point on an axis, or with the other coordinates given in turn.
Vec3 on_axis(int axis, double along, double second = 0, double third = 0) {
  Vec3 p;
  p[axis] = along;
  p[(axis + 1) % 3] = second;
  p[(axis + 2) % 3] = third;
  return p;
}

std::vector<Vec3> ends_of_round(const Vec3& half, bool is_cone, int axis, double sign) {
  if (axis == 2 && is_cone && sign > 0) return {{0, 0, half.z}};
  if (axis == 2)
    return {{0, 0, sign * half.z}, {0.25 * half.x, 0.125 * half.x, sign * half.z}, {half.x, 0, sign * half.z}};
  const Vec3 rim = on_axis(axis, sign * half.x);
  if (is_cone) return {{rim.x, rim.y, -half.z}};
  return {rim, {rim.x, rim.y, 0.5 * half.z}, {rim.x, rim.y, -half.z}};
}

Toucher can(double radius, double half) {
  return {"cylinder", [=](const Pose& pose) { return AnyPosed(PosedQuadric(Cylinder(radius, half), pose)); },
          [=](int axis, double sign) {
            return ends_of_round({radius, radius, half}, false, axis, sign);
          }};
}

Toucher cone(double radius, double half) {
  return {"cone", [=](const Pose& pose) { return AnyPosed(PosedQuadric(Cone(radius, half), pose)); },
          [=](int axis, double sign) {
            return ends_of_round({radius, radius, half}, true, axis, sign);
          }};
}

Toucher egg(const Vec3& half) {
  return {"ellipsoid", [=](const Pose& pose) { return AnyPosed(PosedQuadric(Ellipsoid(half), pose)); },
          [=](int axis, double sign) { return std::vector<Vec3>{on_axis(axis, sign * half[axis])}; }};
}

/// The farthest corners, points between two of them, and a point among them all.
std::vector<Vec3> ends_of_corners(const std::vector<Vec3>& corners, double radius, int axis, double sign) {
  double farthest = -HUGE_VAL;
  for (const Vec3& p : corners) farthest = std::fmax(farthest, sign * p[axis]);
  std::vector<Vec3> end;
  for (const Vec3& p : corners)
    if (sign * p[axis] == farthest) end.push_back(p);
  std::vector<Vec3> found{end.front()};
  if (end.size() > 1) found.push_back(0.5 * end.front() + 0.5 * end.back());
  if (end.size() > 1) found.push_back(0.25 * end[0] + 0.75 * end[1]);
  if (end.size() > 2) found.push_back(0.25 * end[0] + 0.25 * end[1] + 0.5 * end[2]);
  for (Vec3& p : found) p[axis] += sign * radius;
  return found;
}

template <class Shape>
Toucher convex(const char* name, const Shape& shape, const std::vector<Vec3>& corners, double radius, bool solid) {
  return {name, [=](const Pose& pose) { return AnyPosed(PosedPolytope(shape, pose)); },
          [=](int axis, double sign) { return ends_of_corners(corners, radius, axis, sign); }, solid, radius == 0};
}

std::vector<Vec3> corners_of_box(const Vec3& h) {
  std::vector<Vec3> found;
  for (const double x : {-h.x, h.x})
    for (const double y : {-h.y, h.y})
      for (const double z : {-h.z, h.z}) found.push_back({x, y, z});
  return found;
}

std::vector<Toucher> quadric_touchers() { return {can(2, 3), cone(2, 3), egg({2, 1, 3})}; }

std::vector<Toucher> all_touchers() {
  static const std::vector<Vec3> corners{{3, 1, 0}, {-1, 2, 0}, {-2, -2, 1}, {1, -3, 1}, {0, 0, 4}, {0.5, 0.25, -4}};
  static const ConvexHull hull(corners);
  std::vector<Toucher> all = quadric_touchers();
  all.push_back(convex("box", Box({1, 1, 1}), corners_of_box({1, 1, 1}), 0, true));
  all.push_back(convex("sphere", Sphere(2), {{}}, 2, true));
  all.push_back(convex("capsule", Capsule({0, 0, -1}, {0, 0, 1}, 0.5), {{0, 0, -1}, {0, 0, 1}}, 0.5, true));
  all.push_back(convex("slanted capsule", Capsule({0, 1, -1}, {2, 0, 1}, 0.5), {{0, 1, -1}, {2, 0, 1}}, 0.5, true));
  all.push_back(convex("rounded box", Rounded(Box({1, 2, 1}), 0.5), corners_of_box({1, 2, 1}), 0.5, true));
  all.push_back({"hull", [](const Pose& pose) { return AnyPosed(PosedPolytope(hull, pose)); },
                 [](int axis, double sign) { return ends_of_corners(corners, 0, axis, sign); }});
  const std::array<Vec3, 3> flat{Vec3{-1, -1, 0}, Vec3{3, -1, 0}, Vec3{0, 2, 0}},
      steep{Vec3{}, Vec3{2, 1, 1}, Vec3{-1, 2, 3}};
  all.push_back(convex("triangle", Triangle{flat}, {flat.begin(), flat.end()}, 0, false));
  all.push_back(convex("steep triangle", Triangle{steep}, {steep.begin(), steep.end()}, 0, false));
  all.push_back(convex("segment", Segment({-1, 0, 0}, {2, 0, 0}), {{-1, 0, 0}, {2, 0, 0}}, 0, false));
  all.push_back(convex("steep segment", Segment({-1, 1, 0}, {2, 0, 1}), {{-1, 1, 0}, {2, 0, 1}}, 0, false));
  all.push_back(convex("point", Point({1, 2, 3}), {{1, 2, 3}}, 0, false));
  return all;
}

/// A quarter turn of some kind (0 to 5), of what may be scaled along its axes before that.
Mat3 turn_of(int which, bool scaled) {
  Mat3 turn;
  const int shift = which % 3;
  const double sign = which < 3 ? 1 : -1;
  for (int i = 0; i < 3; ++i) turn[i] = {};
  for (int j = 0; j < 3; ++j) turn[(j + shift) % 3][j] = j == 0 ? 1 : sign;
  if (scaled)
    for (int i = 0; i < 3; ++i) turn[i] = {2 * turn[i].x, turn[i].y, 0.5 * turn[i].z};
  return turn;
}

Vec3 mapped(const Mat3& m, const Vec3& p) { return {dot(m[0], p), dot(m[1], p), dot(m[2], p)}; }

/// World vectors to the farthest points along an axis of the world.
std::vector<Vec3> world_ends(const Toucher& shape, const Mat3& turn, int axis, double sign) {
  for (int j = 0; j < 3; ++j)
    if (turn[axis][j] != 0) {
      std::vector<Vec3> found = shape.ends(j, turn[axis][j] > 0 ? sign : -sign);
      for (Vec3& p : found) p = mapped(turn, p);
      return found;
    }
  return {};
}

/// That they touch, and no more, is told exactly by every question.
template <class A, class B>
void expect_touching(const A& a, const B& b, const Vec3& motion, const std::string& name) {
  SCOPED_TRACE(name);
  EXPECT_EQ(quadric_contact(a, b), QuadricContact::contact);
  EXPECT_TRUE(overlap(a, b));
  const Distance gap = distance(a, b);
  EXPECT_EQ(gap.upper, 0);
  EXPECT_EQ(gap.on_a, gap.on_b);
  EXPECT_EQ(gap.status, Status::exact);
  const Relation lie = relation(a, b);
  EXPECT_EQ(lie.kind, toccata::RelationKind::touching);
  EXPECT_EQ(lie.status, Status::exact);
  const std::optional<Cast> cast = cast_shape(a, motion, b);
  ASSERT_TRUE(cast);
  EXPECT_EQ(cast->upper, 0);
  EXPECT_EQ(cast->status, Status::exact);
  if (!lie.a_solid || !lie.b_solid) return;
  const Penetration depth = penetration(a, b);
  EXPECT_EQ(depth.upper, 0);
  EXPECT_EQ(depth.status, Status::exact);
  EXPECT_EQ(depth.on_a, depth.on_b);
  EXPECT_GT(distance(a, b.moved(depth.direction)).lower, 1 - 1e-12) << "the direction parts them";
}

void expect_any_touching(const AnyPosed& a, const AnyPosed& b, const Vec3& motion, const std::string& name) {
  const auto ask = [&](const auto& p, const auto& q) {
    if constexpr (!std::is_same_v<std::decay_t<decltype(p)>, PosedPolytope> ||
                  !std::is_same_v<std::decay_t<decltype(q)>, PosedPolytope>)
      expect_touching(p, q, motion, name);
  };
  std::visit(ask, a, b);
}

/// A last place away from each other they have no more in common.
template <class B>
void expect_parted(const PosedQuadric& a, const B& b, const Vec3& away, const std::string& name) {
  const Vec3 place = a.pose().offset;
  Vec3 step;
  for (int i = 0; i < 3; ++i)
    if (away[i] != 0) step[i] = std::nextafter(place[i], away[i] * HUGE_VAL) - place[i];
  const PosedQuadric moved = a.moved(step);
  EXPECT_NE(quadric_contact(moved, b), QuadricContact::contact) << name;
  EXPECT_GT(distance(moved, b).upper, 0) << name;
  const Relation lie = relation(moved, b);
  EXPECT_TRUE(lie.kind == toccata::RelationKind::apart || lie.status == Status::undecided) << name;
}

/// Two shapes, both turned and perhaps scaled, on the two sides of a plane across an axis.
struct MeetingShapes {
  Toucher a, b;
  Mat3 turn_a, turn_b;
  int axis = 0;
  double sign = 1;

  /// Calls visit(A, B) for each two of their farthest points put together.
  template <class Visit>
  void visit_all(const Visit& visit) const {
    const Vec3 place{0.125, -3, 7};
    for (const Vec3& end_a : world_ends(a, turn_a, axis, sign))
      for (const Vec3& end_b : world_ends(b, turn_b, axis, -sign))
        visit(a.at(Pose{turn_a, place + end_b - end_a}), b.at(Pose{turn_b, place}));
  }
};

template <class Visit>
void visit_meetings(const Visit& visit) {
  for (const Toucher& a : quadric_touchers())
    for (const Toucher& b : all_touchers())
      for (int turn = 0; turn < 6; ++turn)
        for (const bool scaled : {false, true})
          for (int axis = 0; axis < 3; ++axis)
            for (const double sign : {-1.0, 1.0})
              visit(MeetingShapes{a, b, turn_of(turn, scaled),
                                  turn_of((5 * turn + axis) % 6, scaled && b.may_be_scaled), axis, sign});
}

// Some of 10,128; all of them take a minute.
TEST(QuadricTouching, ShapesOnEitherSideOfAPlaneAlongAnyAxis) {
  constexpr int every = 41;
  int number = 0;
  visit_meetings([&](const MeetingShapes& meeting) {
    meeting.visit_all([&](const AnyPosed& a, const AnyPosed& b) {
      if (++number % every != 0) return;
      const Vec3 motion = on_axis(meeting.axis, meeting.sign);
      const std::string name = meeting.a.name + ", " + meeting.b.name + ", number " + std::to_string(number);
      const auto ask_parted = [&](const auto& q) { expect_parted(std::get<PosedQuadric>(a), q, -motion, name); };
      std::visit(ask_parted, b);
      if (number % 2 == 0)
        expect_any_touching(a, b, motion, name);
      else
        expect_any_touching(b, a, -motion, name);
    });
  });
  EXPECT_EQ(number, 10128);
}

Mat3 upside_down() {
  Mat3 turn;
  turn[1].y = turn[2].z = -1;
  return turn;
}

// Places across the axis have as many digits as there are.
TEST(QuadricTouching, FacesLinesAndTipsAtAnyPlaceOnAFace) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> across(-1.9, 1.9);
  const PosedPolytope box(Box({2, 2, 1}));
  const PosedPolytope triangle(Triangle({Vec3{-3, -4, 1}, Vec3{4, -3, 1}, Vec3{0.1, 4, 1}}));
  const PosedQuadric table(Cylinder(2.5, 1)), egg(Ellipsoid({2, 3, 1.5}));
  const Mat3 lying = turn_of(1, false), crossing = turn_of(2, false);
  for (int i = 0; i < 6; ++i) {
    const Vec3 at{across(random), across(random), 0}, up{at.x, at.y, 4}, beside{0.5 * at.x, 0.5 * at.y, 2.5};
    const Vec3 down{0, 0, -1};
    const PosedQuadric standing(Cylinder(1.5, 3), Pose{{}, up}), roller(Cylinder(1.5, 3), Pose{lying, beside});
    const PosedQuadric crosswise(Cylinder(1.5, 3), Pose{crossing, {at.x, at.y, -0.5}});
    const std::string number = std::to_string(i);
    expect_touching(standing, box, down, "standing on a box " + number);
    expect_touching(standing, triangle, down, "standing on a triangle " + number);
    expect_touching(standing, table, down, "standing on a cylinder " + number);
    expect_touching(roller, box, down, "lying on a box " + number);
    expect_touching(roller, table, down, "lying on a cylinder " + number);
    expect_touching(roller, crosswise, down, "lying across a cylinder " + number);
    expect_touching(PosedQuadric(Ellipsoid({1.5, 2, 3}), Pose{{}, {beside.x, beside.y, 4}}), table, down,
                    "egg " + number);
    expect_touching(PosedQuadric(Cone(1.5, 3), Pose{upside_down(), {at.x, at.y, 4}}), box, down,
                    "on its tip " + number);
  }
}

// Where the common point and the plane between are rational: with 3, 4 and 5, and along the sides of cones.
TEST(QuadricTouching, SlantedPlanesOfFewDigits) {
  const PosedPolytope box(Box({1, 1, 1}));
  const PosedQuadric ball(Ellipsoid({5, 5, 5}), Pose::translation(6, 8, 0)),
      can(Cylinder(5, 1), Pose::translation(6, 8, 0.5));
  const Vec3 back{-1, 0, 0}, down{0, 0, -1};
  expect_touching(ball, PosedPolytope(Sphere(5)), back, "balls");
  expect_touching(ball, PosedQuadric(Ellipsoid({5, 5, 5})), back, "two ellipsoids");
  expect_touching(can, PosedQuadric(Cylinder(5, 1)), back, "cylinders side by side");
  expect_touching(can, PosedPolytope(Capsule({0, 0, -3}, {0, 0, 2}, 5)), back, "beside a capsule");
  expect_touching(PosedQuadric(Cylinder(5, 1), Pose::translation(4, 5, 0.5)), box, back, "at an edge");
  expect_touching(PosedQuadric(Cylinder(5, 1), Pose::translation(4, 5, 2)), box, back, "a rim at a corner");
  const PosedQuadric cone(Cone(2, 2), Pose::translation(2, 0, 1));
  const PosedQuadric hanging(Cone(2, 2), Pose{upside_down(), {0, 0, 1}}),
      over(Cone(2, 2), Pose{upside_down(), {0, 0, 5}});
  expect_touching(PosedQuadric(Cone(2, 2), Pose::translation(2, 0.25, -1)), box, back, "a cone at an edge");
  expect_touching(cone, PosedPolytope(Triangle({Vec3{1, -1, 1}, Vec3{1, 1, 1}, Vec3{0, 0, 1}})), back,
                  "a triangle's edge");
  expect_touching(cone, PosedPolytope(Segment({1, -3, 1}, {1, 3, 1})), back, "a segment across");
  expect_touching(cone, hanging, back, "cones side by side");
  expect_touching(over, PosedQuadric(Cone(2, 2), Pose::translation(0, 0, 1)), down, "tip on tip");
  expect_touching(over, PosedQuadric(Ellipsoid({3, 2, 3})), down, "tip on an ellipsoid");
  const PosedPolytope ramp(Triangle({Vec3{-8, -5, 6}, Vec3{8, -5, -6}, Vec3{0, 9, 0}}));
  expect_touching(PosedQuadric(Ellipsoid({5, 5, 5}), Pose::translation(3, 0, 4)), ramp, down, "a ball on a ramp");
  const PosedQuadric roller(Cylinder(5, 1), Pose{turn_of(2, false), {3, 0, 4}});
  expect_touching(roller, ramp, down, "a roller on a ramp");
  expect_touching(PosedQuadric(Cone(3, 2), Pose{upside_down(), {1, 0.5, 2.25}}),
                  PosedPolytope(Triangle({Vec3{0, 0, 0}, Vec3{2, 0, 0}, Vec3{1, 1, 0.5}})), down, "a tip on a slope");
}

// Heights over the plane that proves touching are as exact as the relation to a half-space, which they do not use.
TEST(QuadricTouching, HeightsOverPlanesAreThoseOverHalfSpaces) {
  std::mt19937_64 random(5);
  const auto whole = [&](int most) {
    return static_cast<double>(std::uniform_int_distribution<int>(-most, most)(random));
  };
  int touching = 0;
  for (int i = 0; i < 9000; ++i) {
    const Vec3 normal{whole(4), whole(4), whole(4)}, point{whole(3), whole(3), whole(3)};
    const Pose pose = Pose::translation(whole(4), whole(4), whole(4));
    if (normal == Vec3{}) continue;
    const PosedPolytope shape = i % 3 == 0   ? PosedPolytope(Box({1, 2, 0.5}), pose)
                                : i % 3 == 1 ? PosedPolytope(Sphere(3), pose)
                                             : PosedPolytope(Capsule({0, 0, -1}, {1, 2, 1}, 1.5), pose);
    const toccata::RelationKind lie = relation(shape, PosedHalfSpace(HalfSpace(point, normal))).kind;
    const Sign height = exact_sign_of_height(shape, point, scaled_wide(normal, 0));
    EXPECT_EQ(height == Sign::positive, lie == toccata::RelationKind::apart);
    EXPECT_EQ(height == Sign::zero, lie == toccata::RelationKind::touching);
    touching += lie == toccata::RelationKind::touching ? 1 : 0;
  }
  EXPECT_GT(touching, 30);
}

// The middle of a triangle was a third of its corners in doubles, and so a point beside it, within what lies there.
TEST(QuadricTouching, ATriangleInThePlaneOfACapDoesNotCross) {
  const PosedQuadric can(Cylinder(2, 3), Pose{turn_of(2, false), {0.875, -6, 5.5}});
  const PosedPolytope triangle(Triangle({Vec3{1.125, -3, 6}, Vec3{1.125, -3, 10}, Vec3{-1.875, -3, 7}}));
  expect_touching(can, triangle, {0, 1, 0}, "a triangle on a cap");
}

}  // namespace
}  // namespace toccata::test
