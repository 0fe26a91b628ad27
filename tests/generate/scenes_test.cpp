#include "toccata/generate/scenes.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "toccata/core/error.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/query/contacts.hpp"
#include "toccata/shapes/mesh_health.hpp"

namespace toccata {
namespace {

/// "a | b" → relation, for every pair that is not apart.
std::map<std::string, Relation> relations_of(const Scene& scene) {
  const std::vector<SceneInstance> models = scene_models(scene, 1);
  std::map<std::string, Relation> relations;
  for (const PairAnswer& pair : check_all(models, {.contacts = false, .threads = 1}).pairs)
    relations[models[pair.a].name + " | " + models[pair.b].name] = pair.relation;
  return relations;
}

std::map<std::string, RelationKind> kinds_of(const Scene& scene) {
  std::map<std::string, RelationKind> kinds;
  for (const auto& [pair, relation] : relations_of(scene)) kinds[pair] = relation.kind;
  return kinds;
}

using Kinds = std::map<std::string, RelationKind>;

Relation only_relation(const Scene& scene) {
  const auto relations = relations_of(scene);
  EXPECT_LE(relations.size(), 1U);
  return relations.empty() ? Relation{} : relations.begin()->second;
}

const std::vector<Placement> placements = {{1, 0}, {1, 1e6}, {1e-6, 0}, {1e6, 0}};

TEST(HardScenes, HelicesAreApartForAGapAndOverlapWithoutOne) {
  for (const double gap : {1e-3, 1e-5, 1e-8})
    for (const Placement& placement : placements) {
      SCOPED_TRACE(testing::Message() << gap << " scale " << placement.scale << " offset " << placement.offset);
      EXPECT_EQ(only_relation(interleaved_helices(gap, placement)).kind, RelationKind::apart);
      EXPECT_EQ(only_relation(interleaved_helices(-gap, placement)).kind, RelationKind::overlapping);
    }
}

TEST(HardScenes, NegativeImageTouchesAllOver) {
  for (const Placement& placement : placements)
    EXPECT_EQ(only_relation(inside_negative_image(1, placement)).kind, RelationKind::touching);
}

TEST(HardScenes, AShrunkMeshIsApartFromItsMouldAndAGrownOneIsNot) {
  const TriangleMesh ball = noise_sphere_mesh({1, 0.3, 2, 5});
  for (const Placement& placement : placements) {
    SCOPED_TRACE(testing::Message() << "scale " << placement.scale << " offset " << placement.offset);
    EXPECT_EQ(only_relation(inside_negative_image(ball, {}, placement)).kind, RelationKind::touching);
    EXPECT_EQ(only_relation(inside_negative_image(ball, {.factor = 0.999}, placement)).kind, RelationKind::apart);
    EXPECT_EQ(only_relation(inside_negative_image(ball, {.factor = 1.001}, placement)).kind, RelationKind::overlapping);
  }
  EXPECT_THROW((void)inside_negative_image(ball, {.factor = 0}), Error);
  EXPECT_THROW((void)inside_negative_image(ball, {.margin = -1}), Error);
}

/// A ball that lies elsewhere is star-shaped about another point than the origin.
TEST(HardScenes, AMeshShrinksAboutThePointThatIsTold) {
  std::vector<Vec3> vertices;
  const TriangleMesh ball = noise_sphere_mesh({1, 0.3, 2, 5});
  for (const Vec3& v : ball.vertices()) vertices.push_back(v + Vec3{8, 0, 0});
  const TriangleMesh moved(std::move(vertices), {ball.triangles().begin(), ball.triangles().end()});
  const auto kind = [&](const Vec3& about) {
    return only_relation(inside_negative_image(moved, {.factor = 0.999, .about = about})).kind;
  };
  EXPECT_EQ(kind({8, 0, 0}), RelationKind::apart);
  EXPECT_EQ(kind({0, 0, 0}), RelationKind::overlapping);
}

/// Neither convex nor star-shaped, as the bunny: the shrunk tube of a ring leaves its hole on the inner side.
TEST(HardScenes, AShrunkRingCutsItsMould) {
  const TriangleMesh ring = torus_mesh({1, 0.25, 24, 8});
  EXPECT_EQ(only_relation(inside_negative_image(ring)).kind, RelationKind::touching);
  EXPECT_EQ(only_relation(inside_negative_image(ring, {.factor = 0.999})).kind, RelationKind::overlapping);
}

TEST(HardScenes, ShellsAreNested) {
  for (const Placement& placement : placements) {
    const Relation smaller = only_relation(nested_shells(0.999, 2, placement));
    EXPECT_EQ(smaller.kind, RelationKind::overlapping);
    EXPECT_EQ(smaller.containment, Containment::b_in_a);
    EXPECT_EQ(only_relation(nested_shells(1.001, 2, placement)).containment, Containment::a_in_b);
  }
}

TEST(HardScenes, AlignedBoxes) {
  for (const Placement& placement : placements) {
    EXPECT_EQ(only_relation(boxes_face_to_face(0, placement)).kind, RelationKind::touching);
    EXPECT_EQ(only_relation(boxes_sharing_half(placement)).kind, RelationKind::overlapping);
    EXPECT_EQ(only_relation(equal_boxes(placement)).containment, Containment::equal);
  }
}

TEST(HardScenes, BoxesAreApartForAGapAndOverlapWithoutOne) {
  for (const double gap : {1e-3, 1e-5, 1e-8})
    for (const Placement& placement : placements)
      for (const int per_side : {1, 3}) {
        SCOPED_TRACE(testing::Message() << gap << " scale " << placement.scale << " offset " << placement.offset);
        EXPECT_EQ(only_relation(fields_of_boxes(gap, per_side, placement)).kind, RelationKind::apart);
        EXPECT_EQ(only_relation(fields_of_boxes(0, per_side, placement)).kind, RelationKind::touching);
        EXPECT_EQ(only_relation(fields_of_boxes(-gap, per_side, placement)).kind, RelationKind::overlapping);
      }
  EXPECT_THROW((void)boxes_face_to_face(-1.5), Error);
  EXPECT_THROW((void)fields_of_boxes(1e-3, 0), Error);
}

TEST(HardScenes, EveryBoxOfAFieldFacesOneOfTheOther) {
  const Scene scene = fields_of_boxes(-1e-6, 3);
  const Model left(scene.objects[0].mesh()), right(scene.objects[1].mesh());
  std::set<std::pair<Index, Index>> boxes;
  for (const auto& contact : contacts(left, right)) boxes.insert({contact.element_a / 12, contact.element_b / 12});
  EXPECT_EQ(boxes, (std::set<std::pair<Index, Index>>{
                       {0, 0}, {1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 5}, {6, 6}, {7, 7}, {8, 8}}));
  EXPECT_EQ(scene.objects[0].mesh()->face_count(), 54U);
}

TEST(DemoScenes, Gears) {
  EXPECT_EQ(kinds_of(gear_train()), (Kinds{{"driving gear | misassembled gear", RelationKind::overlapping}}));
}

TEST(DemoScenes, Robot) {
  EXPECT_EQ(kinds_of(robot_arm()), (Kinds{{"table | base", RelationKind::touching},
                                          {"table | gripper", RelationKind::overlapping},
                                          {"table | workpiece", RelationKind::touching}}));
}

TEST(DemoScenes, Shelf) {
  const auto relations = relations_of(shelf_of_parts());
  EXPECT_EQ(kinds_of(shelf_of_parts()), (Kinds{{"board 3 | standing block", RelationKind::touching},
                                               {"crate | ball in the crate", RelationKind::overlapping},
                                               {"roller 34 | slipped part", RelationKind::overlapping}}));
  EXPECT_EQ(relations.at("crate | ball in the crate").containment, Containment::b_in_a);
  EXPECT_EQ(relations.at("roller 34 | slipped part").containment, Containment::none);
}

TEST(DemoScenes, Knot) {
  EXPECT_EQ(kinds_of(knot_through_ring()), (Kinds{{"torus knot | cutting ring", RelationKind::overlapping}}));
}

TEST(Scenes, NamesAreUniqueAndSolidsClosed) {
  std::vector<Scene> scenes = {many_parts(200, 3)};
  for (const NamedScene& named : demo_scenes()) scenes.push_back(demo_scene(named.name));
  for (const Scene& scene : scenes) {
    std::set<std::string> names;
    for (const SceneObject& object : scene.objects) {
      EXPECT_TRUE(names.insert(object.name).second) << object.name;
      EXPECT_TRUE(is_closed(*object.mesh())) << object.name;
      EXPECT_TRUE(is_finite(object.pose)) << object.name;
    }
  }
  EXPECT_THROW((void)demo_scene("gear"), Error);
}

TEST(Scenes, OfManyShareFewMeshesAndCollideInPart) {
  const Scene scene = many_parts(500, 1);
  std::set<const TriangleMesh*> meshes;
  for (const SceneObject& object : scene.objects) meshes.insert(object.mesh().get());
  EXPECT_EQ(scene.objects.size(), 500U);
  EXPECT_EQ(meshes.size(), 8U);
  const std::size_t pairs = relations_of(scene).size();
  EXPECT_GT(pairs, 15U);
  EXPECT_LT(pairs, 1500U);
}

}  // namespace
}  // namespace toccata
