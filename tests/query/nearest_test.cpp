#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "query/nearest_checks.hpp"
#include "support/simd_levels.hpp"
#include "toccata/core/error.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/query/batch.hpp"

namespace toccata {
namespace {

TEST(NearestPoint, AgreesWithTheOracleAtEverySimdLevel) {
  test::at_every_simd_level([](SimdLevel level) {
    std::uint64_t seed = 0;
    for (const std::string& family : test::nearest_families())
      for (int i = 0; i < 6; ++i) {
        Random random(++seed);
        const test::NearestCase c = test::nearest_case(family, random);
        const std::optional<SurfacePoint> found = nearest_point(c.point, Model(c.mesh), {.pose = c.pose});
        ASSERT_EQ(test::fault_by_oracle(c, *found), "") << family << ", seed " << seed << ", " << name_of(level);
      }
  });
}

TEST(NearestPoint, AndTheKNearestAreThoseOfEveryTriangleByItself) {
  test::at_every_simd_level([](SimdLevel level) {
    std::uint64_t seed = 0;
    for (const std::string& family : test::nearest_families())
      for (const std::size_t k : {1U, 2U, 7U, 40U, 50U}) {
        Random random(++seed);
        const test::NearestCase c = test::nearest_case(family, random);
        const Model model(c.mesh);
        const auto found = nearest_points(c.point, k, model, {.pose = c.pose});
        ASSERT_EQ(test::fault_of_nearest(c, found, k), "") << family << ", seed " << seed << ", " << name_of(level);
        static_cast<void>(model.leaf_triangles());
        ASSERT_EQ(found, nearest_points(c.point, k, model, {.pose = c.pose})) << family << ", seed " << seed;
        ASSERT_EQ(found[0], nearest_point(c.point, model, {.pose = c.pose}));
      }
  });
}

test::NearestCase around_a_knot(Random& random, double far) {
  static const TriangleMesh knot = generate_mesh("torus-knot");
  test::NearestCase c{knot, {rotation_about({3, 1, 2}, 70), {1, 2, 3}}, {}, 1};
  c.point = c.pose.offset + test::in_cube(random, far);
  return c;
}

TEST(NearestPoint, OfManyTrianglesIsThatOfEveryTriangleByItself) {
  Random random(7);
  for (const double far : {1.0, 3.0, 100.0, 1e9}) {
    const test::NearestCase c = around_a_knot(random, far);
    const Model model(c.mesh);
    const auto found = nearest_points(c.point, 9, model, {.pose = c.pose});
    EXPECT_EQ(test::fault_of_nearest(c, found, 9), "") << far;
    static_cast<void>(model.leaf_triangles());
    EXPECT_EQ(found, nearest_points(c.point, 9, model, {.pose = c.pose})) << far;
  }
}

const Model& ball() {
  static const Model model(generate_mesh("icosphere", {{"subdivisions", 2}}));
  return model;
}

TEST(NearestPoint, BatchIsTheSameAsOneByOneOnAnyThreadsAndWithAnyWorkspace) {
  Random random(5);
  const Model knot(generate_mesh("torus-knot"));
  const NearestQuery query{.pose = {rotation_about({3, 1, 2}, 70), {1, 2, 3}}};
  std::vector<Vec3> points;
  for (int i = 0; i < 600; ++i) points.push_back(query.pose.offset + test::in_cube(random, 3));
  BatchOptions threads;
  threads.threads = 3;
  const auto many = nearest_point_each(points, knot, query);
  EXPECT_EQ(many, nearest_point_each(points, knot, query, threads));
  const auto some = nearest_points_each(points, 3, knot, query, threads);
  Workspace workspace;
  for (std::size_t i = 0; i < points.size(); ++i) {
    ASSERT_EQ(many[i], nearest_point(points[i], knot, query));
    ASSERT_EQ(many[i], nearest_point(points[i], knot, query, workspace));
    ASSERT_EQ(some[i], nearest_points(points[i], 3, knot, query, workspace));
  }
  EXPECT_GT(workspace.counts().volume_tests, 0U);
}

/// At the middle, on corners, a hair off, anywhere, and so far that floats tell nothing.
std::vector<Vec3> points_of_all_kinds(const TriangleMesh& mesh, const Pose& pose) {
  Random random(9);
  std::vector<Vec3> points{pose.offset, {1e12, 0, 1}, {-3e7, 2e8, 1e5}};
  for (int i = 0; i < 20; ++i) {
    const Vec3 corner = transform(pose, mesh.vertices()[random.below(mesh.vertices().size())]);
    points.push_back(corner);
    points.push_back(corner + test::in_cube(random, 1e-9));
    points.push_back(pose.offset + test::in_cube(random, 2));
  }
  return points;
}

TEST(NearestPoint, OfManyTogetherIsThatOfEachAlone) {
  const TriangleMesh mesh = generate_mesh("icosphere", {{"subdivisions", 3}});
  const Model with_leaves(mesh);
  static_cast<void>(with_leaves.leaf_triangles());
  Mat3 sheared = rotation_about({3, 1, 2}, 70);
  sheared[0][1] += 0.5;
  test::at_every_simd_level([&](SimdLevel level) {
    for (const Mat3& linear : {rotation_about({3, 1, 2}, 70), sheared})
      for (const double most : {HUGE_VAL, 0.3, 0.0}) {
        const NearestQuery query{.pose = {linear, {1, 2, 3}}, .max_distance = most};
        const std::vector<Vec3> points = points_of_all_kinds(mesh, query.pose);
        const auto together = nearest_point_each(points, with_leaves, query);
        const Model alone(mesh);
        for (std::size_t i = 0; i < points.size(); ++i)
          ASSERT_EQ(together[i], nearest_point(points[i], alone, query)) << i << ", " << most << ", " << name_of(level);
        EXPECT_EQ(alone.leaf_triangles_for(0), nullptr) << "by the vertices alone";
      }
  });
}

TEST(NearestPoint, LiesOnTheSurfaceAlsoFromWithin) {
  const std::optional<SurfacePoint> from_within = nearest_point({0.1, 0.2, 0.3}, ball());
  EXPECT_GT(from_within->lower, 0.5);
  const std::optional<SurfacePoint> on_surface = nearest_point(ball().mesh().vertices()[5], ball());
  ASSERT_TRUE(on_surface);
  EXPECT_EQ(on_surface->upper, 0);
  EXPECT_EQ(on_surface->point, ball().mesh().vertices()[5]);
}

TEST(NearestPoint, OfEquallyNearElementsIsTheFirst) {
  const Model box(test::box_between({0, 0, 0}, {2, 2, 2}));
  const std::vector<SurfacePoint> all = nearest_points({1, 1, 1}, 99, box);
  ASSERT_EQ(all.size(), 12U);
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_EQ(all[i].element, i);
    EXPECT_EQ(all[i].upper, all[0].upper);
  }
  EXPECT_EQ(nearest_point({5, 5, 5}, box)->point, (Vec3{2, 2, 2}));
}

TEST(NearestPoint, KeepsWithinTheGreatestDistance) {
  const Model box(test::box_between({0, 0, 0}, {2, 2, 2}));
  EXPECT_TRUE(nearest_point({1, 1, 5}, box, {.max_distance = 3}));
  EXPECT_FALSE(nearest_point({1, 1, 5}, box, {.max_distance = 2.999999}));
  EXPECT_TRUE(nearest_point({1, 1, 2}, box, {.max_distance = 0}));
  EXPECT_FALSE(nearest_point({1, 1, 2.0000001}, box, {.max_distance = 0}));
  EXPECT_EQ(nearest_points({1, 1, 5}, 99, box, {.max_distance = 3.0001}).size(), 2U);
  EXPECT_TRUE(nearest_points({1, 1, 5}, 0, box).empty());
}

TEST(NearestPoint, CountsElementsAndFacesOfACompound) {
  const std::vector<CompoundPart> parts{{ball().shape(), Pose::translation(-5, 0, 0)},
                                        {Triangle{{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}}, {}},
                                        {ball().shape(), Pose::translation(5, 0, 0)}};
  const Model model((Compound(parts)));
  EXPECT_EQ(nearest_point({0.1, 0.1, 1}, model)->element, ball().element_count());
  const std::optional<SurfacePoint> right = nearest_point({9, 0.1, 0.1}, model);
  const std::optional<SurfacePoint> alone = nearest_point({9, 0.1, 0.1}, ball(), {.pose = Pose::translation(5, 0, 0)});
  EXPECT_EQ(right->element, alone->element + ball().element_count() + 1);
  EXPECT_EQ(right->face, alone->face + ball().face_count() + 1);
  EXPECT_EQ(right->point, alone->point);
  EXPECT_EQ(nearest_points({0, 0, 0}, 999999, model).size(), model.element_count());
}

TEST(NearestPoint, OfAHeightField) {
  const std::vector<double> heights{0, 0, 0, 0, 1, 0, 0, 0, 0};
  const Model field(HeightField(3, 3, 1, 1, heights));
  const std::optional<SurfacePoint> top = nearest_point({1, 1, 4}, field);
  ASSERT_TRUE(top);
  EXPECT_NEAR(top->upper, 3, 1e-12);
}

TEST(NearestPoint, BadInputIsRefused) {
  const auto refused = [](const Vec3& point, const Model& model, const NearestQuery& query, const char* why) {
    try {
      static_cast<void>(nearest_point(point, model, query));
      ADD_FAILURE() << "not refused: " << why;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
    }
  };
  Pose lost;
  lost.offset.x = NAN;
  refused({NAN, 0, 0}, ball(), {}, "the point is not finite");
  refused({0, 0, 0}, ball(), {.pose = lost}, "the surface");
  refused({0, 0, 0}, ball(), {.max_distance = -1}, "the greatest distance is -1");
  refused({0, 0, 0}, ball(), {.max_distance = NAN}, "the greatest distance");
  const std::vector<Vec3> points{{0, 0, 0}, {0, HUGE_VAL, 0}};
  try {
    static_cast<void>(nearest_point_each(points, ball()));
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("point 1: the point is not finite"), std::string::npos) << error.what();
  }
}

