#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "narrow/triangles/solid_angle.hpp"
#include "query/winding_checks.hpp"
#include "toccata/core/error.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/query/signed_distance.hpp"
#include "trees/winding_moments.hpp"

namespace toccata {
namespace {

TEST(SolidAngle, AFaceOfACubeCoversASixthFromItsMiddle) {
  const Vec3 middle{0.5, 0.5, 0.5};
  const SolidAngle a = solid_angle(middle, {{Vec3{1, 0, 0}, Vec3{1, 1, 0}, Vec3{1, 1, 1}}});
  EXPECT_NEAR(a.value, 1.0 / 12, a.bound);
  EXPECT_LT(a.bound, 1e-14);
  const SolidAngle turned = solid_angle(middle, {{Vec3{1, 1, 0}, Vec3{1, 0, 0}, Vec3{1, 1, 1}}});
  EXPECT_EQ(turned.value, -a.value);
}

TEST(SolidAngle, InThePlaneItIsNothingAndBesideItHalf) {
  const Triangle t{{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}};
  for (const Vec3& p : {Vec3{0.25, 0.25, 0}, Vec3{0, 0, 0}, Vec3{0.5, 0, 0}, Vec3{7, 7, 0}})
    EXPECT_EQ(solid_angle(p, t).value, 0);
  for (const double height : {1e-3, 1e-17, 1e-300}) {
    const SolidAngle below = solid_angle({0.25, 0.25, -height}, t), above = solid_angle({0.25, 0.25, height}, t);
    EXPECT_NEAR(below.value, 0.5, below.bound + 10 * height);
    EXPECT_NEAR(above.value, -0.5, above.bound + 10 * height);
    EXPECT_LT(below.bound, 1e-12);
  }
}

TEST(SolidAngle, TheAngleIsThatOfTheLibraryAndTheSameWithMoreDigits) {
  Random random(7);
  for (int i = 0; i < 20000; ++i) {
    const double x = random.between(-1, 1), y = random.between(-1, 1) * std::exp2(random.between(-60, 60));
    const long double truth = std::atan2(static_cast<long double>(y), static_cast<long double>(x)) /
                              (2 * 3.141592653589793238462643383279502884L);
    ASSERT_LE(std::fabs(turns_of(y, x) - truth), 0x1p-52L) << y << ", " << x;
  }
}

TEST(WindingNumbers, HoldThatOfTheOracle) {
  std::uint64_t seed = 0;
  for (const std::string& family : test::point_families())
    for (int i = 0; i < 5; ++i) {
      Random random(++seed);
      const test::PointCase c = test::point_case(family, random);
      const double exact = test::exact_winding(c);
      for (const double tolerance : {0.1, 1e-3, 1e-9}) {
        const WindingNumber found =
            generalized_winding_number(c.point, Model(c.mesh), c.pose, {.tolerance = tolerance});
        ASSERT_EQ(test::winding_fault(exact, found, tolerance), "") << family << ", seed " << seed;
      }
    }
}

TEST(WindingMoments, AreWithinTheirBoundFromAllSides) {
  Random random(11);
  for (int i = 0; i < 300; ++i) {
    const TriangleMesh mesh = test::random_soup(random, static_cast<Index>(1 + random.below(12)), 0.5, 0);
    const Model model(mesh);
    const WideBvh& tree = model.wide_bvh();
    const WindingMoments& root = model.winding_moments()[0];
    const double ratio = random.between(0.02, 0.98);
    Vec3 way = test::random_vector(random, 1);
    way = (root.radius / ratio / std::sqrt(dot(way, way))) * way;
    const Vec3 point = tree.origin + tree.unit * (root.centre + way);
    const WindingPart part = winding_part(root, (1 / tree.unit) * (point - tree.origin), 0x1p-48);
    const double exact = oracle::winding_number(point, test::world_triangles(mesh, {}));
    ASSERT_LE(std::fabs(part.value - exact), part.bound) << i << ", " << ratio;
    if (ratio < 0.2) {
      ASSERT_LT(part.bound, 0.05) << i << ", " << ratio;
    }
  }
}

TEST(WindingNumbers, OfAClosedMeshAreWhole) {
  const Model knot(generate_mesh("torus-knot"));
  Random random(4);
  int inside = 0;
  for (int i = 0; i < 100; ++i) {
    const Pose pose{rotation_about({1, 2, 3}, 3.0 * i), {5, -6, 7}};
    const Vec3 at = transform(pose, knot.mesh().vertices()[random.below(knot.mesh().vertices().size())]);
    const Vec3 p = at + test::random_vector(random, 0.15);
    const WindingNumber found = generalized_winding_number(p, knot, pose, {.tolerance = 1e-6});
    const int exact = locate(p, knot, pose).winding_number;
    ASSERT_EQ(found.status, Status::exact);
    ASSERT_LE(found.lower, exact);
    ASSERT_GE(found.upper, exact);
    inside += exact != 0 ? 1 : 0;
  }
  EXPECT_GT(inside, 5);
}

TEST(WindingNumbers, HoldWithMomentsOnALargeOpenMesh) {
  // Most of a ball: what is left out is told by the moments and by every triangle alike.
  const TriangleMesh ball = generate_mesh("icosphere", {{"subdivisions", 3}});
  std::vector<std::array<Index, 3>> kept;
  for (const auto& corner : ball.triangles())
    if (ball.vertices()[corner[0]].z < 0.6) kept.push_back(corner);
  const TriangleMesh mesh({ball.vertices().begin(), ball.vertices().end()}, kept);
  const Model model(mesh);
  Random random(9);
  for (int i = 0; i < 3; ++i) {
    const test::PointCase c{
        mesh, {rotation_about({3, 1, 2}, 70.0 * i), {1e3, 0, 0}}, Vec3{1e3, 0, 0} + test::random_vector(random, 1.3)};
    const double exact = test::exact_winding(c);
    for (const double tolerance : {0.1, 1e-2, 1e-4, 1e-8}) {
      const WindingNumber found = generalized_winding_number(c.point, model, c.pose, {.tolerance = tolerance});
      ASSERT_EQ(test::winding_fault(exact, found, tolerance), "") << i << ", " << tolerance;
    }
  }
}

TEST(WindingNumbers, ManyAtOnceAreTheSameAsOneByOne) {
  const Model knot(generate_mesh("torus-knot"));
  Random random(5);
  std::vector<Vec3> points;
  for (int i = 0; i < 500; ++i) points.push_back(test::random_vector(random, 3));
  const auto one_thread = generalized_winding_number_each(points, knot, {}, {}, {.threads = 1});
  EXPECT_EQ(generalized_winding_number_each(points, knot, {}, {}, {.threads = 3}), one_thread);
  for (std::size_t i = 0; i < points.size(); ++i)
    ASSERT_EQ(generalized_winding_number(points[i], knot), one_thread[i]) << i;
}

TEST(WindingNumbers, BadInputIsRefused) {
  const Model cube(test::box_between({0, 0, 0}, {1, 1, 1}));
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(static_cast<void>(generalized_winding_number({infinity, 0, 0}, cube)), Error);
  EXPECT_THROW(static_cast<void>(generalized_winding_number({0, 0, 0}, Sphere(1))), Error);
  for (const double tolerance : {0.0, -1.0, std::nan("")})
    EXPECT_THROW(static_cast<void>(generalized_winding_number({0, 0, 0}, cube, {}, {.tolerance = tolerance})), Error);
  Pose lost;
  lost.linear[1].x = infinity;
  EXPECT_THROW(static_cast<void>(generalized_winding_number({0, 0, 0}, cube, lost)), Error);
  EXPECT_THROW(static_cast<void>(generalized_winding_number_each(std::vector<Vec3>{{0, 0, 0}, {0, infinity, 0}}, cube)),
               Error);
}

}  // namespace
}  // namespace toccata
