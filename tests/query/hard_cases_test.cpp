// METHODS B7, where an answer that is nearly right is wrong, under every kind of pose of the whole scene: the relation
// is known, and the surfaces are compared with every triangle against every triangle.
#include <gtest/gtest.h>

#include "query/meshes/posed_mesh.hpp"
#include "toccata/core/error.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/generate/scenes.hpp"
#include "toccata/query/contacts.hpp"
#include "toccata/query/overlap.hpp"
#include "toccata/query/relation.hpp"

namespace toccata {
namespace {

struct NamedPose {
  const char* name;
  Pose pose;
};

/// Whole numbers and powers of two, so that shared coordinates of aligned boxes stay equal in the world.
const std::vector<NamedPose> poses = {
    {"in place", {}},
    {"turned a quarter and moved", Pose::from_numbers({0, -1, 0, 1, 0, 0, 0, 0, 1, 4, -2, 8})},
    {"scaled", scaled(Pose::translation(1, 2, 3), 0.25)},
    {"sheared", Pose::from_numbers({1, 2, 0, 0, 1, 0, 1, 0, 1, 0, 0, 0})},
    {"stretched", Pose::from_numbers({4, 0, 0, 0, 1, 0, 0, 0, 0.5, 0, 0, 0})},
    {"mirrored", Pose::from_numbers({-1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0})},
    {"far away", Pose::translation(1 << 20, -(1 << 20), 1 << 20)},
    {"turned about an oblique axis",
     Pose::from_numbers({2. / 3, -1. / 3, 2. / 3, 2. / 3, 2. / 3, -1. / 3, -1. / 3, 2. / 3, 2. / 3, 0.1, 0.2, 0.3})},
};

struct PosedScene {
  Model a;
  Model b;
  PairQuery query;
};

PosedScene posed(const Scene& scene, const Pose& pose, Solid solid) {
  const SceneObject &a = scene.objects[0], &b = scene.objects[1];
  return {Model(a.mesh()), Model(b.mesh()), {pose * a.pose, pose * b.pose, solid, solid}};
}

Relation relation_of(const Scene& scene, const Pose& pose) {
  const PosedScene both = posed(scene, pose, Solid::automatic);
  const Relation answer = relation(both.a, both.b, both.query);
  const PairQuery exchanged{both.query.pose_b, both.query.pose_a};
  EXPECT_EQ(relation(both.b, both.a, exchanged).kind, answer.kind);
  EXPECT_EQ(overlap(both.a, both.b, both.query), answer.kind != RelationKind::apart);
  return answer;
}

bool any_two_triangles_meet(const PosedMesh& a, const PosedMesh& b) {
  std::vector<Triangle> others;
  for (Index j = 0; j < b.model().mesh().triangle_count(); ++j) others.push_back(b.triangle(j));
  for (Index i = 0; i < a.model().mesh().triangle_count(); ++i) {
    const Triangle t = a.triangle(i);
    for (const Triangle& other : others)
      if (overlap(t, other)) return true;
  }
  return false;
}

void expect_surfaces_like_brute_force(const Scene& scene, const Pose& pose) {
  const PosedScene both = posed(scene, pose, Solid::none);
  const PosedMesh a(both.a, both.query.pose_a, "a"), b(both.b, both.query.pose_b, "b");
  const bool meet = any_two_triangles_meet(a, b);
  EXPECT_EQ(overlap(both.a, both.b, both.query), meet);
  EXPECT_EQ(first_contact(both.a, both.b, both.query).has_value(), meet);
}

void PrintTo(const NamedPose& pose, std::ostream* out) { *out << pose.name; }

class HardCase : public testing::TestWithParam<NamedPose> {};

TEST_P(HardCase, HelicesAtAGap) {
  const Pose& pose = GetParam().pose;
  for (const double gap : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
    SCOPED_TRACE(gap);
    EXPECT_EQ(relation_of(interleaved_helices(gap), pose).kind, RelationKind::apart);
    EXPECT_EQ(relation_of(interleaved_helices(-gap), pose).kind, RelationKind::overlapping);
  }
  expect_surfaces_like_brute_force(interleaved_helices(1e-8), pose);
  expect_surfaces_like_brute_force(interleaved_helices(-1e-8), pose);
}

TEST_P(HardCase, MeshInsideItsNegativeImage) {
  const Relation answer = relation_of(inside_negative_image(1), GetParam().pose);
  EXPECT_EQ(answer.kind, RelationKind::touching);
  EXPECT_EQ(answer.containment, Containment::none);
}

TEST_P(HardCase, AShrunkMeshInItsMould) {
  const Scene scene = inside_negative_image(noise_sphere_mesh({1, 0.3, 2, 3}), {.factor = 0.999});
  EXPECT_EQ(relation_of(scene, GetParam().pose).kind, RelationKind::apart);
  expect_surfaces_like_brute_force(scene, GetParam().pose);
}

TEST_P(HardCase, BoxesAtAGap) {
  const Pose& pose = GetParam().pose;
  for (const double gap : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8})
    for (const int per_side : {1, 3}) {
      SCOPED_TRACE(gap);
      EXPECT_EQ(relation_of(fields_of_boxes(gap, per_side), pose).kind, RelationKind::apart);
      EXPECT_EQ(relation_of(fields_of_boxes(-gap, per_side), pose).kind, RelationKind::overlapping);
    }
  expect_surfaces_like_brute_force(fields_of_boxes(1e-8, 3), pose);
  expect_surfaces_like_brute_force(fields_of_boxes(-1e-8, 3), pose);
  EXPECT_THROW((void)boxes_face_to_face(1e17), Error);  // a box at such a place is flat
}

TEST_P(HardCase, ShellsScaledByAThousandth) {
  const Pose& pose = GetParam().pose;
  const Scene smaller = nested_shells(0.999, 2), larger = nested_shells(1.001, 2);
  EXPECT_EQ(relation_of(smaller, pose).kind, RelationKind::overlapping);
  EXPECT_EQ(relation_of(smaller, pose).containment, Containment::b_in_a);
  EXPECT_EQ(relation_of(larger, pose).containment, Containment::a_in_b);
  const PosedScene surfaces = posed(smaller, pose, Solid::none);
  EXPECT_EQ(relation(surfaces.a, surfaces.b, surfaces.query).kind, RelationKind::apart);
}

TEST_P(HardCase, AlignedBoxes) {
  // An oblique turn rounds the corners of two boxes in different ways; then only the clear cases have a known answer.
  const bool exact = std::string(GetParam().name) != "turned about an oblique axis";
  const Pose& pose = GetParam().pose;
  EXPECT_EQ(relation_of(boxes_sharing_half(), pose).kind, RelationKind::overlapping);
  expect_surfaces_like_brute_force(boxes_sharing_half(), pose);
  expect_surfaces_like_brute_force(boxes_face_to_face(), pose);
  if (!exact) return;
  EXPECT_EQ(relation_of(boxes_sharing_half(), pose).containment, Containment::none);
  EXPECT_EQ(relation_of(boxes_face_to_face(), pose).kind, RelationKind::touching);
  EXPECT_EQ(relation_of(equal_boxes(), pose).containment, Containment::equal);
}

INSTANTIATE_TEST_SUITE_P(Poses, HardCase, testing::ValuesIn(poses), [](const auto& tested) {
  std::string name = tested.param.name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
});

}  // namespace
}  // namespace toccata
