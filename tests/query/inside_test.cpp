#include "toccata/query/signed_distance.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "support/mesh_soups.hpp"
#include "support/relation_cases.hpp"
#include "toccata/core/error.hpp"

namespace toccata::test {
namespace {

void expect_location(const Vec3& point, const Model& solid, Side side, int winding_number) {
  const PointLocation found = locate(point, solid);
  EXPECT_EQ(found.side, side) << point.x << ' ' << point.y << ' ' << point.z;
  EXPECT_EQ(found.winding_number, winding_number) << point.x << ' ' << point.y << ' ' << point.z;
}

TEST(Inside, OfABox) {
  for (const Model& box : {Model(box_between({0, 0, 0}, {2, 2, 2})), Model(other_box_mesh({0, 0, 0}, {2, 2, 2}))}) {
    expect_location({1, 1, 1}, box, Side::inside, 1);
    expect_location({3, 1, 1}, box, Side::outside, 0);
    expect_location({-1, 1, 1}, box, Side::outside, 0);
    for (const Vec3& on : {Vec3{0, 0, 0}, Vec3{2, 2, 2}, Vec3{1, 0, 0}, Vec3{2, 1, 1}, Vec3{0, 0.5, 1.5}})
      expect_location(on, box, Side::boundary, 0);
  }
}

TEST(Inside, BehindVerticesEdgesAndFacesThatTheLineMeets) {
  const Model sphere(sphere_mesh(1, 2));
  for (const Vec3& v : sphere.mesh().vertices()) {
    // The line along x through the vertex meets it, and often edges and further vertices.
    expect_location({v.x - 4, v.y, v.z}, sphere, Side::outside, 0);
    expect_location({v.x + 4, v.y, v.z}, sphere, Side::outside, 0);
    expect_location(v, sphere, Side::boundary, 0);
    if (v.y * v.y + v.z * v.z < 0.5) expect_location({0, v.y, v.z}, sphere, Side::inside, 1);
  }
  const Model box(box_between({0, 0, 0}, {2, 2, 2}));
  // In the planes of faces and on the lines of edges and diagonals.
  for (const double y : {0.0, 1.0, 2.0})
    for (const double z : {0.0, 1.0, 2.0}) {
      expect_location({-1, y, z}, box, Side::outside, 0);
      expect_location({3, y, z}, box, Side::outside, 0);
    }
}

TEST(Inside, CountsHowOftenTheSurfaceWindsAround) {
  const Model nested(joined({box_between({0, 0, 0}, {6, 6, 6}), box_between({1, 1, 1}, {5, 5, 5}),
                             inverted(box_between({2, 2, 2}, {4, 4, 4}))}));
  expect_location({0.5, 3, 3}, nested, Side::inside, 1);
  expect_location({1.5, 3, 3}, nested, Side::inside, 2);
  expect_location({3, 3, 3}, nested, Side::inside, 1);
  const Model hollow(joined({box_between({0, 0, 0}, {6, 6, 6}), inverted(box_between({2, 2, 2}, {4, 4, 4}))}));
  expect_location({3, 3, 3}, hollow, Side::outside, 0);
  expect_location({1, 3, 3}, hollow, Side::inside, 1);
  expect_location({1, 1, 1}, Model(inverted(box_between({0, 0, 0}, {2, 2, 2}))), Side::inside, -1);
  const Model doubled(TriangleMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}));
  expect_location({0.25, 0.25, 0}, doubled, Side::boundary, 0);
  expect_location({0.25, 0.25, 1}, doubled, Side::outside, 0);
}

TEST(Inside, UnderAPose) {
  const Model box(box_between({0, 0, 0}, {1, 1, 1}));
  const Pose mirrored{{{{{-2, 0, 0}, {0, 2, 0}, {1, 0, 2}}}}, {10, 20, 30}};
  const PointLocation inside = locate(transform(mirrored, {0.5, 0.5, 0.5}), box, mirrored);
  EXPECT_EQ(inside.side, Side::inside);
  EXPECT_EQ(inside.winding_number, -1);
  EXPECT_EQ(locate(transform(mirrored, {1, 0.5, 0.5}), box, mirrored).side, Side::boundary);
  EXPECT_EQ(locate({0.5, 0.5, 0.5}, box, mirrored).side, Side::outside);
}

TEST(Inside, OneStepOfADoubleFromAFace) {
  for (const double size : {1.0, 1e-300, 1e300}) {
    const Model box(box_between({0, 0, 0}, {size, size, size}));
    expect_location({std::nextafter(size, 0), size / 2, size / 2}, box, Side::inside, 1);
    expect_location({size, size / 2, size / 2}, box, Side::boundary, 0);
    expect_location({std::nextafter(size, 2 * size), size / 2, size / 2}, box, Side::outside, 0);
    expect_location({std::numeric_limits<double>::denorm_min(), size / 2, size / 2}, box, Side::inside, 1);
  }
}

TEST(Inside, WhatIsAskedWronglyIsAnError) {
  const Model box(box_between({0, 0, 0}, {1, 1, 1}));
  const Model open(TriangleMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}));
  EXPECT_THROW(static_cast<void>(locate({0, 0, 0}, open)), Error);
  EXPECT_THROW(static_cast<void>(locate({std::numeric_limits<double>::quiet_NaN(), 0, 0}, box)), Error);
  EXPECT_THROW(static_cast<void>(locate({0, 0, std::numeric_limits<double>::infinity()}, box)), Error);
  Pose flat;
  flat.linear[2] = flat.linear[1];
  EXPECT_THROW(static_cast<void>(locate({0, 0, 0}, box, flat)), Error);
  Pose far;
  far.linear[0] = {1e308, 1e308, 0};
  EXPECT_THROW(static_cast<void>(locate({0, 0, 0}, box, far)), Error);
}

}  // namespace
}  // namespace toccata::test
