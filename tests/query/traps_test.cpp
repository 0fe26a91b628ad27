// Traps of mesh queries that other tests do not spring; docs/design/traps.md lists all.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "oracle/meshes.hpp"
#include "query/meshes/posed_mesh.hpp"
#include "support/mesh_soups.hpp"
#include "support/self_meshes.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/query/relation.hpp"
#include "toccata/query/self_contacts.hpp"

namespace toccata {
namespace {

bool same_bits(const Vec3& p, const Vec3& q) {
  using Bits = std::array<std::uint64_t, 3>;
  return std::bit_cast<Bits>(p) == std::bit_cast<Bits>(q);
}

/// World vertices computed with another association, or fused, or in another frame, differ in the last bits; then
/// neighbours no longer share their vertices.
TEST(Traps, WorldVerticesAreTheSameBitsWhoeverComputesThem) {
  for (const std::string& family : test::pose_families()) {
    Random random(family.size());
    const Pose pose = test::random_poses(family, random).pose_a;
    const Model model(test::random_soup(random, 200, 0.3, 0));
    const PosedMesh posed(model, pose);
    const std::vector<Vec3> together = transform(pose, model.mesh().vertices());
    for (Index i = 0; i < together.size(); ++i) {
      const Vec3 local = model.mesh().vertices()[i];
      EXPECT_TRUE(same_bits(together[i], transform(pose, local))) << family;
      EXPECT_TRUE(same_bits(together[i], posed.vertices()[i])) << family;
      EXPECT_TRUE(same_bits(together[i], oracle::world_vertex(pose, local))) << family;
    }
    for (Index i = 0; i < model.mesh().triangle_count(); ++i)
      EXPECT_EQ(world_triangle(model, pose, i).vertex, posed.triangle(i).vertex) << family;
  }
}

TEST(Traps, NeighboursShareTheirVerticesUnderEveryPose) {
  const TriangleMesh ball = icosphere_mesh(1, 2), soup = test::unwelded(ball);
  for (const std::string& family : test::pose_families()) {
    Random random(3 * family.size());
    const Pose pose = test::random_poses(family, random).pose_a;
    const auto welded = self_contacts(Model(ball), pose), alone = self_contacts(Model(soup), pose);
    EXPECT_EQ(welded.size(), alone.size()) << family;
    EXPECT_TRUE(alone.empty() || family == "singular") << family;
  }
}

/// Places a ball of radius 0.35 so far away that its vertices fall on a grid of 1/2: many triangles have area in the
/// file and none in the world.
PairQuery far_away(std::uint64_t seed) {
  Random random(seed);
  const Vec3 centre{3e15, -3e15, 3e15 + static_cast<double>(random.below(100))};
  const Vec3 aside{0.5 * static_cast<double>(random.below(4)), 0.5 * static_cast<double>(random.below(3)), 0};
  return {.pose_a = {test::random_rotation(random), centre}, .pose_b = {test::random_rotation(random), centre + aside}};
}

TEST(Traps, TrianglesThatLoseTheirAreaInTheWorld) {
  const Model ball(icosphere_mesh(0.35, 0));
  int touching = 0, without_area = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    const PairQuery query = far_away(seed);
    const auto set_a = oracle::surface_set(ball.mesh(), query.pose_a),
               set_b = oracle::surface_set(ball.mesh(), query.pose_b);
    for (const auto& triangle : set_a.triangles) without_area += oracle::dimension(triangle) < 2 ? 1 : 0;
    std::vector<oracle::TrianglePair> found;
    for (const Contact& contact : contacts(ball, ball, query)) found.push_back({contact.element_a, contact.element_b});
    EXPECT_EQ(found, oracle::intersecting_pairs(set_a, set_b));
    touching += found.empty() ? 0 : 1;
    const oracle::Relation expected =
        oracle::relation(oracle::solid_set(ball.mesh(), query.pose_a), oracle::solid_set(ball.mesh(), query.pose_b));
    const Relation answer = relation(ball, ball, query);
    EXPECT_EQ(static_cast<int>(answer.kind), static_cast<int>(expected.kind));
    EXPECT_EQ(static_cast<int>(answer.containment), static_cast<int>(expected.containment));
  }
  EXPECT_GT(touching, 6);
  EXPECT_GT(without_area, 5);
}

}  // namespace
}  // namespace toccata
