#include <gtest/gtest.h>

#include <cmath>

#include "query/meshes/posed_mesh.hpp"
#include "query/nearest/way_into_tree.hpp"
#include "query/nearest_checks.hpp"
#include "query/ray_checks.hpp"
#include "support/simd_levels.hpp"
#include "toccata/core/error.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/query/batch.hpp"
#include "toccata/query/ray_caster.hpp"
#include "toccata/shapes/height_field.hpp"

namespace toccata {
namespace {

TEST(Ray, AgreesWithTheOracleAtEverySimdLevel) {
  test::at_every_simd_level([](SimdLevel level) {
    std::uint64_t seed = 0;
    for (const std::string& family : test::ray_families())
      for (int i = 0; i < 12; ++i) {
        Random random(++seed);
        const test::RayCase c = test::ray_case(family, random);
        const Model model(c.mesh);
        const std::optional<RayHit> by_boxes = cast_ray(c.origin, c.motion, model, c.pose, Solid::none);
        static_cast<void>(model.leaf_triangles());
        const std::optional<RayHit> hit = cast_ray(c.origin, c.motion, model, c.pose, Solid::none);
        ASSERT_EQ(hit, by_boxes) << family << ", seed " << seed << ", " << name_of(level);
        ASSERT_EQ(test::ray_fault(c, hit), "") << family << ", seed " << seed << ", " << name_of(level);
      }
  });
}

const Model icosphere(generate_mesh("icosphere", {{"subdivisions", 2}}));

TEST(Ray, NoneSlipsThroughAnEdgeOrACorner) {
  // From the middle of a closed surface to its corners and to the middles of its edges.
  const TriangleMesh& mesh = icosphere.mesh();
  const Pose pose{rotation_about({1, 2, 3}, 33), {7, -5, 3}};
  const Vec3 middle = pose.offset + Vec3{0.01, 0.02, 0.03};
  for (const auto& corner : mesh.triangles())
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 p = transform(pose, mesh.vertices()[corner[i]]);
      const Vec3 q = transform(pose, mesh.vertices()[corner[(i + 1) % 3]]);
      for (const Vec3& to : {p, 0.5 * (p + q)}) {
        const std::optional<RayHit> hit = cast_ray(middle, 2.0 * (to - middle), icosphere, pose, Solid::none);
        ASSERT_TRUE(hit);
        ASSERT_NEAR(hit->upper, 0.5, 1e-9);
      }
    }
}

TEST(Ray, ASolidIsMetAtOnceFromItsInside) {
  const Vec3 inside{0.1, 0.2, 0.3};
  const std::optional<RayHit> as_solid = cast_ray(inside, {5, 0, 0}, icosphere);
  ASSERT_TRUE(as_solid);
  EXPECT_EQ(as_solid->upper, 0);
  EXPECT_EQ(as_solid->point, inside);
  const std::optional<RayHit> as_surface = cast_ray(inside, {5, 0, 0}, icosphere, {}, Solid::none);
  ASSERT_TRUE(as_surface);
  EXPECT_GT(as_surface->lower, 0.1);
  EXPECT_LT(as_surface->normal.x, -0.8);  // against the ray
}

TEST(Ray, TellsElementAndFaceOfACompound) {
  const std::vector<CompoundPart> parts{{Sphere(1), Pose::translation(-5, 0, 0)},
                                        {icosphere.shape(), Pose::translation(5, 0, 0)}};
  const Model model((Compound(parts)));
  const std::optional<RayHit> left = cast_ray({-9, 0.1, 0.1}, {30, 0, 0}, model);
  EXPECT_EQ(left->element, 0U);
  const std::optional<RayHit> right = cast_ray({9, 0.1, 0.1}, {-30, 0, 0}, model);
  ASSERT_TRUE(right);
  EXPECT_GE(right->element, 1U);
  EXPECT_EQ(right->face, right->element);
  EXPECT_NEAR(right->normal.x, 1, 0.1);
  const std::optional<RayHit> alone = cast_ray({9, 0.1, 0.1}, {-30, 0, 0}, icosphere, Pose::translation(5, 0, 0));
  EXPECT_EQ(alone->element + 1, right->element);
}

TEST(Ray, BatchIsTheSameAsOneByOne) {
  const Model knot(generate_mesh("torus-knot"));
  const Pose pose{rotation_about({3, 1, 2}, 70), {1, 2, 3}};
  std::vector<RayQuery> rays;
  Random random(5);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 from = pose.offset + test::some_point(random, 5);
    rays.push_back({from, 2.0 * (pose.offset + test::some_point(random, 1) - from), pose, Solid::none});
  }
  const auto same_pose = cast_ray_each(rays, knot);
  rays.push_back({{9, 9, 9}, {1, 1, 1}, {}});  // so that the poses differ
  const auto each_pose = cast_ray_each(rays, knot);
  std::size_t hits = 0;
  for (std::size_t i = 0; i < same_pose.size(); ++i) {
    ASSERT_EQ(same_pose[i], each_pose[i]) << i;
    ASSERT_EQ(same_pose[i], cast_ray(rays[i].origin, rays[i].motion, knot, pose, Solid::none)) << i;
    hits += same_pose[i].has_value() ? 1 : 0;
  }
  EXPECT_GT(hits, 100U);
  EXPECT_LT(hits, 1900U);
}

