#include "toccata/motion/swept_volume.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "support/error_message.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/query/overlap.hpp"

namespace toccata::test {
namespace {

constexpr int moments = 29, close_moments = 150;

/// No point that is passed is outside, but for what rounding the sample itself does: the body at many times is within
/// the volume when each of its extreme points is.
void expect_contains(const SweptVolume& volume, const RigidMotion& motion, const std::vector<Vec3>& points,
                     double radius, double rounding) {
  for (int i = 0; i <= moments; ++i) {
    const Pose pose = motion.at(static_cast<double>(i) / moments);
    for (const Vec3& p : points) {
      const Vec3 at = pose * p;
      if (radius == 0) {
        ASSERT_TRUE(within_distance(Point(at), volume.model, rounding)) << "time " << i;
        continue;
      }
      for (const Vec3& out : {Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{0.6, 0, 0.8}, Vec3{0, 0.8, -0.6}})
        ASSERT_TRUE(within_distance(Point(at + radius * out), volume.model, rounding)) << "time " << i;
    }
  }
}

template <class Hull>
std::vector<Vec3> vertices_of(const Hull& hull) {
  std::vector<Vec3> vertices;
  for (Index i = 0; i < hull.vertex_count(); ++i) vertices.push_back(hull.vertex(i));
  return vertices;
}

std::vector<Vec3> corners_of(const Shape& shape) {
  if (const auto* hull = std::get_if<ConvexHull>(&shape)) return vertices_of(*hull);
  if (const auto* rounded = std::get_if<Rounded>(&shape)) return vertices_of(PosedPolytope(*rounded));
  return {};
}

/// No corner of a part is farther from the body, at the nearest of many times, than the excess and what the body moves
/// in between allow.
void expect_no_farther(const SweptVolume& volume, const Model& body, const RigidMotion& motion, double speed) {
  std::vector<Vec3> corners;
  if (const auto* compound = std::get_if<Compound>(&volume.model.shape())) {
    for (const CompoundPart& part : compound->parts())
      for (const Vec3& corner : corners_of(part.shape)) corners.push_back(corner);
  } else {
    corners = corners_of(volume.model.shape());
  }
  ASSERT_FALSE(corners.empty());
  const std::size_t step = std::max<std::size_t>(1, corners.size() / 25);
  for (std::size_t c = 0; c < corners.size(); c += step) {
    const Vec3& corner = corners[c];
    double nearest = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= close_moments; ++i)
      nearest = std::min(
          nearest, distance(body, Point(corner), {.pose_a = motion.at(static_cast<double>(i) / close_moments)}).lower);
    EXPECT_LE(nearest, volume.excess * (1 + 1e-9) + speed / close_moments);
  }
}

const std::vector<Vec3> box_corners{{1, 0.25, 0.5},  {1, 0.25, -0.5},  {1, -0.25, 0.5},  {1, -0.25, -0.5},
                                    {-1, 0.25, 0.5}, {-1, 0.25, -0.5}, {-1, -0.25, 0.5}, {-1, -0.25, -0.5}};

std::vector<Vec3> scaled_points(const std::vector<Vec3>& points, double scale) {
  std::vector<Vec3> all;
  for (const Vec3& p : points) all.push_back(scale * p);
  return all;
}

TEST(SweptVolume, OfASphereThatMovesStraightIsACapsule) {
  const SweptVolume volume = swept_volume(Sphere(0.5), RigidMotion::straight(Pose::translation(1, 2, 3), {4, 0, 0}));
  const auto* capsule = std::get_if<Capsule>(&volume.model.shape());
  ASSERT_NE(capsule, nullptr);
  EXPECT_TRUE(volume.is_exact());
  EXPECT_TRUE(overlap(volume.model, Point({5, 2, 3.5})));
  EXPECT_FALSE(overlap(volume.model, Point({5, 2, std::nextafter(3.5, 4)})));
  EXPECT_FALSE(overlap(volume.model, Point({5.5000001, 2, 3})));
}

TEST(SweptVolume, OfABoxIsAParallelepipedAlongAnEdgeAndElseAHullOfMoreFaces) {
  const Model body = Box({1, 0.25, 0.5});
  const auto hull_along = [&](const Vec3& way) {
    const SweptVolume volume = swept_volume(body, RigidMotion::straight(Pose{}, way));
    EXPECT_TRUE(volume.is_exact());
    return std::get<ConvexHull>(volume.model.shape());
  };
  EXPECT_EQ(hull_along({3, 0, 0}).vertex_count(), 8U);
  EXPECT_EQ(hull_along({3, 1, 0}).vertex_count(), 12U);
  EXPECT_EQ(hull_along({3, 1, 2}).vertex_count(), 14U);
}

TEST(SweptVolume, ContainsWhateverIsPassedAndNoMoreThanItSays) {
  const Pose turned = Pose::rotation({1, 2, 3}, 50);
  for (const double scale : {1e-8, 1.0, 1e8})
    for (const double away : {0.0, 1e5}) {
      const auto at = [&](double x, double y, double z) {
        return Pose::translation(scale * (away + x), scale * y, scale * z);
      };
      const Model body = Box({scale, 0.25 * scale, 0.5 * scale});
      const Pose start = at(0, 0, 0), end = at(3, 1, -2) * turned;
      const std::vector<RigidMotion> motions{
          RigidMotion::straight(start, {3 * scale, scale, 0}),
          RigidMotion::between(start, end),
          RigidMotion::screw(start, end),
          RigidMotion(start,
                      {.centre = {scale * away, 0, 0}, .axis = {0, 0, 1}, .turns = 2, .translation = {0, 0, scale}}),
          RigidMotion::through(std::vector<MotionKey>{{0, start}, {0.25, at(0, 4, 0)}, {1, end}}),
          RigidMotion::of([at](double time) { return at(2 * time, std::sin(3 * time), 0); }, {.speed = 4 * scale})};
      for (const RigidMotion& motion : motions) {
        const SweptVolume volume = swept_volume(body, motion);
        SCOPED_TRACE("scale " + std::to_string(scale) + " away " + std::to_string(away));
        const double rounding = 1e-13 * scale * (away + 10);
        expect_contains(volume, motion, scaled_points(box_corners, scale), 0, rounding);
        expect_no_farther(volume, body, motion, 20 * scale);
        EXPECT_LE(volume.excess, 0.2 * scale + 1e-10 * scale * away);
      }
    }
}

TEST(SweptVolume, OfWhatIsRoundContainsIt) {
  const RigidMotion motion(Pose{}, {.centre = {1, 0, 0}, .axis = {0, 1, 1}, .turns = 0.75, .translation = {0, 3, 0}});
  expect_contains(swept_volume(Capsule({-1, 0, 0}, {1, 0, 0}, 0.25), motion), motion, {{-1, 0, 0}, {1, 0, 0}}, 0.25,
                  1e-12);
  const Model cylinder = Cylinder(0.5, 2), cone = Cone(0.5, 1), ellipsoid = Ellipsoid({0.5, 1, 2});
  std::vector<Vec3> rim, ends;
  for (int i = 0; i < 16; ++i) {
    const double angle = 0.4 * i;
    rim.push_back({0.5 * std::cos(angle), 0.5 * std::sin(angle), 2});
    ends.push_back({0.5 * std::cos(angle), std::sin(angle), 0});
  }
  for (Vec3& p : rim) p.z = 1;
  expect_contains(swept_volume(cylinder, motion), motion, rim, 0, 1e-12);
  expect_contains(swept_volume(ellipsoid, motion), motion, {{0, 0, 2}, {0, 0, -2}, {0.5, 0, 0}, {0, 1, 0}}, 0, 1e-12);
  expect_contains(swept_volume(ellipsoid, motion), motion, ends, 0, 1e-12);
  expect_contains(swept_volume(cone, motion), motion, {{0, 0, 1}, {0.5, 0, -1}, {0, -0.5, -1}}, 0, 1e-12);
}

TEST(SweptVolume, OfAMeshIsHullsOfThePartsOfItsTree) {
  const TriangleMesh knot = generate_mesh("torus-knot");
  const Model body(knot);
  const std::vector<Vec3> vertices(knot.vertices().begin(), knot.vertices().end());
  std::vector<Vec3> some;
  for (std::size_t i = 0; i < vertices.size(); i += 37) some.push_back(vertices[i]);
  const RigidMotion motion(Pose{}, {.axis = {1, 0, 0}, .turns = 0.25, .translation = {2, 0, 0}});
  const SweptVolume coarse = swept_volume(body, motion, {.max_parts = 20, .solid = Solid::none});
  const SweptVolume fine = swept_volume(body, motion, {.max_parts = 400, .solid = Solid::none});
  EXPECT_LT(fine.excess, 0.6 * coarse.excess);
  expect_contains(coarse, motion, some, 0, 1e-12);
  expect_contains(fine, motion, some, 0, 1e-12);
  // A solid's inside counts too.
  const Model block(generate_mesh("box"));
  const SweptVolume solid = swept_volume(block, motion);
  EXPECT_TRUE(overlap(solid.model, Point({0, 0, 0})));
}

TEST(SweptVolume, TellsNeverOrMaybeAndCertainOnlyWhereOneRests) {
  const Model ball = Sphere(0.5);
  const SweptVolume across = swept_volume(ball, RigidMotion::straight(Pose::translation(-4, 0, 0), {8, 0, 0}));
  const SweptVolume along = swept_volume(ball, RigidMotion::straight(Pose::translation(3, -4, 0), {0, 8, 0}));
  const SweptVolume above = swept_volume(ball, RigidMotion::straight(Pose::translation(-4, 0, 1.5), {8, 0, 0}));
  const SweptVolume pillar = swept_volume(Box({0.5, 0.5, 3}), Pose{});
  EXPECT_EQ(may_meet(across, along), SweptOverlap::maybe);  // at different times: the one is there first
  EXPECT_EQ(may_meet(across, above), SweptOverlap::never);
  EXPECT_EQ(may_meet(across, pillar), SweptOverlap::certain);
  EXPECT_TRUE(pillar.rests);
  // Within a box that is taken as a surface a ball meets nothing.
  const Model box(generate_mesh("box", {{"half-x", 2}, {"half-y", 2}, {"half-z", 2}}));
  const SweptVolume inside = swept_volume(ball, RigidMotion::straight(Pose{}, {1, 0, 0}));
  EXPECT_EQ(may_meet(swept_volume(box, Pose{}, {.solid = Solid::none}), inside), SweptOverlap::never);
  EXPECT_EQ(may_meet(swept_volume(box, Pose{}), inside), SweptOverlap::certain);
}

TEST(SweptVolume, OfASpinIsNoLargerThanItsCircle) {
  const SweptVolume volume =
      swept_volume(Box({1, 1, 1}), RigidMotion(Pose{}, {.centre = {5, 0, 0}, .turns = 1e6}), {.max_parts = 1});
  EXPECT_LT(volume.excess, 60);
}

TEST(SweptVolume, WhatIsAskedWronglyIsAnError) {
  for (const double excess : {0.0, 0.1})
    EXPECT_NE(message_of([&] {
                (void)swept_volume(Sphere(1), RigidMotion::straight(scaled(Pose{}, 2), {10, 0, 0}), {.excess = excess});
              }),
              "");
  EXPECT_NE(message_of([] {
              (void)swept_volume(Cylinder(8e307, 8e307), RigidMotion::straight(Pose{}, {8e307, 0, 0}));
            }).find("beyond the doubles"),
            std::string::npos);
  const RigidMotion motion = RigidMotion::straight(Pose{}, {1, 0, 0});
  EXPECT_NE(message_of([&] {
              (void)swept_volume(HalfSpace({0, 0, 0}, {0, 0, 1}), motion);
            }).find("half-space"),
            std::string::npos);
  EXPECT_NE(message_of([&] { (void)swept_volume(Sphere(1), motion, {.excess = -1}); }).find("the excess -1"),
            std::string::npos);
  EXPECT_NE(message_of([&] { (void)swept_volume(Sphere(1), motion, {.max_parts = 0}); }).find("at least 1 part"),
            std::string::npos);
  EXPECT_NE(message_of([&] {
              (void)swept_volume(
                  Box({1, 1, 1}),
                  RigidMotion::straight(Pose{}, {1.7e308, 0, 0}).carrying(Pose::translation(1e308, 0, 0)));
            }),
            "");
}

}  // namespace
}  // namespace toccata::test
