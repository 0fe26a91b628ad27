#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "toccata/core/error.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/query/casts.hpp"
#include "toccata/query/contacts.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/query/relation.hpp"
#include "toccata/query/self_contacts.hpp"
#include "toccata/shapes/primitives.hpp"
#include "trees/leaf_triangles.hpp"

namespace toccata {
namespace {

std::vector<Vec3> bent(const TriangleMesh& mesh, double by) {
  std::vector<Vec3> vertices(mesh.vertices().begin(), mesh.vertices().end());
  for (Vec3& v : vertices) v = {v.x + by * v.y * v.y, v.y, v.z + by * v.x};
  return vertices;
}

using Pairs = std::vector<std::pair<Index, Index>>;

Pairs pairs_of(const std::vector<Contact>& contacts) {
  Pairs pairs;
  for (const Contact& contact : contacts) pairs.emplace_back(contact.element_a, contact.element_b);
  return pairs;
}

/// Whatever the trees, the answers are those of a model that was built from the mesh as it is.
void expect_answers_as_built(const Model& deformed) {
  const Model built(deformed.mesh());
  const Model other(generate_mesh("torus"));
  PairQuery query;
  query.pose_b.offset = {0.7, 0.1, 0.2};
  EXPECT_EQ(pairs_of(contacts(deformed, other, query)), pairs_of(contacts(built, other, query)));
  EXPECT_EQ(pairs_of(self_contacts(deformed)), pairs_of(self_contacts(built)));
  query.pose_b.offset = {9, 1, 2};
  EXPECT_EQ(distance(deformed, other, query), distance(built, other, query));
  EXPECT_EQ(cast_ray({-9, 0.1, 0.2}, {20, 0, 0}, deformed), cast_ray({-9, 0.1, 0.2}, {20, 0, 0}, built));
  EXPECT_EQ(relation(deformed, Box({5, 5, 5})).kind, relation(built, Box({5, 5, 5})).kind);
}

TEST(Deform, AnswersAreThoseOfTheMeshAsItIs) {
  const TriangleMesh mesh = generate_mesh("noise-sphere");
  Model model(mesh);
  for (const double by : {0.01, 4.0, 0.0}) {
    static_cast<void>(model.deform(bent(mesh, by)));
    expect_answers_as_built(model);
  }
}

TEST(Deform, OtherCopiesStayAsTheyAre) {
  const TriangleMesh mesh = generate_mesh("noise-sphere");
  Model model(mesh);
  const Model copy = model;
  static_cast<void>(model.deform(bent(mesh, 1)));
  EXPECT_EQ(copy.mesh().vertices()[5], mesh.vertices()[5]);
  EXPECT_NE(model.mesh().vertices()[5], mesh.vertices()[5]);
  expect_answers_as_built(model);
  expect_answers_as_built(copy);
}

TEST(Deform, WhatIsFoundOnDemandIsFoundAgain) {
  const TriangleMesh mesh = box_mesh({1, 1, 1});
  Model model(mesh);
  EXPECT_TRUE(model.closed());
  EXPECT_NEAR(distance(model, Point({3, 0, 0})).upper, 2, 1e-11);
  std::vector<Vec3> twice;
  for (const Vec3& v : mesh.vertices()) twice.push_back(2.0 * v);
  static_cast<void>(model.deform(twice));
  EXPECT_NEAR(distance(model, Point({3, 0, 0})).upper, 1, 1e-11);
  EXPECT_EQ(model.oriented_boxes().size(), model.wide_bvh().blocks.size());
}

TEST(Deform, TrianglesAtTheLeavesAreThoseOfTheMovedMesh) {
  Model model(generate_mesh("noise-sphere"));
  EXPECT_EQ(model.leaf_triangles_for(1), nullptr) << "one question is not worth it";
  EXPECT_EQ(model.leaf_triangles_for(100'000), &model.leaf_triangles());
  EXPECT_EQ(model.leaf_triangles_for(1), &model.leaf_triangles());
  static_cast<void>(model.deform(bent(model.mesh(), 0.1)));
  EXPECT_EQ(model.leaf_triangles_for(1), nullptr);
  const LeafTriangles built = leaf_triangles(model.wide_bvh(), model.mesh());
  ASSERT_EQ(model.leaf_triangles().of_block.size(), built.of_block.size());
  for (std::size_t i = 0; i < built.of_block.size(); ++i)
    ASSERT_EQ(model.leaf_triangles().of_block[i].corner, built.of_block[i].corner) << i;
}

TEST(Deform, WhatHasGrownTooMuchIsBuiltAnew) {
  const TriangleMesh mesh = generate_mesh("noise-sphere");
  Model model(mesh);
  std::vector<Vec3> scattered;
  for (std::size_t i = 0; i < mesh.vertices().size(); ++i)
    scattered.push_back(mesh.vertices()[(i * 7919) % mesh.vertices().size()]);
  EXPECT_TRUE(model.deform(scattered).should_rebuild());
  EXPECT_NEAR(model.deform(scattered).growth, 1, 1e-5);
}

TEST(Deform, BadInputIsRefusedAndChangesNothing) {
  Model model(box_mesh({1, 1, 1}));
  EXPECT_THROW(static_cast<void>(model.deform({{0, 0, 0}})), Error);
  std::vector<Vec3> vertices(model.mesh().vertices().begin(), model.mesh().vertices().end());
  vertices[3].y = std::numeric_limits<double>::quiet_NaN();
  try {
    static_cast<void>(model.deform(vertices));
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("vertex 3"), std::string::npos) << error.what();
  }
  expect_answers_as_built(model);
  Model box = Box({1, 1, 1});
  EXPECT_THROW(static_cast<void>(box.deform({})), Error);
}

}  // namespace
}  // namespace toccata