/// Meshes of all sizes, some far from the origin, and a field.
std::vector<Model> models_where_they_are() {
  std::vector<Model> models;
  for (const double scale : {1.0, 1e-3, 1e150, 1e-150, 1e-305})
    for (const double shift : {0.0, 7.0, 1e9}) {
      const TriangleMesh mesh = generate_mesh("torus-knot");
      std::vector<Vec3> vertices(mesh.vertices().begin(), mesh.vertices().end());
      for (Vec3& v : vertices) v = scale * (v + Vec3{shift, -shift, 0.5 * shift});
      models.emplace_back(mesh.with_vertices(vertices));
    }
  models.emplace_back(generate_mesh("noise-sphere", {{"roughness", 0.9}}));
  models.emplace_back(HeightField(3, 3, 1, 1, std::vector<double>{0, 1, 0, 2, 0, 1, 0, 0, 3}));
  return models;
}

/// A mesh at the identity is not posed for a single ray; one of many is asked about posed.
TEST(Ray, AtTheIdentityTheAnswerIsThatOfAPosedMesh) {
  Random random(17);
  Pose with_minus_zeros;
  with_minus_zeros.offset = {-0.0, 0, -0.0};
  with_minus_zeros.linear[0].y = -0.0;
  std::size_t hits = 0, starts = 0;
  for (const Model& model : models_where_they_are()) {
    const Aabb& box = model.wide_bvh().box;
    const auto place = [&] {
      const double x = random.between(-0.3, 1.3), y = random.between(-0.3, 1.3), z = random.between(-0.3, 1.3);
      const Vec3 size = box.upper - box.lower;
      return box.lower + Vec3{x * size.x, y * size.y, z * size.z};
    };
    std::vector<RayQuery> rays;
    for (int i = 0; i < 30; ++i) {
      const Vec3 from = place(), to = place();
      if (!(from == to)) rays.push_back({from, to - from, {}, Solid::automatic});
    }
    const auto posed = cast_ray_each(rays, model);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const std::optional<RayHit> hit = cast_ray(rays[i].origin, rays[i].motion, model);
      ASSERT_EQ(hit, posed[i]) << i;
      ASSERT_EQ(hit, cast_ray(rays[i].origin, rays[i].motion, model, with_minus_zeros)) << i;
      hits += hit.has_value() ? 1 : 0;
      starts += hit.has_value() && hit->upper == 0 ? 1 : 0;
    }
  }
  EXPECT_GT(hits, 100U);
  EXPECT_GT(starts, 4U);
}

TEST(Ray, TheWayIntoATreeAtTheIdentityIsThatOfThePose) {
  for (const Model& model : models_where_they_are()) {
    const WayIntoTree posed{PosedMesh(model, Pose{})}, standing(model.wide_bvh());
    ASSERT_EQ(standing.usable(), posed.usable());
    if (!posed.usable()) continue;
    EXPECT_EQ(standing.back(), posed.back());
    EXPECT_EQ(standing.origin(), posed.origin());
    EXPECT_EQ(standing.off_at_origin(), posed.off_at_origin());
    EXPECT_EQ(standing.off_by_size(), posed.off_by_size());
  }
}

/// From an eye through the points of a grid, row by row, and through corners, middles of edges and of faces in their
/// order: neighbours in the array meet neighbours.
std::vector<RayQuery> rays_of_a_camera(const Model& model, const Pose& pose) {
  const Vec3 eye = pose.offset + Vec3{4, 0.25, 0.5};
  std::vector<RayQuery> rays;
  const auto add = [&](const Vec3& through) { rays.push_back({eye, 1.5 * (through - eye), pose, Solid::none}); };
  constexpr int side = 48;
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column)
      add(pose.offset + Vec3{0, 3.0 * column / side - 1.5, 3.0 * row / side - 1.5});
  for (const auto& corner : model.mesh().triangles()) {
    const Vec3 a = transform(pose, model.mesh().vertices()[corner[0]]),
               b = transform(pose, model.mesh().vertices()[corner[1]]),
               c = transform(pose, model.mesh().vertices()[corner[2]]);
    for (const Vec3& through : {a, 0.5 * (a + b), (1.0 / 3) * (a + b + c)}) add(through);
  }
  return rays;
}

