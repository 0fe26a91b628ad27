#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/error_message.hpp"
#include "toccata/core/error.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/query/manifolds.hpp"
#include "toccata/world/world.hpp"
#include "world/random_bodies.hpp"

namespace toccata {
namespace {

using test::message_of;

/// A level of a game: ground of triangles, and bodies of all shapes on it.
World level(const WorldOptions& options) {
  World world(options);
  std::vector<double> heights;
  for (int i = 0; i < 81; ++i) heights.push_back(0.25 * (i % 3));
  world.add(Model(HeightField(9, 9, 1, 1, heights)), {}, BodyType::static_body);
  Random random(4);
  for (int i = 0; i < 60; ++i) {
    const Pose pose{test::random_rotation(random), test::vector_in(random, 0, 8)};
    world.add(test::random_any(random), {pose.linear, {pose.offset.x, pose.offset.y, 0.1 * pose.offset.z}});
  }
  return world;
}

TEST(WorldManifolds, AreThoseOfTheirQuestionOnAnyNumberOfThreads) {
  World one = level({.manifold = true}), two = level({.manifold = true, .threads = 2});
  two.prepare();
  one.step();
  two.step();
  ASSERT_EQ(one.pairs().size(), two.pairs().size());
  std::size_t of_meshes = 0;
  for (std::size_t i = 0; i < one.pairs().size(); ++i) {
    const PairReport& pair = one.pairs()[i];
    const Body &a = one.body(pair.a), &b = one.body(pair.b);
    EXPECT_EQ(pair.details->manifolds, two.pairs()[i].details->manifolds);
    EXPECT_EQ(pair.details->manifolds, manifolds(a.model, b.model, {a.pose, b.pose, a.solid, b.solid}));
    EXPECT_EQ(pair.details->manifold, two.pairs()[i].details->manifold);
    if (pair.details->manifold && pair.details->manifold->count > 0) {
      EXPECT_EQ(static_cast<const Manifold&>(pair.details->manifolds.at(0)), *pair.details->manifold);
    }
    if (!pair.details->manifold && !pair.details->manifolds.empty()) ++of_meshes;
  }
  EXPECT_GT(of_meshes, 20U);
}

/// A box that is pushed over a floor of many triangles feels one plane, step by step.
TEST(WorldManifolds, DoNotCatchWhereABodySlides) {
  World world({.manifold = true});
  world.add(Model(HeightField(30, 30, 0.37, 0.41, std::vector<double>(900, 0.0))), {}, BodyType::static_body);
  const BodyId box = world.add(Box({0.3, 0.2, 0.25}), {});
  const BodyId ball = world.add(Sphere(0.25), {});
  for (int i = 0; i < 300; ++i) {
    world.move(box, {rotation_about({0, 0, 1}, 3.0 * i), {1 + 0.02 * i, 1 + 0.013 * i, 0.25 - 0.001}});
    world.move(ball, {rotation_about({1, 2, 0}, 5.0 * i), {2 + 0.02 * i, 1 + 0.011 * i, 0.25 - 0.002}});
    world.step();
    ASSERT_GE(world.pairs().size(), 2U);
    for (const PairReport& pair : world.pairs()) {
      if (pair.a.index != 0) continue;
      ASSERT_EQ(pair.details->manifolds.size(), 1U) << i;
      const ModelManifold& found = pair.details->manifolds[0];
      EXPECT_NEAR(found.normal.z, 1, 1e-12) << i;
      EXPECT_EQ(found.count, pair.b == box ? 4 : 1) << i;
      EXPECT_NEAR(found.points[0].depth, pair.b == box ? 0.001 : 0.002, 1e-12) << i;
    }
  }
}

std::vector<Vec3> waved(const TriangleMesh& mesh, double by) {
  std::vector<Vec3> vertices(mesh.vertices().begin(), mesh.vertices().end());
  for (Vec3& vertex : vertices) vertex.z += by * vertex.x;
  return vertices;
}

TEST(WorldDeform, IsAsAnotherMesh) {
  const auto knot = std::make_shared<const TriangleMesh>(generate_mesh("torus-knot"));
  World world({.distance = true, .manifold = true});
  const Model shared(knot);
  Body body{shared, Pose::translation(0.5, 0, 0)};
  body.margin = 0.5;
  const BodyId cloth = world.add(body), other = world.add(shared, Pose::translation(0, 0, 3));
  world.add(Sphere(0.75), Pose::translation(1, 1, 0));
  world.step();
  const World saved = world;
  for (const double by : {0.1, 0.25, -0.5}) {
    world.deform(cloth, waved(*knot, by));
    EXPECT_EQ(world.body(cloth).model.mesh().vertices()[5], waved(*knot, by)[5]);
    EXPECT_EQ(world.body(other).model.mesh().vertices()[5], knot->vertices()[5]);
    EXPECT_EQ(shared.mesh().vertices()[5], knot->vertices()[5]);
    World fresh = saved;
    Body replaced = body;
    replaced.model = Model(knot->with_vertices(waved(*knot, by)));
    fresh.replace(cloth, replaced);
    EXPECT_EQ(world.box(cloth), fresh.box(cloth));
    world.step();
    fresh.step();
    ASSERT_EQ(world.pairs().size(), fresh.pairs().size());
    for (std::size_t i = 0; i < world.pairs().size(); ++i) {
      EXPECT_EQ(world.pairs()[i].a, fresh.pairs()[i].a);
      EXPECT_EQ(world.pairs()[i].b, fresh.pairs()[i].b);
      EXPECT_EQ(world.pairs()[i].in_contact, fresh.pairs()[i].in_contact);
      EXPECT_EQ(world.pairs()[i].details->manifolds, fresh.pairs()[i].details->manifolds);
      EXPECT_EQ(world.pairs()[i].details->distance->upper, fresh.pairs()[i].details->distance->upper);
    }
  }
  EXPECT_EQ(saved.body(cloth).model.mesh().vertices()[5], knot->vertices()[5]);
}

TEST(WorldDeform, OfWhatCannotBeChangesNothing) {
  World world;
  const TriangleMesh box = test::box_between({-1, -1, -1}, {1, 1, 1});
  Body crate{Model(box), Pose::translation(0, 0, 1e308)};
  crate.name = "crate";
  crate.solid = Solid::all;
  const BodyId id = world.add(crate), ball = world.add(Sphere(1), {});
  world.step();
  const std::uint64_t revision = world.revision();
  std::vector<Vec3> some(3), far(box.vertices().begin(), box.vertices().end());
  far[2].z = 1.7e308;
  for (const std::vector<Vec3>& wrong : {some, far}) {
    const std::string message = message_of([&] { world.deform(id, wrong); });
    EXPECT_EQ(message.substr(0, 31), "body 0 (generation 1) (\"crate\")") << message;
    EXPECT_EQ(world.revision(), revision);
    EXPECT_TRUE(std::ranges::equal(world.body(id).model.mesh().vertices(), box.vertices()));
  }
  EXPECT_NE(message_of([&] { world.deform(ball, some); }).find("a mesh can be deformed"), std::string::npos);
  world.remove(id);
  EXPECT_NE(message_of([&] { world.deform(id, some); }).find("was removed"), std::string::npos);
}

TEST(WorldPrepare, MakesWhatStepsNeed) {
  World world({.distance = true, .manifold = true, .threads = 2});
  const BodyId id = world.add(Model(generate_mesh("torus-knot")), {});
  world.prepare();
  for (const PartCost& cost : world.body(id).model.part_costs())
    EXPECT_EQ(cost.is_made, cost.part != ModelPart::winding);
  World plain;
  const BodyId other = plain.add(Model(generate_mesh("torus-knot")), {});
  plain.prepare();
  for (const PartCost& cost : plain.body(other).model.part_costs())
    EXPECT_EQ(cost.is_made, cost.part == ModelPart::solidity || cost.part == ModelPart::leaf_triangles);
}

}  // namespace
}  // namespace toccata
