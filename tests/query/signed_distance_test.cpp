#include "query/signed_distance_checks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/simd_levels.hpp"
#include "toccata/core/error.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/math/pose.hpp"

namespace toccata {
namespace {

TEST(SignedDistances, AgreeWithTheOracleAtEverySimdLevel) {
  test::at_every_simd_level([](SimdLevel level) {
    std::uint64_t seed = 0;
    for (const std::string& family : test::closed_families())
      for (int i = 0; i < 4; ++i) {
        Random random(++seed);
        const test::PointCase c = test::closed_case(family, random);
        ASSERT_EQ(test::signed_fault(c, signed_distance(c.point, Model(c.mesh), c.pose)), "")
            << family << ", seed " << seed << ", " << name_of(level);
      }
  });
}

TEST(SignedDistances, OfACube) {
  const Model cube(test::box_between({0, 0, 0}, {4, 4, 4}));
  const SignedDistance inside = signed_distance({1, 2, 2}, cube);
  EXPECT_EQ(inside.side, Side::inside);
  EXPECT_NEAR(inside.lower, -1, 1e-12);
  EXPECT_NEAR(inside.nearest.x, 0, 1e-12);
  const SignedDistance outside = signed_distance({-3, 2, 8}, cube);
  EXPECT_EQ(outside.side, Side::outside);
  EXPECT_NEAR(outside.upper, 5, 1e-11);
  for (const Vec3& p : {Vec3{0, 0, 0}, Vec3{4, 2, 2}, Vec3{4, 4, 1}, Vec3{1, 1, 0}}) {
    const SignedDistance on = signed_distance(p, cube);
    EXPECT_EQ(on.side, Side::boundary);
    EXPECT_EQ(on.lower, 0);
    EXPECT_EQ(on.upper, 0);
  }
}

TEST(SignedDistances, OfAnOpenBoxAreToldByTheGeneralisedWindingNumber) {
  // Without the two triangles of its top.
  const TriangleMesh box = test::box_between({0, 0, 0}, {2, 2, 2});
  std::vector<std::array<Index, 3>> kept;
  for (const auto& corner : box.triangles())
    if (box.vertices()[corner[0]].z + box.vertices()[corner[1]].z + box.vertices()[corner[2]].z < 5.5)
      kept.push_back(corner);
  ASSERT_EQ(kept.size(), 10U);
  const Model open(TriangleMesh({box.vertices().begin(), box.vertices().end()}, kept));
  const SignedDistance deep = signed_distance({1, 1, 0.5}, open);
  EXPECT_EQ(deep.side, Side::inside);
  EXPECT_EQ(deep.sign_by, SignBy::generalized_winding_number);
  EXPECT_EQ(deep.status, Status::exact);
  EXPECT_NEAR(deep.upper, -0.5, 1e-12);
  EXPECT_EQ(signed_distance({1, 1, 3}, open).side, Side::outside);
  // The middle of the opening sees half of all: the five walls are a half sphere there. Not to be decided.
  const SignedDistance middle = signed_distance({1, 1, 2}, open);
  EXPECT_EQ(middle.status, Status::undecided);
  EXPECT_NEAR(middle.upper, 1, 1e-12);
  EXPECT_EQ(middle.lower, -middle.upper);
  EXPECT_THROW(static_cast<void>(signed_distance({1, 1, 1}, open, {}, SignBy::winding_number)), Error);
}

TEST(SignedDistances, BothMethodsAgreeOnAClosedMesh) {
  const Model knot(generate_mesh("torus-knot"));
  Random random(6);
  for (int i = 0; i < 200; ++i) {
    const Vec3 p = test::random_vector(random, 3);
    SignedDistance guessed = signed_distance(p, knot, {}, SignBy::generalized_winding_number);
    EXPECT_EQ(guessed.sign_by, SignBy::generalized_winding_number);
    guessed.sign_by = SignBy::winding_number;
    ASSERT_EQ(guessed, signed_distance(p, knot)) << i;
  }
}

TEST(SignedDistances, ManyAtOnceAreTheSameAsOneByOne) {
  const Model knot(generate_mesh("torus-knot"));
  const Pose pose{rotation_about({1, 2, 3}, 40), {1, 2, 3}};
  Random random(8);
  std::vector<Vec3> points;
  for (int i = 0; i < 300; ++i) points.push_back(pose.offset + test::random_vector(random, 3));
  const auto one_thread = signed_distance_each(points, knot, pose, SignBy::automatic, {.threads = 1});
  EXPECT_EQ(signed_distance_each(points, knot, pose, SignBy::automatic, {.threads = 3}), one_thread);
  Workspace workspace;
  for (std::size_t i = 0; i < points.size(); ++i)
    ASSERT_EQ(signed_distance(points[i], knot, pose, SignBy::automatic, workspace), one_thread[i]) << i;
}

TEST(SignedDistances, BadInputIsRefused) {
  const Model cube(test::box_between({0, 0, 0}, {1, 1, 1}));
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(static_cast<void>(signed_distance({infinity, 0, 0}, cube)), Error);
  Pose flat;
  flat.linear[2] = {0, 0, 0};
  EXPECT_THROW(static_cast<void>(signed_distance({0, 0, 0}, cube, flat)), Error);
  try {
    static_cast<void>(signed_distance_each(std::vector<Vec3>{{0, 0, 0}, {0, NAN, 0}}, cube));
    FAIL() << "a point that is no point was taken";
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()).rfind("point 1: ", 0), 0U) << error.what();
  }
}

}  // namespace
}  // namespace toccata