TEST(NearestPoint, OfTinyHugeAndFarMeshesAndNeedles) {
  Random random(11);
  for (const double scale : {1e-300, 1e-160, 1e-30, 1e30, 1e150, 1e300})
    for (const double off : {0.0, 1e6}) {
      test::NearestCase c{test::random_soup(random, 20, 0.3, 0), {}, {}, scale};
      c.pose = scaled({{}, off * Vec3{1, 1, 1}}, scale);
      c.point = c.pose.offset + test::in_cube(random, 3 * scale);
      const Model model(c.mesh);
      const auto found = nearest_points(c.point, 3, model, {.pose = c.pose});
      EXPECT_EQ(test::fault_of_nearest(c, found, 3), "") << scale << ", " << off;
      static_cast<void>(model.leaf_triangles());
      EXPECT_EQ(found, nearest_points(c.point, 3, model, {.pose = c.pose})) << scale << ", " << off;
    }
  const TriangleMesh needles({{0, 0, 0}, {1, 1e-16, 0}, {0.5, 0, 1e-17}, {2, 0, 0}, {2, 0, 0}},
                             {{0, 1, 2}, {3, 4, 3}, {0, 3, 2}});
  for (const Vec3& p : {Vec3{0.5, 1, 1}, Vec3{0.25, 0, 0}, Vec3{3, 0, 0}, Vec3{-1, 1e-8, 0}}) {
    const test::NearestCase c{needles, {}, p, 1};
    const Model model(needles);
    static_cast<void>(model.leaf_triangles());
    const auto found = nearest_points(p, 3, model);
    EXPECT_EQ(test::fault_of_nearest(c, found, 3), "");
    EXPECT_EQ(test::fault_by_oracle(c, found[0]), "");
  }
}

}  // namespace
}  // namespace toccata