TEST(Ray, OfManyThatStayTogetherIsThatOfEachAlone) {
  const Model knot(generate_mesh("torus-knot"));
  test::at_every_simd_level([&](SimdLevel level) {
    for (const Model& model : {icosphere, knot})
      for (const Pose& pose : {Pose{}, Pose{rotation_about({1, 2, 3}, 33), {7, -5, 3}}}) {
        static_cast<void>(model.leaf_triangles());
        const std::vector<RayQuery> rays = rays_of_a_camera(model, pose);
        const auto together = cast_ray_each(rays, model);
        std::size_t hits = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
          ASSERT_EQ(together[i], cast_ray(rays[i].origin, rays[i].motion, model, pose, Solid::none))
              << i << ", " << name_of(level);
          hits += together[i].has_value() ? 1 : 0;
        }
        EXPECT_GT(hits, rays.size() / 4);
      }
  });
}

// Everything but a mesh at the identity, which the questions one by one know a shorter way for, and that.
TEST(Ray, OfACasterIsThatOfAQuestionByItself) {
  const Model knot(generate_mesh("torus-knot")), ball(Sphere{0.7}), box(Box{{0.5, 0.4, 0.3}}), cone(Cone(0.5, 0.4));
  const Model both(Compound({{box.shape(), Pose::translation(0.5, 0, 0)}, {icosphere.shape(), Pose{}}}));
  Random random(31);
  std::size_t hits = 0, starts = 0;
  for (const Model& model : {knot, icosphere, ball, box, cone, both})
    for (const Pose& pose : {Pose{}, Pose{rotation_about({1, 2, 3}, 33), {0.5, 0.25, 0}}}) {
      const RayCaster caster(model, pose);
      for (int i = 0; i < 60; ++i) {
        const Vec3 from = test::in_cube(random, 1.5), motion = test::in_cube(random, 3);
        const std::optional<RayHit> hit = cast_ray(from, motion, model, pose);
        ASSERT_EQ(caster.cast_ray(from, motion), hit) << name_of(model.shape()) << ", " << i;
        hits += hit.has_value() ? 1 : 0;
        starts += hit.has_value() && hit->upper == 0 ? 1 : 0;
      }
    }
  EXPECT_GT(hits, 100U);
  EXPECT_GT(starts, 10U);
}

TEST(Ray, OfACasterStaysThatOfTheModelItWasMadeOf) {
  Model model(generate_mesh("icosphere", {{"subdivisions", 2}}));
  const Vec3 from{3, 0.1, 0.2}, motion{-6, 0, 0};
  RayCaster caster(model);
  const std::optional<RayHit> before = caster.cast_ray(from, motion);
  std::vector<Vec3> vertices(model.mesh().vertices().begin(), model.mesh().vertices().end());
  for (Vec3& vertex : vertices) vertex = 0.5 * vertex;
  static_cast<void>(model.deform(std::move(vertices)));
  const RayCaster moved = std::move(caster);
  EXPECT_EQ(moved.cast_ray(from, motion), before);
  EXPECT_NE(RayCaster(model).cast_ray(from, motion), before);
  EXPECT_THROW(static_cast<void>(moved.cast_ray(from, {})), Error);
  EXPECT_THROW(RayCaster(model, {Mat3{}, {NAN, 0, 0}}), Error);
}

TEST(Ray, BadInputIsRefused) {
  EXPECT_THROW(static_cast<void>(cast_ray({NAN, 0, 0}, {1, 0, 0}, icosphere)), Error);
  EXPECT_THROW(static_cast<void>(cast_ray({0, 0, 0}, {HUGE_VAL, 0, 0}, icosphere)), Error);
  EXPECT_THROW(static_cast<void>(cast_ray({0, 0, 0}, {0, 0, 0}, icosphere)), Error);
  Pose lost;
  lost.offset.x = NAN;
  EXPECT_THROW(static_cast<void>(cast_ray({0, 0, 0}, {1, 0, 0}, icosphere, lost)), Error);
}

}  // namespace
}  // namespace toccata
