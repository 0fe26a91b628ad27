// The rational oracle against relations that can be counted on the grid.
#include <gtest/gtest.h>

#include "oracle/meshes.hpp"
#include "support/voxel_solids.hpp"

namespace toccata::oracle {
namespace {

using test::GridSheet;
using test::Skin;
using test::VoxelSolid;

void expect_same(const Relation& answer, const toccata::Relation& truth, const std::string& where) {
  EXPECT_EQ(static_cast<int>(answer.kind), static_cast<int>(truth.kind)) << where;
  EXPECT_EQ(static_cast<int>(answer.containment), static_cast<int>(truth.containment)) << where;
}

static_assert(static_cast<int>(RelationKind::crossing) == static_cast<int>(toccata::RelationKind::crossing));
static_assert(static_cast<int>(Containment::equal) == static_cast<int>(toccata::Containment::equal));

TEST(OracleVoxels, SolidsLieAsTheirVoxelsDo) {
  const std::uint64_t seed = 21;
  Random random(seed);
  for (int round = 0; round < 5; ++round) {
    const VoxelSolid a = test::random_voxels(random, 3, 2);
    const VoxelSolid b = test::random_voxels(random, 3, 2);
    const Skin skin = round % 3 == 0 ? Skin::every : round % 3 == 1 ? Skin::outer : Skin::inside_out;
    const Pose pose = test::random_integer_pose(random);
    const auto set_a = solid_set(mesh_of(a, skin, random), pose);
    const Relation answer = relation(set_a, solid_set(mesh_of(b, Skin::outer, random), pose));
    expect_same(answer, test::true_relation(a, b), "seed 21 round " + std::to_string(round));
  }
}

TEST(OracleVoxels, SheetsLieAsTheirSquaresDo) {
  const std::uint64_t seed = 22;
  Random random(seed);
  for (int round = 0; round < 10; ++round) {
    const GridSheet a = test::random_sheet(random, 2, 3);
    const VoxelSolid b = test::random_voxels(random, 12, 3);
    const auto set_a = surface_set(mesh_of(a, random), {});
    const Relation answer = relation(set_a, solid_set(mesh_of(b, Skin::outer, random), {}));
    expect_same(answer, test::true_relation(a, b), "seed 22 round " + std::to_string(round));
  }
}

}  // namespace
}  // namespace toccata::oracle
