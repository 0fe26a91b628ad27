#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "support/data.hpp"
#include "support/mesh_pairs.hpp"
#include "support/mesh_soups.hpp"
#include "toccata/generate/scenes.hpp"
#include "toccata/io/model_file.hpp"
#include "toccata/query/contacts.hpp"
#include "toccata/query/overlap.hpp"
#include "toccata/query/relation.hpp"

namespace toccata {
namespace {

double width_of(const Model& model) {
  const Aabb& box = model.wide_bvh().box;
  return box.upper.x - box.lower.x;
}

TEST(RealMeshes, TheBunnyAgainstItselfShifted) {
  const auto data = test::data_folder();
  if (!data) GTEST_SKIP() << "set TOCCATA_DATA to the folder of real models";
  const Model bunny(read_mesh(*data / "meshes/stanford-bunny.obj"));
  PairQuery query{.pose_b = Pose::translation(0.8 * width_of(bunny), 0, 0)};
  const auto found = contacts(bunny, bunny, query);
  EXPECT_FALSE(found.empty());
  EXPECT_TRUE(overlap(bunny, bunny, query));
  EXPECT_TRUE(test::same({*first_contact(bunny, bunny, query)}, {found.front()}));
  query.pose_b = Pose::translation(1.01 * width_of(bunny), 0, 0);
  EXPECT_FALSE(overlap(bunny, bunny, query));
}

/// Not star-shaped: a copy made smaller about the origin does not lie inside the bunny, but goes through its surface.
TEST(RealMeshes, TheBunnyIntersectsItsScaledCopy) {
  const auto data = test::data_folder();
  if (!data) GTEST_SKIP() << "set TOCCATA_DATA to the folder of real models";
  const Model bunny(read_mesh(*data / "meshes/stanford-bunny.obj"));
  for (const double factor : {0.999, 1.001}) {
    const PairQuery query{.pose_b = scaled(Pose{}, factor)};
    EXPECT_TRUE(overlap(bunny, bunny, query)) << factor;
    const auto crosses = [](const auto& contact) { return contact.intersection.crossing; };
    EXPECT_TRUE(std::ranges::any_of(contacts(bunny, bunny, query), crosses)) << factor;
  }
}

/// The second lecture's scene, told of this bunny. It is open, so a surface, and so is the wall with its hole.
TEST(RealMeshes, TheBunnyInTheHoleThatItLeavesInAWall) {
  const auto data = test::data_folder();
  if (!data) GTEST_SKIP() << "set TOCCATA_DATA to the folder of real models";
  const TriangleMesh bunny = read_mesh(*data / "meshes/stanford-bunny.obj");
  for (const double factor : {1.0, 0.999}) {
    const Scene scene = inside_negative_image(bunny, {.factor = factor, .margin = 0.01});
    const SceneObject &a = scene.objects[0], &b = scene.objects[1];
    const Relation found = relation(Model(a.mesh()), Model(b.mesh()), {a.pose, b.pose});
    EXPECT_EQ(found.kind, factor == 1 ? RelationKind::touching : RelationKind::crossing) << factor;
  }
}

/// Every pair of triangles of two real meshes, under poses that are not rigid.
TEST(RealMeshes, AsBruteForceUnderEveryKindOfPose) {
  const auto data = test::data_folder();
  if (!data) GTEST_SKIP() << "set TOCCATA_DATA to the folder of real models";
  const Model suzanne(read_mesh(*data / "meshes/suzanne.obj"));
  for (const std::string& family : test::pose_families()) {
    Random random(family.size());
    EXPECT_EQ(test::fault_of_surface_queries(suzanne, suzanne, test::random_poses(family, random)), "") << family;
  }
}

}  // namespace
}  // namespace toccata
